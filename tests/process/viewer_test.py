#!/usr/bin/python3
"""The viewer's page in a real browser, and its server by hand.

    tests/process/private_bus tests/process/viewer_test.py --bin build/release/bin

Skipped (exit code 77) where no browser can be driven. The screenshots stay in --out, for people.
"""

import argparse
import http.client
import json
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from live_processes import Processes, wait_for

SKIPPED = 77  # exit code, for ctest

try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
except ImportError:
    print("[  SKIPPED ] no selenium")
    sys.exit(SKIPPED)

PORT = 8080
CLIENTS = 3  # that may look, in these tests
NETWORK_ERROR = "ERR_"  # the browser's own word for a server that is away


def scenes(reply):
    """The parts of each event of a stream of scenes."""
    while line := reply.readline():
        if line.startswith(b"data: "):
            yield json.loads(line[len(b"data: "):])


class ServerTest(unittest.TestCase):
    """What a client can ask for."""

    @classmethod
    def setUpClass(cls):
        processes = Processes(options.out)
        cls.addClassCleanup(processes.stop_all)
        processes.start([*VIEWER, "--set", f"clients={CLIENTS}"])
        wait_for(can_connect, 20, "the viewer answers")

    def connect(self):
        connection = http.client.HTTPConnection("127.0.0.1", PORT, timeout=10)
        self.addCleanup(connection.close)
        return connection

    def get(self, path, method="GET"):
        connection = self.connect()
        connection.request(method, path)
        return connection.getresponse()

    def look(self):
        """Connection and answer that bring scenes, as soon as there is a place to look."""
        def granted():
            connection = self.connect()
            connection.request("GET", "/scenes")
            reply = connection.getresponse()
            return reply.status == 200 and (connection, reply)
        return wait_for(granted, 20, "a place to look")

    def test_serves_the_page_and_nothing_else(self):
        self.assertIn(b"<title>Perceptor</title>", self.get("/").read())
        self.assertEqual(self.get("/main.js").getheader("Content-Type"),
                         "text/javascript; charset=utf-8")
        self.assertEqual(self.get("/../config/robot.json").status, 404)

    def test_answers_get_only(self):
        for method in ("POST", "PUT", "DELETE", "HEAD", "OPTIONS"):
            self.assertEqual(self.get("/", method).status, 405, method)

    def test_tells_one_client_too_many(self):
        looking = [self.look() for _ in range(CLIENTS)]
        for _, reply in looking:
            self.assertIn("scene", next(scenes(reply)))
        self.assertEqual(self.get("/scenes").status, 503)
        self.assertEqual(self.get("/").status, 200)
        for connection, reply in looking:
            reply.close()
            connection.close()
        self.look()

    def test_sends_only_what_changed(self):
        stream = scenes(self.look()[1])
        first = next(stream)
        self.assertIn("layer.beams", first)
        self.assertIn("status", next(parts for parts in stream if "status" in parts))
        self.assertNotIn("layer.beams", next(stream))

    def test_says_who_has_the_port(self):
        other = subprocess.run(VIEWER, capture_output=True, text=True, timeout=10)
        self.assertEqual(other.returncode, 1)
        self.assertIn("cannot listen on 127.0.0.1:8080", other.stderr)


def can_connect():
    try:
        with socket.create_connection(("127.0.0.1", PORT), timeout=1):
            return True
    except OSError:
        return False


