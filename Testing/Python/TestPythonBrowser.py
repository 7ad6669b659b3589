# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""The viewer in a browser: python -m vtkterrain FILE; skipped without trame.

What a browser would show is looked at in headless Chromium, where playwright and Chromium are there.
"""
import asyncio
import contextlib
import http.client
import importlib.util
import itertools
import logging
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest
import urllib.parse

import numpy as np
import vtkTerrainTesting

HAS_TRAME = all(importlib.util.find_spec(name) for name in ("trame", "trame_rca", "trame_vuetify", "PIL"))
CHROMIUM = shutil.which("chromium")
HEIGHTS = pathlib.Path(__file__).parents[2] / "Examples" / "Places" / "heights.tif"


def command(*arguments):
    return [sys.executable, "-m", "vtkterrain", "--no-browser", *map(str, arguments)]


@contextlib.contextmanager
def viewer(*arguments):
    """A viewer, from when it answers on; gives its process and the address it printed."""
    said = pathlib.Path(vtkTerrainTesting.output_path("viewer.log"))
    with said.open("w", encoding="utf-8") as log:
        process = subprocess.Popen(command(*arguments), stdout=subprocess.PIPE, stderr=log, text=True)
    try:
        yield process, process.stdout.readline().strip()
        assert "Traceback" not in said.read_text(encoding="utf-8"), said.read_text(encoding="utf-8")
    finally:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        process.stdout.close()


def ask(address, path, **headers):
    """Status, headers and text of a path, which goes to the server as it is."""
    server = urllib.parse.urlsplit(address)
    connection = http.client.HTTPConnection(server.hostname, server.port, timeout=30)
    try:
        connection.putrequest("GET", path, skip_accept_encoding=True)
        for name, value in headers.items():
            connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        return answer.status, answer.headers, answer.read().decode(errors="replace")
    finally:
        connection.close()


@unittest.skipUnless(HAS_TRAME, "trame, trame-rca, trame-vuetify and pillow are not installed")
class TestServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.running = contextlib.ExitStack()
        _, cls.address = cls.running.enter_context(viewer(HEIGHTS))
        cls.token = urllib.parse.urlsplit(cls.address).query
        _, headers, _ = ask(cls.address, f"/?{cls.token}")
        cls.cookie = headers["Set-Cookie"].split(";")[0]

    @classmethod
    def tearDownClass(cls):
        cls.running.close()

    def test_it_listens_to_this_machine_alone_and_tells_a_token(self):
        self.assertRegex(self.address, r"^http://127\.0\.0\.1:\d+/\?token=[\w-]{32}$")

    def test_nothing_is_answered_without_the_token(self):
        for path in ("/", "/index.html", "/ws", "/?token=", "/?token=guess", "/no/such/path"):
            self.assertEqual(ask(self.address, path)[0], 403, path)
        status, headers, _ = ask(self.address, f"/?{self.token}")
        self.assertEqual((status, headers["Location"]), (302, "/index.html"))
        self.assertIn("HttpOnly", headers["Set-Cookie"])
        self.assertIn("SameSite=Strict", headers["Set-Cookie"])
        self.assertEqual(ask(self.address, "/index.html", Cookie=self.cookie)[0], 200)

    def test_a_page_of_another_origin_is_not_let_in(self):
        websocket = {"Cookie": self.cookie, "Connection": "Upgrade", "Upgrade": "websocket",
                     "Sec-WebSocket-Version": "13", "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ=="}
        for origin in ("http://elsewhere.example", "null", "http://127.0.0.1:1"):
            self.assertEqual(ask(self.address, "/ws", Origin=origin, **websocket)[0], 403, origin)

    def test_no_file_is_served(self):
        secret = pathlib.Path(vtkTerrainTesting.output_path("secret.txt"))
        secret.write_text("not for the browser")
        dots = "/".join([".."] * 12)
        for path in (f"/{dots}{secret}", f"/%2e%2e/{dots}{secret}", f"//{secret}", f"/index.html?file={secret}",
                     f"/?file={secret}", f"/assets/{dots}{secret}", f"/{HEIGHTS.name}", "/heights.tif?raw=1"):
            _, _, text = ask(self.address, path, Cookie=self.cookie)
            self.assertNotIn("not for the browser", text, path)
            self.assertNotIn("II*", text, path)

    def test_a_browser_that_closes_while_loading_is_no_harm(self):
        server = urllib.parse.urlsplit(self.address)
        for _ in range(5):
            with socket.create_connection((server.hostname, server.port)) as connection:
                connection.sendall(f"GET /index.html HTTP/1.1\r\nHost: {server.netloc}\r\nCookie: {self.cookie}\r\n\r\n"
                                   .encode())
        self.assertEqual(ask(self.address, "/index.html", Cookie=self.cookie)[0], 200)


@unittest.skipUnless(HAS_TRAME, "trame, trame-rca, trame-vuetify and pillow are not installed")
class TestLog(unittest.TestCase):
    def answer(self, error):
        """The status of a page whose answer ends with the error, and what aiohttp logs of it."""
        from aiohttp import web

        from vtkterrain.server import guard, hush_lost_connections

        async def fail(_):
            raise error

        async def serve():
            app = web.Application(middlewares=[guard("token", "cookie")])
            app.router.add_get("/ws", fail)
            runner = web.AppRunner(app)
            await runner.setup()
            try:
                await web.TCPSite(runner, "127.0.0.1", 0).start()
                host, port = runner.addresses[0][:2]
                return await asyncio.to_thread(ask, f"http://{host}:{port}", "/ws", Cookie="cookie=token")
            finally:
                await runner.cleanup()

        lines = []
        handler = logging.Handler()
        handler.emit = lines.append
        logging.getLogger().addHandler(handler)
        self.addCleanup(logging.getLogger().removeHandler, handler)
        hush_lost_connections()
        return asyncio.run(serve())[0], lines

    def test_a_browser_that_is_gone_is_not_logged(self):
        self.assertEqual(self.answer(ConnectionResetError("closing")), (500, []))

    def test_a_fault_of_ours_is_logged(self):
        status, lines = self.answer(KeyError("fault"))
        self.assertEqual((status, len(lines)), (500, 1))


@unittest.skipUnless(HAS_TRAME, "trame, trame-rca, trame-vuetify and pillow are not installed")
class TestFingers(unittest.TestCase):
    """Gestures as trame-rca tells them: what each amounts to since it began."""

    def setUp(self):
        from vtkterrain.server import RemoteWindow
        from vtkterrain.viewer import Viewer, read_heights

        self.viewer = Viewer(read_heights(str(HEIGHTS)))
        self.told = []
        self.window = RemoteWindow(self.viewer, self.told.append, lambda: True)
        self.viewer.draw()
        self.camera = self.viewer.renderer.GetActiveCamera()

    def gesture(self, kind, key, values):
        for prefix in ("Start", "End"):
            self.window.process_interaction_event({"type": "LeftButtonPress", "x": 300, "y": 300})
            self.window.process_interaction_event({"type": "LeftButtonRelease", "x": 300, "y": 300})
            if prefix == "Start":
                self.window.process_interaction_event({"type": f"Start{kind}", key: values[0]})
                for value in values[1:]:
                    self.window.process_interaction_event({"type": kind, key: value})
            self.window.process_interaction_event({"type": f"End{kind}", key: values[-1]})

    def test_a_view_of_all_is_of_all_beside_the_panel(self):
        from vtkmodules.vtkRenderingCore import vtkCoordinate

        for size, covered in (((1000, 700), 266), ((400, 640), 0), ((1600, 500), 266), ((360, 640), 266)):
            self.viewer.cover(covered)
            self.viewer.resize(*size)
            self.viewer.cover(covered)
            self.viewer.draw()
            corner = vtkCoordinate()
            corner.SetCoordinateSystemToWorld()
            bounds = np.reshape(self.viewer.terrain.GetBounds(), (3, 2))
            places = []
            for point in np.stack(np.meshgrid(*bounds), axis=-1).reshape(-1, 3):
                corner.SetValue(*point)
                places.append(corner.GetComputedDoubleDisplayValue(self.viewer.renderer))
            free = size[0] - (covered if covered < size[0] / 2 else 0)
            low, high = np.min(places, axis=0), np.max(places, axis=0)
            self.assertTrue((low > 0).all() and high[0] < free and high[1] < size[1], (size, low, high))
            self.assertGreater(max((high[0] - low[0]) / free, (high[1] - low[1]) / size[1]), 0.7)

    def test_colors_by_their_names(self):
        pictures = []
        for name in ("relief", "grey", "plain", "oleron", "batlow_r"):
            self.viewer.set_colors(name)
            pictures.append(self.viewer.draw().astype(int))
        for one, other in itertools.combinations(pictures, 2):
            self.assertGreater((np.abs(one - other).max(axis=2) > 10).mean(), 0.1)
        self.viewer.set_colors("oleron")  # has its sea below 0, and none here
        color = self.viewer.terrain.GetLookupTable().GetColor(500.0)
        self.assertGreater(color[1], color[2])

    def test_pinch_zooms_by_its_factor(self):
        for factor in (2.0, 0.25):
            before = self.camera.GetDistance()
            self.gesture("Pinch", "factor", [1.0, factor**0.3, factor])
            self.assertAlmostEqual(before / self.camera.GetDistance(), factor)

    def test_rotation_turns_the_terrain_with_the_fingers(self):
        self.assertAlmostEqual(self.camera.GetPosition()[0], 0.0)
        distance = np.hypot(*self.camera.GetPosition()[:2])
        self.gesture("Rotate", "rotation", [0.0, 10.0, 30.0])  # against the clock: the eye goes the other way
        self.assertAlmostEqual(self.camera.GetPosition()[0] / distance, -np.sin(np.radians(30.0)))

    def test_two_fingers_move(self):
        before = np.array(self.camera.GetFocalPoint())
        self.gesture("Pan", "translation", [[0, 0], [10, 0], [60, 20]])
        moved = np.array(self.camera.GetFocalPoint()) - before
        self.assertLess(moved[0], 0.0)
        self.assertLess(moved[1], 0.0)
        self.assertAlmostEqual(moved[0] / moved[1], 3.0)

    def test_only_a_tap_tells_the_place(self):
        self.gesture("Pinch", "factor", [1.0, 1.1])
        self.assertEqual(self.told, [])
        width, height = self.viewer.size
        self.window.process_interaction_event({"type": "Tap", "position": {"x": width / 2, "y": height / 2}})
        self.assertRegex(self.told[0], r"^Height \d+\.\d m  Place 6\d\.\d+N .* UTM 27n .* MGRS 27W")


@unittest.skipUnless(HAS_TRAME, "trame, trame-rca, trame-vuetify and pillow are not installed")
class TestRefusals(unittest.TestCase):
    def refusal(self, *arguments):
        result = subprocess.run(command(*arguments), capture_output=True, text=True, check=False, timeout=120)
        self.assertNotEqual(result.returncode, 0)
        self.assertNotIn("Traceback", result.stderr)
        return result.stderr.strip().splitlines()[-1]

    def test_a_file_that_is_none(self):
        self.assertIn("'/nowhere.tif'", self.refusal("/nowhere.tif"))
        self.assertIn("heights.tif?token=1", self.refusal(f"{HEIGHTS}?token=1"))

    def test_a_port_in_use(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            self.assertRegex(self.refusal(HEIGHTS, "--port", port), rf"port {port} .*--port 0")

    def test_a_port_that_is_none(self):
        for port in (99999, -1, "x"):
            self.assertIn("0 to 65535", self.refusal(HEIGHTS, f"--port={port}"))

    def test_a_host_that_is_none(self):
        for host in ("nohost.invalid", "192.0.2.1"):
            self.assertRegex(self.refusal(HEIGHTS, "--host", host), f"host {host} is no address .*127.0.0.1")

    def test_a_band_that_is_none(self):
        self.assertIn("band", self.refusal(HEIGHTS, "--band", 7))

    def test_colors_that_are_none(self):
        self.assertRegex(self.refusal(HEIGHTS, "--colors", "olerom"), "no colour map 'olerom', but 'oleron'")

    def test_heights_without_a_surface(self):
        path = vtkTerrainTesting.output_path("line.asc")
        vtkTerrainTesting.write_ascii_grid(path, np.zeros((1, 5)))
        self.assertIn("no surface", self.refusal(path))


@unittest.skipUnless(HAS_TRAME and CHROMIUM and importlib.util.find_spec("playwright"),
                     "trame, playwright or Chromium is not installed")
class TestChromium(unittest.TestCase):
    def setUp(self):
        from playwright.sync_api import sync_playwright

        self.running = contextlib.ExitStack()
        self.addCleanup(self.running.close)
        self.process, self.address = self.running.enter_context(viewer(HEIGHTS))
        browser = self.running.enter_context(sync_playwright()).chromium.launch(
            executable_path=CHROMIUM, args=["--no-sandbox", "--disable-gpu"])
        self.running.callback(browser.close)
        self.browser = browser.new_context(viewport={"width": 1000, "height": 700}, has_touch=True)
        self.page = self.browser.new_page()
        self.errors = []
        self.page.on("console", lambda said: said.type == "error" and self.errors.append(said.text))
        self.page.goto(self.address)
        self.page.wait_for_selector("img", timeout=60_000)

    def picture(self, name):
        """A screenshot that no longer changes, without the controls, as an array."""
        before = None
        for _ in range(40):
            time.sleep(0.5)
            path = vtkTerrainTesting.output_path(f"browser-{name}.png")
            self.page.screenshot(path=path, clip={"x": 0, "y": 0, "width": 700, "height": 640})
            now = vtkTerrainTesting.read_picture(path)[..., :3]
            if before is not None and np.array_equal(before, now):
                return now.astype(int)
            before = now
        raise AssertionError(f"the picture goes on changing: {path}")

    def drag(self, dx, dy, button="left"):
        self.page.mouse.move(400, 350)
        self.page.mouse.down(button=button)
        for step in range(1, 11):
            self.page.mouse.move(400 + dx * step / 10, 350 + dy * step / 10)
        self.page.mouse.up(button=button)

    def wait_for_text(self, pattern):
        self.page.wait_for_function("pattern => new RegExp(pattern).test(document.querySelector('#picked').innerText)",
                                    arg=pattern, timeout=30_000)

    def test_pointer_keys_settings_and_size(self):
        first = self.picture("first")
        self.assertGreater(len(np.unique(first.reshape(-1, 3), axis=0)), 1000)
        seen = {"first": first}
        for name, act in (("turn", lambda: self.drag(150, 40)), ("pan", lambda: self.drag(60, 60, "right")),
                          ("zoom", lambda: self.page.mouse.wheel(0, -300)),
                          ("key", lambda: self.page.keyboard.press("ArrowLeft")),
                          ("contours", lambda: self.page.get_by_label("Contours").click()),
                          ("sun", lambda: self.page.get_by_role("slider").nth(1).press("Home")),
                          ("heights", lambda: self.page.get_by_role("slider").nth(0).press("End"))):
            act()
            now = self.picture(name)
            last = list(seen.values())[-1]
            self.assertGreater((np.abs(now - last).max(axis=2) > 10).mean(), 0.002, name)
            seen[name] = now
        self.page.set_viewport_size({"width": 760, "height": 680})
        self.assertGreater((np.abs(self.picture("resized") - seen["heights"]).max(axis=2) > 10).mean(), 0.02)

    def test_keys_are_heard_from_the_start_and_after_controls(self):
        last = self.picture("fresh")
        for name, act in (("c", lambda: self.page.keyboard.press("c")),
                          ("arrow", lambda: self.page.keyboard.press("ArrowLeft")),
                          ("arrow-after-button", lambda: (self.page.click("#reset"),
                                                          self.page.keyboard.press("ArrowLeft"),
                                                          self.page.keyboard.press("ArrowLeft"))),
                          ("c-after-switch", lambda: (self.page.get_by_label("Contours").click(),
                                                      self.page.keyboard.press("ArrowRight")))):
            act()
            now = self.picture(name)
            self.assertGreater((np.abs(now - last).max(axis=2) > 10).mean(), 0.002, name)
            last = now

    def test_the_panel_folds_and_is_folded_on_a_narrow_page(self):
        self.assertTrue(self.page.is_visible("#reset"))
        self.page.click("#fold")
        self.page.wait_for_selector("#reset", state="hidden")
        self.page.click("#help")
        self.wait_for_text("t technique")
        page = self.browser.new_page()
        page.set_viewport_size({"width": 360, "height": 640})
        page.goto(self.address)
        page.wait_for_selector("img", timeout=60_000)
        page.wait_for_selector("#reset", state="hidden")
        time.sleep(2)
        page.screenshot(path=vtkTerrainTesting.output_path("browser-narrow.png"))

    def test_nothing_fails_while_the_page_loads(self):
        self.page.reload()
        self.page.wait_for_selector("img", timeout=60_000)
        self.picture("loaded")
        self.assertEqual(self.errors, [])

    def test_a_click_tells_the_place(self):
        self.page.mouse.click(480, 450)
        self.wait_for_text(r"^Height \d+\.\d m  Place \S+ \S+  UTM .* MGRS ")
        self.page.mouse.click(20, 20)
        self.wait_for_text("sky")

    def touch(self, path):
        """Fingers go along path(t), 0 <= t <= 1, which gives where each is."""
        session = self.browser.new_cdp_session(self.page)
        for step in range(21):
            points = [{"x": x, "y": y, "id": finger} for finger, (x, y) in enumerate(path(step / 20))]
            session.send("Input.dispatchTouchEvent",
                         {"type": "touchMove" if step else "touchStart", "touchPoints": points})
            time.sleep(0.02)
        session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    def test_fingers(self):
        last = first = self.picture("untouched")
        help_text = self.page.inner_text("#picked")

        def turned(t):
            return 70 * np.cos(1.3 * t), 70 * np.sin(1.3 * t)

        for name, path in (
                ("finger", lambda t: [(300 + 150 * t, 350)]),
                ("pinch", lambda t: [(400 - 40 - 80 * t, 350), (400 + 40 + 80 * t, 350)]),
                ("fingers", lambda t: [(300 + 90 * t, 350), (420 + 90 * t, 350)]),
                ("twist", lambda t: [(400 + turned(t)[0], 350 + turned(t)[1]),
                                     (400 - turned(t)[0], 350 - turned(t)[1])])):
            self.touch(path)
            now = self.picture(name)
            self.assertGreater((np.abs(now - last).max(axis=2) > 10).mean(), 0.1, name)
            last = now
        self.assertEqual(self.page.inner_text("#picked"), help_text)
        self.page.touchscreen.tap(400, 450)
        self.wait_for_text(r"^Height \d+\.\d m  Place 6\d\.\d+N")
        self.page.click("#reset")
        self.assertLess((np.abs(self.picture("whole") - first).max(axis=2) > 10).mean(), 0.01)

    def test_a_browser_that_closes_while_it_is_sent_pictures_is_no_harm(self):
        for _ in range(3):
            page = self.browser.new_page()
            page.goto(self.address)
            page.mouse.move(300, 300)
            page.mouse.down()
            page.mouse.move(350, 300)
            page.close()
        self.page.reload()
        self.page.wait_for_selector("img", timeout=60_000)
        self.picture("after-others")

    def test_a_lost_connection_is_told_and_a_reload_goes_on(self):
        self.page.reload()
        self.page.wait_for_selector("img", timeout=60_000)
        self.picture("reloaded")
        self.process.kill()
        self.process.wait()
        self.page.wait_for_function("document.body.innerText.toLowerCase().includes('connection')", timeout=30_000)


# A page that renders by itself (vtk.js), as PyVista's mode "client".
CLIENT = """
import sys
import pyvista
from trame.app import get_server
from trame.ui.vuetify3 import VAppLayout
from trame.widgets import vtk
from vtkterrain.plotting import add_terrain
server = get_server("client", client_type="vue3")
plotter = pyvista.Plotter(off_screen=True)
add_terrain(plotter, sys.argv[1], exaggeration=2.0, show_scalar_bar=False)
plotter.view_vector((0.0, -0.82, 0.57), viewup=(0.0, 0.0, 1.0))
with VAppLayout(server) as layout, layout.root:
    vtk.VtkLocalView(plotter.render_window, style="width: 100vw; height: 100vh; position: absolute")
