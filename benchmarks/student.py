"""A simulated student: logs in to a hub, runs a lesson and drags sliders, as a browser does.

What a browser sends is sent: the pages of the login, the notebook's session, its cells over the
kernel's websocket, and the messages of sliders. It only paints nothing.
"""
from __future__ import annotations

import json
import time
import uuid
from collections.abc import Iterator
from dataclasses import dataclass, field

import requests
import websocket

WAIT = 300  # seconds for anything to happen
KINLAB_SECONDS = 0.1  # between two messages of a slider: kinlab/browser/widget.js, TELL
BROWSER_SECONDS = 1 / 60  # ipywidgets alone: at each movement, once the last one is answered


@dataclass
class Drag:
    """What one drag of a slider sent, and when it was answered (seconds)."""

    echoes: list[float] = field(default_factory=list)  # until Python had the value
    done: list[float] = field(default_factory=list)  # until all it did was done


def sliders_in(state: dict) -> list[tuple[str, float, float]]:
    """Trait, lowest and highest value of the sliders of a widget: its own, or those of a view."""
    if "Slider" in (state.get("_view_name") or ""):
        return [("value", state["min"], state["max"])]
    return [(knob["name"], knob["low"] / knob["scale"], knob["high"] / knob["scale"])
            for knob in state.get("scene", {}).get("knobs", [])]


class Student:
    """One login with its own server and kernel."""

    def __init__(self, hub: str, name: str) -> None:
        self.hub, self.name, self.home = hub, name, f"{hub}/user/{name}"
        self.web, self.session = requests.Session(), uuid.uuid4().hex
        self.sliders: list[tuple[str, str, float, float]] = []

    def log_in(self) -> None:
        """Log in and wait for the server, as the hub's pages do."""
        self._get(f"{self.hub}/hub/login")
        reply = self.web.post(f"{self.hub}/hub/login", timeout=WAIT, params=self._token("/hub/"),
                              data={"username": self.name, "password": self.name})
        reply.raise_for_status()
        self._get(f"{self.hub}/hub/spawn/{self.name}")
        progress = f"{self.hub}/hub/api/users/{self.name}/server/progress"
        with self._get(progress, params=self._token("/hub/"), stream=True) as events:
            news = [json.loads(line[5:]) for line in events.iter_lines() if line[:5] == b"data:"]
        if not news[-1].get("ready"):
            raise RuntimeError(f"{self.name}: {news[-1].get('message')}")
        self._get(f"{self.home}/lab")

    def open_kernel(self, path: str) -> None:
        """Start the kernel of a notebook and connect to it."""
        order = {"path": path, "name": path, "type": "notebook", "kernel": {"name": "python3"}}
        token = {"X-XSRFToken": self._token(f"/user/{self.name}/")["_xsrf"]}
        reply = self.web.post(f"{self.home}/api/sessions", json=order, headers=token, timeout=WAIT)
        reply.raise_for_status()
        kernel = f"{self.home}/api/kernels/{reply.json()['kernel']['id']}/channels"
        cookies = "; ".join(f"{c.name}={c.value}" for c in self.web.cookies
                            if f"/user/{self.name}/".startswith(c.path))
        self.socket = websocket.create_connection(
            f"ws{kernel[4:]}?session_id={self.session}", cookie=cookies, timeout=WAIT)

    def run(self, code: str) -> str:
        """Run a cell; what it prints. Sliders that it makes are noted."""
        content = {"code": code, "silent": False, "store_history": True, "allow_stdin": False,
                   "user_expressions": {}, "stop_on_error": True}
        printed = ""
        for message in self._answers(self._send("execute_request", content)):
            told = message["content"]
            if message["msg_type"] == "error":
                raise RuntimeError(f"{self.name}: {told['ename']}: {told['evalue']}")
            printed += told.get("text", "") if message["msg_type"] == "stream" else ""
            state = told.get("data", {}).get("state", {})
            if message["msg_type"] == "comm_open":
                self.sliders += [(told["comm_id"], *slider) for slider in sliders_in(state)]
        return printed

    def drag(self, slider: int, seconds: float, pause: float) -> Drag:
        """Pull a slider to and fro; the next value waits for the last answer, and `pause`."""
        comm, trait, low, high = self.sliders[slider]
        drag, began = Drag(), time.perf_counter()
        while (sent := time.perf_counter()) < began + seconds:
            share = abs(1 - (sent - began) / seconds * 2)
            state = {trait: round(low + (high - low) * share, 6)}
            request = self._send("comm_msg", {"comm_id": comm, "data": {
                "method": "update", "state": state, "buffer_paths": []}})
            for message in self._answers(request):
                if message["content"].get("data", {}).get("method") == "echo_update":
                    drag.echoes.append(time.perf_counter() - sent)
            drag.done.append(time.perf_counter() - sent)
            time.sleep(max(0, sent + pause - time.perf_counter()))
        return drag

    def close(self) -> None:
        self.socket.close()
        self.web.close()

    def _get(self, url: str, **options) -> requests.Response:
        reply = self.web.get(url, timeout=WAIT, **options)
        reply.raise_for_status()
        return reply

    def _token(self, path: str) -> dict[str, str]:
        return {"_xsrf": next(c.value for c in self.web.cookies
                              if c.name == "_xsrf" and c.path == path)}

    def _send(self, kind: str, content: dict) -> str:
        header = {"msg_id": uuid.uuid4().hex, "msg_type": kind, "session": self.session,
                  "username": self.name, "version": "5.3", "date": ""}
        self.socket.send(json.dumps({"header": header, "parent_header": {}, "metadata": {},
                                     "content": content, "channel": "shell", "buffers": []}))
        return header["msg_id"]

    def _answers(self, request: str) -> Iterator[dict]:
        """Every message that a request brings, until the kernel is idle again."""
        while True:
            text = self.socket.recv()
            if not isinstance(text, str):
                continue  # binary: only messages with buffers
            message = json.loads(text)
            if message["parent_header"].get("msg_id") != request:
                continue
            yield message
            if message["content"].get("execution_state") == "idle":
                return