class PageTest(unittest.TestCase):
    """What a person sees, in the hospital, while the robot drives."""

    @classmethod
    def setUpClass(cls):
        cls.processes = Processes(options.out)
        cls.addClassCleanup(cls.processes.stop_all)
        cls.viewer = cls.processes.start(VIEWER)
        cls.processes.start_components(options.bin)
        cls.bridge = cls.processes.start([options.bin / "pico-bridge"])
        wait_for(can_connect, 20, "the viewer answers")
        cls.browser = open_browser(options.out)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.get(f"http://127.0.0.1:{PORT}/")
        wait_for(lambda: cls.script("perceptor.picture.scene.frame") == "world", 20,
                 "the robot is found in the building")

    @classmethod
    def script(cls, expression):
        return cls.browser.execute_script(f"return window.perceptor && ({expression})")

    def press(self, key):
        ActionChains(self.browser).send_keys(key).perform()

    def utime(self):
        return self.script("perceptor.picture.scene.utime")

    def image(self):
        """The picture's pixels, once it has been drawn."""
        return self.browser.execute_async_script(
            "requestAnimationFrame(() => requestAnimationFrame(() =>"
            " arguments[0](document.getElementById('picture').toDataURL())))")

    def banner(self):
        return self.browser.find_element("id", "banner").text

    def assert_console_is_clean(self, allowed=None):
        errors = [entry["message"] for entry in self.browser.get_log("browser")
                  if not allowed or allowed not in entry["message"]]
        self.assertEqual(errors, [])

    def test_1_shows_live_data(self):
        self.browser.execute_script(
            "window.seen = new Set();"
            "setInterval(() => seen.add(perceptor.picture.scene.utime), 20)")
        first, began = self.utime(), time.monotonic()
        time.sleep(options.seconds)
        shown = (self.utime() - first) / 1e6
        self.assertAlmostEqual(shown, time.monotonic() - began, delta=2.0)
        scenes_a_second = self.script("seen.size") / options.seconds
        self.assertGreater(scenes_a_second, 5.0, "of 10 a second, on a busy machine")
        self.assertEqual(self.banner(), "")
        self.browser.save_screenshot(str(options.out / "page.png"))
        self.assert_console_is_clean()

    def test_2_each_layer_goes_and_comes_back(self):
        needed = {"beams", "current", "local", "identified", "global", "combined", "proximity",
                  "trail", "truth", "robot"}
        shown = ("[...perceptor.picture.layers].filter(([, items]) => items.length)"
                 ".map(([id]) => id)")
        wait_for(lambda: needed <= set(self.script(shown)), 30, "something in each layer")
        self.press(" ")
        layers, shown = self.script("perceptor.picture.legend.layers"), self.script(shown)
        self.assertLessEqual(needed, set(shown))
        everything = self.image()
        for layer in layers:
            self.press(layer["key"])
            box = self.browser.find_element("id", f"layer-{layer['id']}")
            self.assertFalse(box.is_selected(), layer)
            if layer["id"] in shown:
                self.assertNotEqual(self.image(), everything, layer)
            self.press(layer["key"])
            self.assertTrue(box.is_selected(), layer)
        for layer in layers:  # the view may have been fitted to what was left
            self.press(layer["key"])
        nothing = self.image()
        self.assertNotEqual(nothing, everything)
        for layer in layers:
            self.press(layer["key"])
        self.press("0")
        self.assertEqual(self.image(), everything)
        self.press(" ")
        self.assert_console_is_clean()

    def test_3_pause_stands_still_and_goes_on(self):
        self.press(" ")
        paused = self.utime()
        time.sleep(1.0)
        self.assertEqual(self.utime(), paused)
        self.assertIn("Paused", self.banner())
        self.press(" ")
        wait_for(lambda: self.utime() > paused + 900_000, 20, "the picture goes on")
        wait_for(lambda: not self.banner(), 20, "the banner is gone")

    def test_4_saves_a_png(self):
        self.press("s")
        saved = wait_for(lambda: list(options.out.glob("perceptor-*.png")), 20, "a PNG is there")[0]
        wait_for(lambda: saved.read_bytes()[-8:-4] == b"IEND", 20, "it is written")
        self.assertEqual(saved.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_5_says_what_is_under_the_pointer(self):
        self.press(" ")
        self.addCleanup(self.press, " ")
        x, y = self.script(
            "(() => { let found; perceptor.picture.forEach((look, places) => {"
            " if (look.label === 'convex corner') found = places[0]; });"
            " return [found.x, found.y]; })()")
        canvas = self.browser.find_element("id", "picture")
        x, y = x - canvas.size["width"] / 2, y - canvas.size["height"] / 2
        for beside in (0, 2):  # [px]: on its symbol, not in its middle
            ActionChains(self.browser).move_to_element_with_offset(canvas, x + beside, y).perform()
            text = self.browser.find_element("id", "hover").text
            self.assertRegex(text, r"convex corner at \(.*\) m from where it began, sigma .* mm")

    def test_6_zooms_pans_and_follows(self):
        scale = self.script("perceptor.view.scale")
        canvas = self.browser.find_element("id", "picture")
        ActionChains(self.browser).scroll_from_origin(
            webdriver.common.actions.wheel_input.ScrollOrigin.from_element(canvas), 0, -300
        ).perform()
        self.assertGreater(self.script("perceptor.view.scale"), scale)
        centre = self.script("perceptor.view.centre.x")
        ActionChains(self.browser).drag_and_drop_by_offset(canvas, 100, 0).perform()
        self.assertLess(self.script("perceptor.view.centre.x"), centre)
        self.press("f")
        wait_for(lambda: self.script(
            "Math.abs(perceptor.view.centre.x - perceptor.picture.scene.robot[0]) < 1e-6"),
                 5, "the robot in the middle")
        self.press("0")

    def test_7_lists_the_components(self):
        self.press("d")
        for component in ("bridge", "scan", "merge", "localize", "viewer"):
            row = wait_for(lambda name=component: self.browser.find_elements(
                "id", f"component-{name}"), 5, component)[0]
            self.assertTrue(row.is_displayed())
        self.browser.save_screenshot(str(options.out / "components.png"))
        self.press("d")

    def test_8_recovers_when_the_server_comes_back(self):
        self.assert_console_is_clean()
        self.assertEqual(self.processes.stop(self.viewer), 0)
        wait_for(lambda: "No connection" in self.banner(), 20, "it says so")
        type(self).viewer = self.processes.start(VIEWER)
        before = self.utime()
        wait_for(lambda: self.utime() > before, 20, "the picture goes on")
        wait_for(lambda: not self.banner(), 20, "the banner is gone")
        self.assert_console_is_clean(allowed=NETWORK_ERROR)

    def test_9_says_when_data_stops(self):
        self.processes.stop(self.bridge)
        wait_for(lambda: "No new data for" in self.banner(), 20, "it says so")
        self.browser.save_screenshot(str(options.out / "silent.png"))


def open_browser(downloads):
    chosen = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1400,900"):
        chosen.add_argument(argument)
    chosen.add_experimental_option("prefs", {"download.default_directory": str(downloads)})
    chosen.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = webdriver.chrome.service.Service(shutil.which("chromedriver"))
    return webdriver.Chrome(service=service, options=chosen)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of the programs")
    parser.add_argument("--out", type=pathlib.Path, help="where the screenshots stay")
    parser.add_argument("--seconds", type=float, default=30.0, help="of live data to watch")
    options, rest = parser.parse_known_args()
    for program in ("chromium", "chromedriver"):
        if not shutil.which(program):
            print("[  SKIPPED ] no", program)
            sys.exit(SKIPPED)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # children can be interrupted
    options.out = options.out or pathlib.Path(tempfile.mkdtemp(prefix="viewer_test-"))
    options.out.mkdir(parents=True, exist_ok=True)
    VIEWER = [options.bin / "pico-viewer", "--port", str(PORT)]
    print("Screenshots in", options.out, flush=True)
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
