#!/usr/bin/python3
"""The viewer's page in a real browser, and its server by hand.

    private_bus viewer_test.py --bin BIN [--out FOLDER] [--seconds S]

Exit code 77 (skipped) where no browser can be driven.
"""

import argparse
import http.client
import json
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from live_chain import Chain, end, wait_until

try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
except ImportError:
    print("[  SKIPPED ] no selenium")
    sys.exit(77)

PORT = 8080
CLIENTS = 3  # that may look, in these tests
NETWORK_ERROR = "ERR_"  # the browser's own word for a server that is away
options = None


def scenes(reply):
    """The parts of each event of a stream of scenes."""
    while line := reply.readline():
        if line.startswith(b"data: "):
            yield json.loads(line[len(b"data: "):])


class ServerTest(unittest.TestCase):
    """What a client can ask for."""

    @classmethod
    def setUpClass(cls):
        cls.chain = Chain(options.bin)
        cls.addClassCleanup(cls.chain.close)
        cls.chain.start("viewer", "--port", str(PORT), "--set", f"clients={CLIENTS}")
        wait_until("the viewer answers", can_connect)

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
        return wait_until("a place to look", granted)

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
        other = subprocess.run([self.chain.bin / "pico-viewer", "--port", str(PORT)],
                               capture_output=True, text=True, timeout=10)
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
        cls.folder = pathlib.Path(options.out or tempfile.mkdtemp(prefix="viewer-"))
        cls.folder.mkdir(parents=True, exist_ok=True)
        if not options.out:
            cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.chain = Chain(options.bin)
        cls.addClassCleanup(cls.chain.close)
        cls.viewer = cls.chain.start("viewer", "--port", str(PORT))
        cls.chain.perceive("hospital")
        cls.bridge = cls.chain.start("bridge")
        wait_until("the viewer answers", can_connect)
        cls.browser = open_browser(cls.folder)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.get(f"http://127.0.0.1:{PORT}/")
        wait_until("the robot is found in the building",
                   lambda: cls.script("perceptor.picture.scene.frame") == "world")

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
        self.browser.save_screenshot(str(self.folder / "page.png"))
        self.assert_console_is_clean()

    def test_2_each_layer_goes_and_comes_back(self):
        self.press(" ")
        layers = self.script("perceptor.picture.legend.layers")
        shown = self.script("[...perceptor.picture.layers].filter(([, items]) => items.length)"
                            ".map(([id]) => id)")
        for needed in ("beams", "current", "local", "identified", "global", "combined",
                       "proximity", "trail", "truth", "robot"):
            self.assertIn(needed, shown)
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
        wait_until("the picture goes on", lambda: self.utime() > paused + 900_000)
        wait_until("the banner is gone", lambda: not self.banner())

    def test_4_saves_a_png(self):
        self.press("s")
        saved = wait_until("a PNG is there", lambda: list(self.folder.glob("perceptor-*.png")))[0]
        wait_until("it is written", lambda: saved.read_bytes()[-8:-4] == b"IEND")
        self.assertEqual(saved.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_5_says_what_is_under_the_pointer(self):
        self.press(" ")
        x, y = self.script(
            "(() => { let found; perceptor.picture.forEach((look, places) => {"
            " if (look.label === 'convex corner') found = places[0]; });"
            " return [found.x, found.y]; })()")
        canvas = self.browser.find_element("id", "picture")
        ActionChains(self.browser).move_to_element_with_offset(
            canvas, x - canvas.size["width"] / 2, y - canvas.size["height"] / 2).perform()
        text = self.browser.find_element("id", "hover").text
        self.assertRegex(text, r"convex corner at \(.*\) m, sigma .* mm")
        self.press(" ")

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
        wait_until("the robot is in the middle", lambda: self.script(
            "Math.abs(perceptor.view.centre.x - perceptor.picture.scene.robot[0]) < 1e-6"))
        self.press("0")

    def test_7_lists_the_components(self):
        self.press("d")
        for component in ("bridge", "scan", "merge", "localize", "viewer"):
            row = wait_until(component, lambda name=component: self.browser.find_elements(
                "id", f"component-{name}"))[0]
            self.assertTrue(row.is_displayed())
        self.browser.save_screenshot(str(self.folder / "components.png"))
        self.press("d")

    def test_8_recovers_when_the_server_comes_back(self):
        self.assert_console_is_clean()
        self.assertEqual(end(self.viewer), 0)
        wait_until("it says so", lambda: "No connection" in self.banner())
        type(self).viewer = self.chain.start("viewer", "--port", str(PORT))
        before = self.utime()
        wait_until("the picture goes on", lambda: self.utime() > before)
        wait_until("the banner is gone", lambda: not self.banner())
        self.assert_console_is_clean(allowed=NETWORK_ERROR)

    def test_9_says_when_data_stops(self):
        end(self.bridge)
        wait_until("it says so", lambda: "No new data for" in self.banner())
        self.browser.save_screenshot(str(self.folder / "silent.png"))


def open_browser(downloads):
    chosen = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1400,900"):
        chosen.add_argument(argument)
    chosen.add_experimental_option("prefs", {"download.default_directory": str(downloads)})
    chosen.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = webdriver.chrome.service.Service(shutil.which("chromedriver"))
    return webdriver.Chrome(service=service, options=chosen)


def main():
    global options
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--bin", required=True, help="where the programs are")
    parser.add_argument("--out", help="keep the screenshots here")
    parser.add_argument("--seconds", type=float, default=30.0, help="of live data to watch")
    options, rest = parser.parse_known_args()
    for program in ("chromium", "chromedriver"):
        if not shutil.which(program):
            print(f"[  SKIPPED ] no {program}")
            return 77
    unittest.main(argv=[sys.argv[0], *rest], verbosity=2)


if __name__ == "__main__":
    sys.exit(main())
