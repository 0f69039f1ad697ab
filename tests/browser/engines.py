"""One page of Firefox, of WebKit or of Chromium, by the same few words.

    with open_engine("webkit") as page:
        page.open(path.as_uri())
        page.press("ArrowRight", on="input[type=range]")
        page.drag([(100, 100), (140, 100)])

Firefox speaks WebDriver BiDi by itself, WebKitGTK's small browser speaks WebDriver through
WebKitWebDriver: both take the same actions of keys and pointers. Chromium is Playwright's. What a
machine or an engine lacks raises `Missing`.
"""
from __future__ import annotations

import base64
import json
import os
import re
import shutil
import socket
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from glob import glob
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest
from lab import open_browser
from playwright.sync_api import Error
from reading import SETTLE

SECONDS = 120      # more than any page takes, on any machine
WIRE = 240         # and than any command to a browser
A4 = (717, 1000)   # px: a sheet within a browser's usual margins
# px. The window that has the pointer has the focus, and the pointer is in the middle.
SCREEN = (2000, 2400)
MINI_BROWSER = "/usr/lib/*/webkit2gtk-4.*/MiniBrowser"
KEYS = {"Shift": "\ue008", "Control": "\ue009", "Tab": "\ue004", "Enter": "\ue007",
        "Escape": "\ue00c", "Space": " ", "PageUp": "\ue00e", "PageDown": "\ue00f",
        "End": "\ue010", "Home": "\ue011", "ArrowLeft": "\ue012", "ArrowUp": "\ue013",
        "ArrowRight": "\ue014", "ArrowDown": "\ue015", "Backspace": "\ue003"}

# What a page calls in vain, from its first line on; `errors` of a page reads it.
WATCH = """<script>
window.troubles = [];
addEventListener("error", event => {     // a loop only puts off what it tells
    if (!/^ResizeObserver loop/.test(event.message)) troubles.push(event.message);
}, true);
addEventListener("unhandledrejection", event => troubles.push(String(event.reason)));
console.error = (...words) => troubles.push(words.join(" "));
</script>"""

_WAIT = """async (found, ...given) => {{
    for (let n = 0; n < {tries}; n++) {{
        if (await found(...given)) return true;
        await new Promise(done => setTimeout(done, 30));
    }}
    return false;
}}"""
_FINGERS = """(ways) => {
    const at = ways.map(([[x, y]]) => document.elementFromPoint(x, y));
    const tell = (kind, step) => ways.forEach((way, k) => {
        const [clientX, clientY] = way[step], all = {clientX, clientY, bubbles: true,
            cancelable: true, composed: true, pointerType: 'touch', isPrimary: !k, pointerId: 1};
        at[k].dispatchEvent(new PointerEvent(`pointer${kind}`, all));
    });
    tell('down', 0);
    ways[0].forEach((_, step) => tell('move', step));
    tell('up', ways[0].length - 1);
}"""

# Without a window Firefox has neither a mouse nor the focus, unless it is told so.
PREFERENCES = """
user_pref("ui.primaryPointerCapabilities", 6);
user_pref("ui.allPointerCapabilities", 6);
user_pref("focusmanager.testmode", true);
"""

Spot = Sequence[float]


class Missing(Exception):
    """This machine has no such browser, or the browser cannot do this."""


