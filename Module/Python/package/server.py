# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page that shows a terrain in a browser; the pictures are drawn here.

Only who has the token of the address gets an answer, and no page of another origin. Nothing of a
request names a file: what is served is the page, trame's own scripts, and pictures of the terrain.
"""
import asyncio
import errno
import hmac
import logging
import secrets
import socket
import sys
import time

from aiohttp import web
from trame.app import asynchronous, get_server
from trame.ui.vuetify3 import VAppLayout
from trame.widgets import client, html, rca
from trame.widgets import vuetify3 as vuetify
from trame_rca.utils import RcaEncoder, RcaViewAdapter

from ._colors import scheme_names
from .viewer import COLORS, TECHNIQUES, Viewer

_HELP = ("Drag turns, right or Shift drag moves, wheel zooms, click tells the place. Two fingers move, turn, zoom. "
         "Keys: arrows turn, + - zoom, c contours, t technique, r whole terrain.")
_KEYS = {"ArrowLeft": (-5.0, 0.0), "ArrowRight": (5.0, 0.0), "ArrowUp": (0.0, 5.0), "ArrowDown": (0.0, -5.0)}
_PANEL = 266  # pixels from the right border that the panel covers
# What is done in the browser: the panel is folded on a narrow page, and keys are heard from the start on.
_ON_SHOW = "folded = $event.el.clientWidth < 600; $event.el.focus()"
_KEY_AND_ROLE = ("[$event.ctrlKey || $event.metaKey || $event.altKey ? '' : $event.key, "
                 "$event.target.getAttribute('role') || '']")
_SECONDS_OF_REST = 0.17  # until a picture is drawn without haste
_QUALITY_IN_HASTE, _QUALITY_AT_REST = 65, 92  # of JPEG
_SESSION_PATH = "/paraview/"  # where trame's page asks for the address of its session, if it is not told
_LARGEST_CLICK = 3  # pixels that the pointer may move between press and release


class RemoteWindow:
    """What trame-rca asks of a window: pictures, and what pointer and fingers do."""

    def __init__(self, viewer, on_pick, is_touched=lambda: False):
        self._viewer = viewer
        self._is_touched = is_touched
        self._on_pick = on_pick
        self._button = None
        self._pressed_at = self._last = (0, 0)
        self._gesture = {}
        self.is_hasty = False

    @property
    def img_cols_rows(self):
        """A picture, its width and height."""
        picture = self._viewer.draw(self.is_hasty)
        return picture, picture.shape[1], picture.shape[0]

    def process_resize_event(self, width, height):
        """The page has another size."""
        self._viewer.resize(width, height)

    def process_interaction_event(self, event):
        """A pointer, a wheel, or a gesture of fingers."""
        kind = event.get("type", "")
        if kind.endswith(("ButtonPress", "ButtonRelease")):
            self._press_or_release(kind, event)
        elif kind == "MouseMove" and self._button:
            self._drag(event)
        elif kind == "MouseWheel":
            self._viewer.zoom(1.1 ** -max(-3.0, min(3.0, float(event.get("spinY", 0.0)))))
        elif kind in ("StartPinch", "Pinch"):
            self._pinch(kind, event)
        elif kind in ("StartRotate", "Rotate"):
            self._rotate(kind, event)
        elif kind in ("StartPan", "Pan"):
            self._pan(kind, event)
        elif kind == "Tap":
            self._tell(event.get("position", {}))

    def _press_or_release(self, kind, event):
        here = (event["x"], event["y"])
        if kind.endswith("Press"):
            self._button = "pan" if not kind.startswith("Left") or event.get("shiftKey") else "turn"
            self._pressed_at = self._last = here
        else:
            way = max(abs(a - b) for a, b in zip(here, self._pressed_at))
            # Fingers press and let go at one place before and after each gesture; they tap.
            if self._button == "turn" and way <= _LARGEST_CLICK and not self._is_touched():
                self._tell(event)
            self._button = None

    def _drag(self, event):
        x, y = event["x"] - self._last[0], event["y"] - self._last[1]
        self._last = (event["x"], event["y"])
        height = self._viewer.size[1]
        if self._button == "turn":
            self._viewer.turn(180.0 * x / height, 180.0 * y / height)
        else:
            self._viewer.pan(x / height, y / height)

    # Gestures of fingers tell what they amount to since they began.
    def _since_last(self, gesture, now, is_start):
        before = now if is_start else self._gesture.get(gesture, now)
        self._gesture[gesture] = now
        return now, before

    def _pinch(self, kind, event):
        now, before = self._since_last("pinch", max(1e-3, float(event.get("factor") or 1.0)), kind == "StartPinch")
        self._viewer.zoom(now / before)

    def _rotate(self, kind, event):
        now, before = self._since_last("rotate", float(event.get("rotation") or 0.0), kind == "StartRotate")
        self._viewer.turn(now - before, 0.0)

    def _pan(self, kind, event):
        now = [float(part) for part in event.get("translation") or (0.0, 0.0)][:2]
        now, before = self._since_last("pan", now, kind == "StartPan")
        height = self._viewer.size[1]
        self._viewer.pan((now[0] - before[0]) / height, (now[1] - before[1]) / height)

    def _tell(self, place):
        if "x" in place and "y" in place:
            self._on_pick(self._viewer.describe(place["x"], place["y"]) or "sky")


class Scheduler:
    """When pictures are drawn, and how they travel: a scheduler of trame-rca's.

    Pictures while something moves are hasty, the one after it is not. The next one is drawn as soon as
    there is something to draw and the last but one has been encoded, which threads do meanwhile;
    trame-rca's own scheduler draws at even times only, which costs half of the pictures where one takes
    little more than its time.
    """

    target_fps = 30.0

    def __init__(self, window):
        self.rca = window
        self._encoder = RcaEncoder("jpeg")
        self._push = None
        self._is_wanted = asyncio.Event()
        self._underway = asyncio.Semaphore(2)
        self._last_pushed = 0
        self._task = asynchronous.create_task(self._run())

    def set_push_callback(self, callback):
        """What is called with each picture and what is to be known of it."""
        self._push = callback

    def schedule_render(self):
        """Asks for a picture."""
        self._is_wanted.set()

    def reset(self):
        """A browser has come: every picture stands for itself."""

    async def close(self):
        """Draws no more."""
        self._task.cancel()

    async def _run(self):
        is_settled = True
        while True:
            try:
                await asyncio.wait_for(self._is_wanted.wait(), None if is_settled else _SECONDS_OF_REST)
                is_settled = False
            except asyncio.TimeoutError:
                is_settled = True
            self._is_wanted.clear()
            await self._underway.acquire()
            begin = time.monotonic()
            self.rca.is_hasty = not is_settled
            quality = _QUALITY_AT_REST if is_settled else _QUALITY_IN_HASTE
            asynchronous.create_task(self._send(*self.rca.img_cols_rows, quality))
            # What the browser says is heard before the next one is drawn.
            await asyncio.sleep(max(0.001, 1.0 / self.target_fps - (time.monotonic() - begin)))

    async def _send(self, picture, columns, rows, quality):
        try:
            image, facts, made = await asyncio.get_running_loop().run_in_executor(
                None, self._encoder.encode, picture, columns, rows, quality)
        finally:
            self._underway.release()
        if self._push and made >= self._last_pushed:
            self._last_pushed = made
            self._push(image, facts)


def _is_same_origin(request):
    origin = request.headers.get("Origin")
    return origin is None or origin.partition("://")[2] == request.headers.get("Host")


def guard(token, cookie):
    """What lets in only who has the token, in the address at first, in a cookie from then on."""

    def is_token(text):
        return hmac.compare_digest(text.encode(), token.encode())

    @web.middleware
    async def only_with_token(request, handler):
        if not _is_same_origin(request):
            return web.Response(status=403, text="Pages of another origin are not let in.\n")
        if is_token(request.query.get("token", "")):
            answer = web.HTTPFound("/index.html")
            answer.set_cookie(cookie, token, httponly=True, samesite="Strict")
            raise answer
        if not is_token(request.cookies.get(cookie, "")):
            fault = "of another run" if "token" in request.query or cookie in request.cookies else "missing"
            return web.Response(status=403, text=f"The token is {fault}: open the address that was printed.\n")
        if (request.method, request.path) == ("POST", _SESSION_PATH) and "Origin" in request.headers:
            return web.json_response({"sessionURL": request.headers["Origin"].replace("http", "ws", 1) + "/ws"})
        return await handler(request)

    return only_with_token


def free_port(host, port):
    """The port, or any free one for 0. Raises OSError with a sentence if it is in use."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    with socket.socket(family, socket.SOCK_STREAM) as tried:
        tried.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            tried.bind((host, port))
        except OSError as error:
            if isinstance(error, socket.gaierror) or error.errno == errno.EADDRNOTAVAIL:
                raise OSError(f"host {host} is no address of this machine ({error.strerror}): take 127.0.0.1, or "
                              "0.0.0.0 for all that it has") from error
            raise OSError(f"port {port} of {host} cannot be used ({error.strerror}): "
                          "take another, or --port 0 for any that is free") from error
        return tried.getsockname()[1]