server.controller.on_server_ready.add(lambda **_: print(f"http://127.0.0.1:{server.port}/index.html", flush=True))
server.start(port=0, host="127.0.0.1", open_browser=False, show_connection_info=False, timeout=0)
"""


@unittest.skipUnless(HAS_TRAME and CHROMIUM and all(map(importlib.util.find_spec, (
    "playwright", "pyvista", "trame_vtk", "vtkmodules.vtkWebCore"))), "what a page that renders by itself takes")
class TestClient(unittest.TestCase):
    def test_it_shows_a_mesh_in_the_colours_of_the_terrain_and_says_so(self):
        from playwright.sync_api import sync_playwright

        said = pathlib.Path(vtkTerrainTesting.output_path("client.log"))
        with said.open("w", encoding="utf-8") as log:
            process = subprocess.Popen([sys.executable, "-c", CLIENT, str(HEIGHTS)], stdout=subprocess.PIPE,
                                       stderr=log, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        # trame prints "update_geometry is missing" before it where the page is not yet there
        address = next((line.strip() for line in process.stdout if line.startswith("http")), None)
        self.assertIsNotNone(address, said.read_text(encoding="utf-8"))
        with sync_playwright() as play:
            browser = play.chromium.launch(executable_path=CHROMIUM, args=[
                "--no-sandbox", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"])
            page = browser.new_page(viewport={"width": 600, "height": 400})
            page.goto(address)
            page.wait_for_selector("canvas", timeout=60_000)
            path = vtkTerrainTesting.output_path("client.png")
            for _ in range(30):
                time.sleep(0.5)
                page.screenshot(path=path)
                picture = vtkTerrainTesting.read_picture(path)[..., :3].astype(int)
                is_ground = np.ptp(picture, axis=2) > 10
                if is_ground.mean() > 0.1:
                    break
            browser.close()
        self.assertGreater(is_ground.mean(), 0.1)
        self.assertGreater(len(np.unique(picture[is_ground], axis=0)), 500)
        self.assertIn("cannot show terrain, only a mesh of it", said.read_text(encoding="utf-8"))


if __name__ == "__main__":
    vtkTerrainTesting.run()