class Engine:
    """A page: what all engines do in the same way, by what each of them does in its own."""

    name: str

    def evaluate(self, function: str, *given: Any) -> Any:
        """What a function of JavaScript gives, once it is there."""
        told = json.loads(self._run(
            f"Promise.resolve().then(() => ({function})(...{json.dumps(given)}))"
            ".then(value => JSON.stringify({value}),"
            " error => JSON.stringify({error: String(error)}))"))
        if "error" in told:
            raise AssertionError(told["error"])
        return told.get("value")

    def wait(self, function: str, *given: Any) -> None:
        """Wait until a function gives something true."""
        wait = _WAIT.format(tries=SECONDS * 1000 // 30)
        if not self.evaluate(f"(...given) => ({wait})({function}, ...given)", *given):
            raise AssertionError(f"never true in {self.name}: {function} {given}")

    def box(self, selector: str, nth: int = 0) -> tuple[float, float, float, float]:
        """Where an element is in the window: left, top, width, height (px)."""
        return self.evaluate("""(selector, nth) => {
            const node = [...document.querySelectorAll(selector)].at(nth);
            node.scrollIntoView({block: 'nearest'});
            const {x, y, width, height} = node.getBoundingClientRect();
            return [x, y, width, height];
        }""", selector, nth)

    def middle(self, selector: str, nth: int = 0) -> tuple[float, float]:
        x, y, width, height = self.box(selector, nth)
        return x + width / 2, y + height / 2

    def text(self, selector: str) -> str:
        """The words of the first such element that is seen; "" if there is none."""
        return self.evaluate("""selector => [...document.querySelectorAll(selector)]
            .find(node => node.checkVisibility())?.textContent ?? ''""", selector)

    def click(self, selector: str, nth: int = 0) -> None:
        self.drag([self.middle(selector, nth)])

    def press(self, *keys: str, on: str = "") -> None:
        """Press keys one after the other, such as "a" or "Shift+Tab", on an element if one is
        named."""
        if on:
            self.evaluate("selector => document.querySelector(selector).focus()", on)
        for key in keys:
            *held, last = [KEYS.get(one, one) for one in re.split(r"(?<=.)\+", key)]
            down = [{"type": "keyDown", "value": one} for one in [*held, last]]
            up = [{"type": "keyUp", "value": one} for one in [last, *held]]
            self._act({"type": "key", "id": "keys", "actions": down + up})

    def drag(self, way: Sequence[Spot]) -> None:
        """Press the mouse at the first spot of a way, go along it, and let go."""
        self._act(_pointer("mouse", way))

    def touch(self, *ways: Sequence[Spot]) -> None:
        """The same with fingers, a way for each."""
        self._act(*(_pointer("touch", way, k) for k, way in enumerate(ways)))

    def turn_wheel(self, spot: Spot, by: int) -> None:
        x, y = map(round, spot)
        self._act({"type": "wheel", "id": "wheel", "actions": [
            {"type": "scroll", "x": x, "y": y, "deltaX": 0, "deltaY": by}]})

    def errors(self) -> list[str]:
        """What has gone wrong in a page that begins with WATCH."""
        return self.evaluate("() => window.troubles")

    # What each engine does in its own way.

    def _photo(self) -> bytes:
        raise NotImplementedError

    def open(self, url: str) -> None:
        raise NotImplementedError

    def resize(self, width: int, height: int) -> None:
        raise NotImplementedError

    def look(self, theme: str) -> None:
        """Pages that are opened from now on are in a "light" or a "dark" system."""
        raise NotImplementedError

    def paper(self, on: bool) -> None:
        """Lay the page out as it is printed."""
        raise NotImplementedError

    def pdf(self) -> bytes:
        raise Missing(f"{self.name} prints no PDF without a window")

    def photo(self) -> bytes:
        """What is in the window, as PNG, once it has been painted."""
        self.settle()
        return self._photo()

    def settle(self) -> None:
        """Wait until what was asked for has been painted."""
        self.evaluate(SETTLE)

    def _run(self, promise: str) -> str:
        raise NotImplementedError

    def _act(self, *sources: dict) -> None:
        raise NotImplementedError


def _pointer(kind: str, way: Sequence[Spot], k: int = 0) -> dict:
    """A pointer's actions, as WebDriver has them; it comes to the first spot before it presses."""
    moves = [{"type": "pointerMove", "x": round(x), "y": round(y)} for x, y in way]
    return {"type": "pointer", "id": f"{kind}-{k}", "parameters": {"pointerType": kind},
            "actions": [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:],
                        {"type": "pointerUp", "button": 0}]}