def _is_no_lost_connection(record):
    error = record.exc_info[1] if record.exc_info else sys.exc_info()[1]
    return not isinstance(error, ConnectionError)


def hush_lost_connections():
    """A browser may close while it is being sent something: nothing to log a traceback of."""
    for name in ("asyncio", "aiohttp.server", "wslink.protocol", "wslink.backends.aiohttp"):
        logging.getLogger(name).addFilter(_is_no_lost_connection)


class Page:
    """The page of one terrain; ``colors`` are the first ones, of ``Viewer.set_colors``."""

    def __init__(self, heights, title="vtkTerrain", colors=COLORS[0]):
        self.viewer = Viewer(heights)
        self.viewer.set_colors(colors)
        self.server = get_server(f"vtkterrain-{secrets.token_hex(4)}", client_type="vue3")
        self.token = secrets.token_urlsafe(24)
        self._area = None
        self._handler = None
        state = self.server.state
        state.trame__title = title
        state.update({"exaggeration": 1.0, "technique": TECHNIQUES[0], "colors": colors, "contours": False,
                      "azimuth": 315, "altitude": 45, "picked": _HELP, "pointer": "mouse", "folded": False})
        window = RemoteWindow(self.viewer, self._picked, lambda: state.pointer == "touch")
        self._build(title, window)
        for names, setter in ((("exaggeration",), self.viewer.set_exaggeration),
                              (("technique",), self.viewer.set_technique),
                              (("colors",), self.viewer.set_colors),
                              (("contours",), self.viewer.set_contours),
                              (("azimuth", "altitude"), self.viewer.set_sun),
                              (("folded",), lambda folded: self.viewer.cover(0 if folded else _PANEL))):
            state.change(*names)(self._applying(names, setter))

    def _applying(self, names, setter):
        def apply(**_):
            setter(*(self.server.state[name] for name in names))
            self._handler.schedule_render()

        return apply

    def _picked(self, text):
        with self.server.state as state:
            state.picked = text

    def _key(self, key, role):
        """A key, and the role of the control that it went to."""
        if key in (*_KEYS, "+", "=", "-") and role in ("slider", "combobox"):
            return
        with self.server.state as state:
            if key in _KEYS:
                self.viewer.turn(*_KEYS[key])
            elif key in ("+", "=", "-"):
                self.viewer.zoom(1 / 1.15 if key == "-" else 1.15)
            elif key == "r":
                self.viewer.reset_view()
            elif key == "c":
                state.contours = not state.contours
            elif key == "t":
                state.technique = TECHNIQUES[(TECHNIQUES.index(state.technique) + 1) % len(TECHNIQUES)]
            else:
                return
        self._handler.schedule_render()

    def _reset(self):
        self.viewer.reset_view()
        self._handler.schedule_render()

    def _build(self, title, window):
        with VAppLayout(self.server) as layout, layout.root:
            client.Style("html, body { overflow: hidden; margin: 0 } .v-field__input { padding-top: 14px } "
                         ".v-container:focus { outline: none }")
            with vuetify.VContainer(fluid=True, classes="pa-0 fill-height", style="height: 100vh; position: relative",
                                    tabindex=0, pointerdown="pointer = $event.pointerType",
                                    keydown=(self._key, _KEY_AND_ROLE), mounted=_ON_SHOW,
                                    __events=[("pointerdown", "pointerdown.capture"), ("mounted", "vue:mounted"),
                                              "keydown"]):
                self._area = rca.RemoteControlledArea(
                    name="terrain", display="image", send_mouse_move=False, event_throttle_ms=20,
                    image_style=("{ width: '100%', height: '100%' }",),
                    style="width: 100%; height: 100%; position: absolute; touch-action: none")
                self._controls(title)
        self._handler = RcaViewAdapter(window, "terrain", scheduler=Scheduler(window))
        self._area.add_view_handler(self._handler)

    def _controls(self, title):
        with vuetify.VCard(classes="pa-3", width=("folded ? 'auto' : 250",), variant="elevated", id="panel",
                           style="position: absolute; top: 8px; right: 8px; opacity: 0.92; overflow-y: auto; "
                                 "max-width: calc(100vw - 16px); max-height: calc(100vh - 16px)"):
            with html.Div(style="display: flex; align-items: center; gap: 8px"):
                html.Div(title, classes="text-subtitle-1 text-truncate", style="flex: 1 1 0", v_show="!folded")
                vuetify.VBtn("?", click=(self._picked, repr([_HELP])), size="x-small", id="help", title="Help")
                vuetify.VBtn("{{ folded ? 'Settings' : 'Fold' }}", click="folded = !folded", size="x-small", id="fold")
            with html.Div(v_show="!folded", classes="mt-2"):
                self._sliders()
                vuetify.VSelect(v_model=("technique",), items=("techniques", list(TECHNIQUES)), label="Technique",
                                hide_details=True, density="compact", classes="mt-2")
                palettes = dict.fromkeys((*COLORS, *scheme_names(), self.server.state.colors))
                vuetify.VSelect(v_model=("colors",), items=("palettes", list(palettes)), label="Colours",
                                hide_details=True, density="compact", classes="mt-2")
                vuetify.VSwitch(v_model=("contours",), label="Contours", hide_details=True, density="compact",
                                color="primary", classes="ml-1")
                vuetify.VBtn("Whole terrain", click=self._reset, block=True, size="small", id="reset")
        with vuetify.VSheet(classes="px-3 py-1 text-body-2", id="picked",
                            style="position: absolute; left: 8px; bottom: 8px; opacity: 0.9; "
                                  "max-width: calc(100% - 16px)"):
            html.Div("{{ picked }}", style="white-space: pre-wrap")

    @staticmethod
    def _sliders():
        for name, words, low, high, step in (("exaggeration", "Heights x {{ exaggeration }}", 0.5, 5, 0.1),
                                             ("azimuth", "Sun from {{ azimuth }}\N{DEGREE SIGN}", 0, 360, 5),
                                             ("altitude", "Sun above {{ altitude }}\N{DEGREE SIGN}", 5, 90, 5)):
            html.Div(words, classes="text-body-2")
            vuetify.VSlider(v_model=(name,), min=low, max=high, step=step, hide_details=True, density="compact")

    def start(self, host="127.0.0.1", port=0, open_browser=True, on_ready=print):
        """Serves until it is interrupted; ``on_ready`` gets the address once there is an answer."""
        hush_lost_connections()
        port = free_port(host, port)
        address = f"http://{f'[{host}]' if ':' in host else host}:{port}/?token={self.token}"

        def bind(server):
            server.app.middlewares.append(guard(self.token, f"vtkterrain-{port}"))

        def ready(**_):
            on_ready(address)
            if open_browser:
                import webbrowser

                webbrowser.open(address)

        self.server.controller.on_server_bind.add(bind)
        self.server.controller.on_server_ready.add(ready)
        self.server.start(port=port, host=host, open_browser=False, show_connection_info=False, timeout=0)
