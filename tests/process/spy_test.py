#!/usr/bin/python3
"""lcm-spy with our views on a screen that nobody sees (Xvfb), fed by the real processes.

    tests/process/private_bus tests/process/spy_test.py --bin build/release/bin --source .

Each view is opened as a user does, by a double click on its channel. What it draws is counted in
pixels of its colours, outside its legend; the same counts of messages in which there is nothing to
draw have to come out empty. The screenshots stay in --out, for people.
"""

import argparse
import collections
import os
import pathlib
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import unittest

from live_processes import COMPONENTS, ENVIRONMENT, Processes, wait_for

SKIPPED = 77  # exit code, for ctest
GROUP, PORT = "239.255.76.67", 7667  # LCM's own bus
CHANNELS = {"COMBINED_MAP", "CURRENT_MAP", "ENTRANCE", "GLOBAL_MAP", "IDENTIFIED_MAP", "LOCAL_MAP",
            "PICO_LASER", "PICO_ODOMETRY", "POSITION", "PROXIMITY", "SIM_TRUTH", "SIM_WORLD",
            "WORLD_POSITION", "STATUS_BRIDGE"} | {f"STATUS_{name.upper()}" for name in COMPONENTS}

# Our own screen: lcm-spy's table on the left, the newest view on the right.
SCREEN = (1600, 700)
VIEW_AT = (805, 0)
FIRST_ROW, ROW_HEIGHT = 27, 16  # [px] the middle of the table's first row, the height of each
DRAWING = (8, 32, 540, 560)  # x, y, width, height in a view: without frame, legend, status line
STATUS_LINE = (8, 596, 740, 20)
CLOSE_BUTTON = (744, 14)  # of the frame in the view's window

BLACK, ORANGE, GREEN = (0x00, 0x00, 0x00), (0xE6, 0x9F, 0x00), (0x00, 0x9E, 0x73)
BLUE, VERMILION, WHITE = (0x00, 0x72, 0xB2), (0xD5, 0x5E, 0x00), (0xFF, 0xFF, 0xFF)

# What makes a view more than a frame: so many pixels of a colour.
LASER = {BLUE: 500}
WALLS = {BLACK: 900}
INPUT_OK = {GREEN: 15}
INPUT_WAITING = {ORANGE: 15}