class Firefox(Engine):
    name = "firefox"

    def __init__(self, address: str) -> None:
        from websocket import create_connection

        # Without an origin: Firefox refuses pages, and it takes that for one.
        self.wire = create_connection(f"{address}/session", suppress_origin=True, timeout=WIRE)
        self.sent = 0
        self.logged: list[str] = []
        self.call("session.new", capabilities={})
        self.call("session.subscribe", events=["log.entryAdded"])
        self.context = self._tree()
        self.inside = self._tree(**{"moz:scope": "chrome"})
        self.resize(1280, 800)

    def call(self, method: str, **given: Any) -> dict:
        """A command of WebDriver BiDi, and what it gives."""
        self.sent += 1
        self.wire.send(json.dumps({"id": self.sent, "method": method, "params": given}))
        while (told := json.loads(self.wire.recv())).get("id") != self.sent:
            if told.get("params", {}).get("level") == "error":
                self.logged.append(told["params"]["text"])
        if told["type"] == "error":
            raise AssertionError(f"{method}: {told['error']}: {told['message']}")
        return told["result"]

    def open(self, url: str) -> None:
        self.call("browsingContext.navigate", context=self.context, url=url, wait="complete")
        self._chrome("gBrowser.selectedBrowser.focus()")   # not the field of its address

    def resize(self, width: int, height: int) -> None:
        self.call("browsingContext.setViewport", context=self.context,
                  viewport={"width": width, "height": height})

    def look(self, theme: str) -> None:
        self._chrome("Services.prefs.setIntPref('layout.css.prefers-color-scheme.content-override',"
                     f"{int(theme == 'light')})")

    def paper(self, on: bool) -> None:
        medium = "print" if on else ""
        self._chrome(f"gBrowser.selectedBrowser.browsingContext.mediumOverride = '{medium}'")

    def pdf(self) -> bytes:
        return base64.b64decode(self.call("browsingContext.print", context=self.context)["data"])

    def _photo(self) -> bytes:
        return base64.b64decode(
            self.call("browsingContext.captureScreenshot", context=self.context)["data"])

    def _tree(self, **scope: str) -> str:
        return self.call("browsingContext.getTree", **scope)["contexts"][0]["context"]

    def _chrome(self, script: str) -> None:
        """Run a script with the rights of the browser itself."""
        self._script(f"{script}; ''", self.inside)

    def _run(self, promise: str) -> str:
        return self._script(promise, self.context)

    def _script(self, expression: str, context: str) -> str:
        told = self.call("script.evaluate", expression=expression, target={"context": context},
                         awaitPromise=True)
        if told["type"] == "exception":
            raise AssertionError(told["exceptionDetails"]["text"])
        return told["result"]["value"]

    def _act(self, *sources: dict) -> None:
        self.call("input.performActions", context=self.context, actions=list(sources))
        self.call("input.releaseActions", context=self.context)


class WebKit(Engine):
    """WebKitGTK's MiniBrowser. It has no real fingers (they are told to the page as events), and
    prints nothing: the rules of its styles for paper are put in force instead."""

    name = "webkit"

    def __init__(self) -> None:
        self.room = ExitStack()
        self.size = (1280, 800)
        self._begin()

    def call(self, method: str, path: str, **given: Any) -> Any:
        """A command of WebDriver, and what it gives."""
        return _asked(method, self.address + path, given)

    def close(self) -> None:
        self.room.close()

    def open(self, url: str) -> None:
        self.call("POST", "/url", url=url)

    def resize(self, width: int, height: int) -> None:
        self.size = width, height
        for _ in range(WIRE * 10):      # it may be on its way back from the full screen
            self.call("POST", "/window/rect", width=width, height=height,
                      x=(SCREEN[0] - width) // 2, y=(SCREEN[1] - height) // 2)
            if self.evaluate("() => [innerWidth, innerHeight]") == [width, height]:
                return
            time.sleep(0.1)
        raise AssertionError(f"no window of {width} x {height} px")

    def look(self, theme: str) -> None:
        self.room.close()
        self._begin(*["--dark-mode"] * (theme == "dark"))

    def paper(self, on: bool) -> None:
        self.evaluate("""on => {
            const turn = rule => {
                const media = rule.media?.mediaText ?? '';
                rule.screen ??= media;
                if (/print/.test(rule.screen)) rule.media.mediaText = on ? 'all' : rule.screen;
                if (/^screen/.test(rule.screen)) {
                    rule.media.mediaText = on ? 'not all' : rule.screen;
                }
                [...rule.cssRules ?? []].forEach(turn);
            };
            [...document.styleSheets].forEach(turn);
        }""", on)

    def _photo(self) -> bytes:
        return base64.b64decode(self.call("GET", "/screenshot"))

    def touch(self, *ways: Sequence[Spot]) -> None:
        self.evaluate(_FINGERS, [[list(map(float, spot)) for spot in way] for way in ways])

    def _begin(self, *options: str) -> None:
        driver = self.room.enter_context(_web_driver())
        # Else it keeps to itself what is wrong in a script that comes from the disk.
        browser = {"binary": _found(MINI_BROWSER), "args": [
            "--automation", "--allow-universal-access-from-file-urls=true", *options]}
        told = _asked("POST", f"{driver}/session", {"capabilities": {"alwaysMatch": {
            "timeouts": {"script": 1000 * WIRE}, "webkitgtk:browserOptions": browser}}})
        self.address = f"{driver}/session/{told['sessionId']}"
        self.room.callback(self.call, "DELETE", "")
        self._pop_up()
        self.resize(*self.size)

    def _pop_up(self) -> None:
        """Go on in a window without a toolbar, which may be as narrow as a phone."""
        first = self.call("GET", "/window")
        self.open("data:text/html,<body onclick=\"open('about:blank', '', 'popup')\">"
                  "<p style='height: 400px'>Open")
        self.drag([(50, 50)])
        while not (others := set(self.call("GET", "/window/handles")) - {first}):
            time.sleep(0.05)
        self.call("POST", "/window", handle=others.pop())

    def _run(self, promise: str) -> str:
        return self.call("POST", "/execute/async", args=[],
                         script=f"const [done] = arguments; ({promise}).then(done)")

    def _act(self, *sources: dict) -> None:
        self.call("POST", "/actions", actions=list(sources))
        self.call("DELETE", "/actions")


class Chromium(Engine):
    name = "chromium"

    def __init__(self, browser: Any) -> None:
        self.page = browser.new_page(viewport={"width": 1280, "height": 800})
        self.wire = self.page.context.new_cdp_session(self.page)

    def open(self, url: str) -> None:
        self.page.goto("about:blank")   # another end of the same address is another page
        self.page.goto(url)

    def resize(self, width: int, height: int) -> None:
        self.page.set_viewport_size({"width": width, "height": height})

    def look(self, theme: str) -> None:
        self.page.emulate_media(color_scheme=theme)

    def paper(self, on: bool) -> None:
        self.page.emulate_media(media="print" if on else "screen")

    def pdf(self) -> bytes:
        return self.page.pdf()

    def _photo(self) -> bytes:
        return self.page.screenshot()

    def press(self, *keys: str, on: str = "") -> None:
        if on:
            self.page.focus(on)
        for key in keys:
            self.page.keyboard.press(key)

    def drag(self, way: Sequence[Spot]) -> None:
        self.page.mouse.move(*way[0])
        self.page.mouse.down()
        for spot in way[1:]:
            self.page.mouse.move(*spot)
        self.page.mouse.up()

    def touch(self, *ways: Sequence[Spot]) -> None:
        for step, spots in enumerate(zip(*ways)):
            self._fingers("Move" if step else "Start", spots)
        self._fingers("End", ())

    def turn_wheel(self, spot: Spot, by: int) -> None:
        self.page.mouse.move(*spot)
        self.page.mouse.wheel(0, by)

    def _fingers(self, kind: str, spots: Sequence[Spot]) -> None:
        self.wire.send("Input.dispatchTouchEvent", {"type": f"touch{kind}", "touchPoints": [
            {"x": x, "y": y, "id": k} for k, (x, y) in enumerate(spots)]})

    def _run(self, promise: str) -> str:
        return self.page.evaluate(promise)


# ---- the programs ----


@contextmanager
def open_engine(name: str) -> Iterator[Engine]:
    """A page of "firefox", "webkit" or "chromium"."""
    with {"firefox": _firefox, "webkit": _webkit, "chromium": _chromium}[name]() as page:
        yield page


def engine_or_skip(name: str) -> Iterator[Engine]:
    """For a fixture: where there is none its tests skip, unless KINLAB_REQUIRE_BROWSER is 1."""
    with ExitStack() as room:
        try:
            page = room.enter_context(open_engine(name))
        except Missing as error:
            if os.environ.get("KINLAB_REQUIRE_BROWSER") == "1":
                pytest.fail(f"KINLAB_REQUIRE_BROWSER=1 but there is {error}")
            pytest.skip(f"there is {error}: install chromium, firefox-esr, webkit2gtk-driver, xvfb")
        yield page


@contextmanager
def _firefox() -> Iterator[Firefox]:
    program = _found("firefox-esr", "firefox")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        Path(profile, "user.js").write_text(PREFERENCES)
        command = [program, "--headless", "--no-remote", "--profile", profile,
                   "--remote-debugging-port", "0", "--remote-allow-system-access"]
        with _running(command, stderr=subprocess.PIPE, text=True) as firefox:
            said = (re.search(r"BiDi listening on (ws\S+)", line) for line in firefox.stderr)
            page = Firefox(next(filter(None, said))[1])
            # It stops when nobody reads what it says.
            threading.Thread(target=firefox.stderr.read, daemon=True).start()
            yield page
            page.call("browser.close")
            firefox.wait(SECONDS)


@contextmanager
def _webkit() -> Iterator[WebKit]:
    page = WebKit()
    try:
        yield page
    finally:
        page.close()


@contextmanager
def _chromium() -> Iterator[Chromium]:
    opened = open_browser()
    try:
        browser = opened.__enter__()
    except Error as error:
        raise Missing(f"no Chromium that starts: {error.message}") from None
    with ExitStack() as room:
        room.push(opened)
        yield Chromium(browser)


@contextmanager
def _web_driver() -> Iterator[str]:
    """WebKitWebDriver on a screen of its own; its address."""
    program, port = _found("WebKitWebDriver"), _free_port()
    with ExitStack() as room:
        screen = room.enter_context(_screen())
        # Its sandbox needs rights that a container does not have.
        room.enter_context(_running([program, f"--port={port}"], env=os.environ | {
            "DISPLAY": screen, "GDK_BACKEND": "x11", "NO_AT_BRIDGE": "1",
            "WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS": "1"}))
        while not _listens(port):
            time.sleep(0.05)
        yield f"http://127.0.0.1:{port}"


@contextmanager
def _screen() -> Iterator[str]:
    """An X screen that nobody sees; its name."""
    read, write = os.pipe()
    command = [_found("Xvfb"), "-displayfd", str(write), "-screen", "0",
               "{}x{}x24".format(*SCREEN), "-nolisten", "tcp"]
    with _running(command, stderr=subprocess.DEVNULL, pass_fds=[write]), os.fdopen(read) as told:
        os.close(write)
        yield f":{told.readline().strip()}"


@contextmanager
def _running(command: list[str], **options: Any) -> Iterator[subprocess.Popen]:
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, **options)
    try:
        yield process
    finally:
        process.terminate()
        process.wait(SECONDS)


def _found(*names: str) -> str:
    for name in names:
        for path in [shutil.which(name), *sorted(glob(name))]:
            if path:
                return path
    raise Missing(f"no {' or '.join(Path(name).name for name in names)} on this machine")


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def _listens(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def _asked(method: str, url: str, given: dict) -> Any:
    body = json.dumps(given).encode() if method == "POST" else None
    try:
        with urlopen(Request(url, body, {"Content-Type": "application/json"}, method=method),
                     timeout=WIRE) as told:
            return json.load(told)["value"]
    except HTTPError as error:
        raise AssertionError(f"{method} {url}: {error.read().decode()}") from None