class Bus:
    """The newest message of each channel; and messages of our own, sent again and again."""

    PERIOD = 0.2  # [s]
    MAGIC = b"LC02"  # of a message that fits one datagram: LC02, a number, channel, 0, data

    def __init__(self):
        self.newest = {}
        self.sent = {}
        self.stopped = threading.Event()
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.bind((GROUP, PORT))
        member = socket.inet_aton(GROUP) + socket.inet_aton("0.0.0.0")
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
        self.socket.settimeout(self.PERIOD)
        self.threads = [threading.Thread(target=work) for work in (self.listen, self.send)]
        for thread in self.threads:
            thread.start()

    def listen(self):
        while not self.stopped.is_set():
            try:
                datagram = self.socket.recv(65536)
            except TimeoutError:
                continue
            channel, _, data = datagram[8:].partition(b"\0")
            if datagram.startswith(self.MAGIC):
                self.newest[channel.decode()] = data

    def send(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            number = 0
            while not self.stopped.wait(self.PERIOD):
                for channel, data in list(self.sent.items()):
                    number += 1
                    head = self.MAGIC + struct.pack(">I", number) + channel.encode() + b"\0"
                    sender.sendto(head + data, (GROUP, PORT))

    def close(self):
        self.stopped.set()
        for thread in self.threads:
            thread.join()
        self.socket.close()


def without_returns(laser_scan):
    """laser_scan_t whose ranges are all 0: fingerprint, 3 int64, 10 doubles, num_ranges, ranges."""
    counted = 8 + 3 * 8 + 10 * 8
    (beams,) = struct.unpack_from(">i", laser_scan, counted)
    first = counted + 4
    return laser_scan[:first] + bytes(4 * beams) + laser_scan[first + 4 * beams:]


def without_objects(map_message):
    """map_t without points and objects: fingerprint, 3 int64, frame, what is of fixed size."""
    frame = 8 + 3 * 8
    (length,) = struct.unpack_from(">i", map_message, frame)
    fixed = 8 + 4 + 4 + 8 + 3 * 24 + 9 * 8 + 1 + 8
    return map_message[:frame + 4 + length + fixed] + bytes(8)


def waiting_for(channel, status):
    """status_t whose input `channel` is not OK (1), but WAITING (0)."""
    name = channel.encode() + b"\0"
    assert name + b"\1" in status, f"{channel} is no input that is ok"
    return status.replace(name + b"\1", name + b"\0")


def channels_in(log):
    """Of the events that are there as a whole: magic, number, utime, two lengths, channel, data."""
    head = struct.Struct(">IqqII")
    content = log.read_bytes() if log.exists() else b""
    found, place = set(), 0
    while place + head.size <= len(content):
        _, _, _, name_length, data_length = head.unpack_from(content, place)
        name, place = place + head.size, place + head.size + name_length + data_length
        if place <= len(content):
            found.add(content[name:name + name_length].decode())
    return found


class Screen:
    """An X server of our own, and what a user does there."""

    def __init__(self, processes):
        size = "x".join(map(str, SCREEN)) + "x24"
        display, write_end = os.pipe()
        processes.start(["Xvfb", "-displayfd", write_end, "-screen", "0", size, "-nolisten", "tcp"],
                        pass_fds=[write_end])
        os.close(write_end)
        with open(display, encoding="ascii") as reader:
            self.environment = {"DISPLAY": ":" + reader.readline().strip()}

    def run(self, *command):
        return subprocess.run(list(map(str, command)), env={**ENVIRONMENT, **self.environment},
                              capture_output=True, text=True, check=False).stdout

    def windows(self):
        """The windows that can be seen, by name."""
        found = ["xdotool", "search", "--onlyvisible", "--name", "."]
        names = self.run(*found, "getwindowname", "%@").splitlines()
        return dict(zip(names, self.run(*found).split()))

    def click(self, x, y, times=1):
        self.run("xdotool", "mousemove", x, y, "click", "--repeat", times, "--delay", 60, 1)

    def place(self, window, x, y):
        self.run("xdotool", "windowmove", window, x, y, "windowraise", window)

    def shoot(self, file):
        self.run("import", "-window", "root", file)


class Picture:
    """How many pixels of each colour a screenshot has in a part (x, y, width, height)."""

    def __init__(self, file, part, inside=VIEW_AT):
        x, y, width, height = part
        crop = f"{width}x{height}+{inside[0] + x}+{inside[1] + y}"
        pixels = subprocess.run(["convert", file, "-crop", crop, "-depth", "8", "rgb:-"],
                                capture_output=True, check=True).stdout
        self.counts = collections.Counter(zip(pixels[0::3], pixels[1::3], pixels[2::3]))

    def misses(self, least):
        """The colours of which there are fewer pixels than that; "" where all are there."""
        return ", ".join(f"#{bytes(colour).hex()}: {self.counts[colour]} of {count} pixels"
                         for colour, count in least.items() if self.counts[colour] < count)


class Spy:
    """lcm-spy on a screen, with a table of `channels` and one view at a time."""

    def __init__(self, processes, screen, channels, options=()):
        self.screen = screen
        self.rows = sorted(channels)
        self.view = None
        self.process = processes.start([SETTING.pico_spy, *options], screen.environment)
        wait_for(lambda: "LCM Spy" in screen.windows(), 20, "lcm-spy's window")
        wait_for(lambda: self.has_row(len(self.rows) - 1), 10, "all channels in the table")
        assert not self.has_row(len(self.rows)), "a channel that nobody sends"

    def has_row(self, row):
        """Cells are white, what lies below the last one is grey."""
        file = SETTING.out / "table.png"
        self.screen.shoot(file)
        cell = Picture(file, (300, FIRST_ROW + ROW_HEIGHT * row, 10, 1), inside=(0, 0))
        return cell.counts[WHITE] == 10

    def open(self, channel):
        middle = FIRST_ROW + ROW_HEIGHT * self.rows.index(channel)

        def opened():
            self.screen.click(100, middle, times=2)
            try:
                return wait_for(lambda: self.screen.windows().get(channel), 3, "a view")
            except AssertionError:
                return None  # the table was just being refreshed, and a click went astray

        self.view = wait_for(opened, 10, f"{channel}'s view")

    def shoot(self, file):
        """Java may have moved the window since it was opened."""
        self.screen.place(self.view, *VIEW_AT)
        self.screen.shoot(file)

    def close(self):
        self.screen.place(self.view, *VIEW_AT)
        self.screen.click(VIEW_AT[0] + CLOSE_BUTTON[0], VIEW_AT[1] + CLOSE_BUTTON[1])
        wait_for(lambda: self.view not in self.screen.windows().values(), 5, "the window's end")


class Setting:
    """What all tests share: the bus with the processes on it, the screen, where things are."""

    def __init__(self, given):
        self.source = given.source.resolve()
        self.bin = given.bin.absolute()
        self.out = given.out or pathlib.Path(tempfile.mkdtemp(prefix="spy_test-"))
        self.out.mkdir(parents=True, exist_ok=True)
        self.pico_spy = self.install()
        self.processes = Processes(self.out)
        self.bus = None
        self.screen = None

    def install(self):
        """As `cmake --install` lays it out, with the jars of the build under test."""
        prefix = self.out / "installed"
        shutil.rmtree(prefix, ignore_errors=True)
        java = prefix / "share/perceptor/java"
        java.mkdir(parents=True)
        (prefix / "bin").mkdir()
        for jar in ("lcmtypes/pico-types.jar", "tools/spy_views/pico-spy-views.jar"):
            if (self.bin.parent / jar).exists():
                shutil.copy(self.bin.parent / jar, java)
        return shutil.copy(self.source / "tools/spy", prefix / "bin/pico-spy")

    def why_not(self):
        """What this machine lacks for the test; None where nothing does."""
        for program in ("Xvfb", "xdotool", "import", "convert", "lcm-logger"):
            if not shutil.which(program):
                return f"no {program}"
        said = run_spy(self.pico_spy).stderr
        return None if "no display" in said else said

    def start(self):
        self.screen = Screen(self.processes)
        self.bus = Bus()
        self.processes.start_components(self.bin)
        self.processes.start([self.bin / "pico-bridge"])
        newest = self.bus.newest
        wait_for(lambda: CHANNELS <= newest.keys(), 20, "a message on each channel")
        wait_for(lambda: b"CURRENT_MAP\0\1" in newest["STATUS_MERGE"], 10, "pico-merge's maps")
        self.bus.sent.update({
            "BLANK_LASER": without_returns(newest["PICO_LASER"]),
            "BLANK_MAP": without_objects(newest["LOCAL_MAP"]),
            "BROKEN_LASER": newest["PICO_LASER"][:-10],
            "STATUS_WAITING": waiting_for("CURRENT_MAP", newest["STATUS_MERGE"])})

    def stop(self):
        self.processes.stop_all()
        if self.bus:
            self.bus.close()


def run_spy(program, *options):
    return subprocess.run([program, *options], env=ENVIRONMENT, capture_output=True, text=True,
                          timeout=20, check=False)


def setUpModule():
    unittest.addModuleCleanup(SETTING.stop)
    SETTING.start()


class Command(unittest.TestCase):
    """tools/spy before it starts Java."""

    def test_help_is_the_header(self):
        helped = run_spy(SETTING.source / "tools/spy", "--help")
        self.assertEqual(helped.returncode, 0)
        for word in ("tools/spy", "--log FILE", "--lcm-url URL", "LCM_DEFAULT_URL"):
            self.assertIn(word, helped.stdout)
        self.assertNotIn("#", helped.stdout)

    def refuses(self, reason, *options, program=None):
        refused = run_spy(program or SETTING.pico_spy, *options)
        self.assertEqual(refused.returncode, 2)
        self.assertIn(reason, refused.stderr)

    def test_refuses_what_it_cannot_do(self):
        self.refuses("unknown option --nonsense", "--nonsense")
        self.refuses("--log needs a value", "--log")
        self.refuses("cannot read /no/such.lcmlog", "--log", "/no/such.lcmlog")
        self.refuses("exclude each other", "--log", __file__, "--lcm-url", "udpm://")
        self.refuses("no route for multicast", "-n", SETTING.pico_spy, program="unshare")
        self.refuses("no display")

    def test_names_the_missing_jar(self):
        prefix = SETTING.out / "without_jars"
        (prefix / "share/perceptor/java").mkdir(parents=True, exist_ok=True)
        (prefix / "bin").mkdir(exist_ok=True)
        program = shutil.copy(SETTING.source / "tools/spy", prefix / "bin/pico-spy")
        self.refuses("pico-types.jar", program=program)


class ViewTest(unittest.TestCase):
    """Opens views of self.spy."""

    spy = None

    def shows(self, channel, least, part=DRAWING, picture_of=""):
        """Waits for so many pixels of each colour, and leaves the screenshot."""
        file = SETTING.out / f"{self.id().split('.')[-1][5:]}{picture_of}.png"

        def misses():
            self.spy.shoot(file)
            return Picture(file, part).misses(least)

        try:
            wait_for(lambda: not misses(), 10, "the colours")
        except AssertionError:
            self.fail(f"{channel}: {misses()}; see {file}")
        return file

    def open(self, channel):
        self.spy.open(channel)
        self.addCleanup(self.spy.close)


class LiveViews(ViewTest):
    @classmethod
    def setUpClass(cls):
        cls.spy = Spy(SETTING.processes, SETTING.screen, CHANNELS | SETTING.bus.sent.keys())

    @classmethod
    def tearDownClass(cls):
        SETTING.processes.stop(cls.spy.process)

    def tearDown(self):
        self.assertIsNone(self.spy.process.poll(), "lcm-spy has ended")
        said = SETTING.processes.said_by("pico-spy").read_text()
        self.assertEqual([line for line in said.splitlines() if "Exception" in line], [])

    def test_laser(self):
        self.open("PICO_LASER")
        self.shows("PICO_LASER", LASER)

    def test_laser_without_returns_is_blank(self):
        self.open("BLANK_LASER")
        shot = self.shows("BLANK_LASER", {VERMILION: 20})  # where the laser is
        self.assertTrue(Picture(shot, DRAWING).misses(LASER))

    def test_broken_messages_are_told_and_good_ones_shown(self):
        self.open("BROKEN_LASER")
        shot = self.shows("BROKEN_LASER", {VERMILION: 200}, part=STATUS_LINE)
        self.assertTrue(Picture(shot, DRAWING).misses(LASER))
        SETTING.bus.sent["BROKEN_LASER"] = SETTING.bus.newest["PICO_LASER"]
        self.shows("BROKEN_LASER", LASER, picture_of="_good")

    def test_map_of_one_scan(self):
        self.open("CURRENT_MAP")
        self.shows("CURRENT_MAP", WALLS)

    def test_map_around_the_robot(self):
        self.open("IDENTIFIED_MAP")
        self.shows("IDENTIFIED_MAP", {**WALLS, VERMILION: 100, BLUE: 50, ORANGE: 25})

    def test_map_of_the_building(self):
        self.open("GLOBAL_MAP")
        self.shows("GLOBAL_MAP", {**WALLS, VERMILION: 500, BLUE: 500, GREEN: 500})

    def test_map_without_objects_is_blank(self):
        self.open("BLANK_MAP")
        shot = self.shows("BLANK_MAP", {BLACK: 50})  # the robot and the scale bar
        self.assertTrue(Picture(shot, DRAWING).misses(WALLS))

    def test_proximity(self):
        self.open("PROXIMITY")
        self.shows("PROXIMITY", {ORANGE: 500, BLUE: 250})  # blind behind; the radius

    def test_status(self):
        self.open("STATUS_MERGE")
        shot = self.shows("STATUS_MERGE", INPUT_OK)
        self.assertTrue(Picture(shot, DRAWING).misses(INPUT_WAITING))

    def test_status_of_a_waiting_input(self):
        self.open("STATUS_WAITING")
        shot = self.shows("STATUS_WAITING", INPUT_WAITING)
        self.assertTrue(Picture(shot, DRAWING).misses(INPUT_OK))

    def test_trail(self):
        self.open("POSITION")
        self.shows("POSITION", {BLUE: 50})

    def test_trail_in_the_building(self):
        self.open("WORLD_POSITION")
        self.shows("WORLD_POSITION", {BLUE: 50})


class LogViews(ViewTest):
    def test_log(self):
        log = SETTING.out / "drive.lcmlog"
        logger = SETTING.processes.start(
            ["lcm-logger", "-q", "-f", "-v", "-c", "LCM_SELF_TEST", log])
        channels = CHANNELS | SETTING.bus.sent.keys()
        wait_for(lambda: channels <= channels_in(log), 10, "an event of each channel in the log")
        SETTING.processes.stop(logger)

        self.spy = Spy(SETTING.processes, SETTING.screen, channels, ["--log", log])
        self.open("PICO_LASER")
        self.shows("PICO_LASER", LASER)
        self.doCleanups()
        self.assertEqual(SETTING.processes.stop(self.spy.process), 128 + signal.SIGINT)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of the programs")
    parser.add_argument("--source", type=pathlib.Path, required=True, help="folder of the sources")
    parser.add_argument("--out", type=pathlib.Path, help="where the screenshots stay")
    options, rest = parser.parse_known_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # children can be interrupted
    SETTING = Setting(options)
    lack = SETTING.why_not()
    if lack:
        print("[  SKIPPED ]", lack.strip())
        sys.exit(SKIPPED)
    print("Screenshots in", SETTING.out, flush=True)
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
