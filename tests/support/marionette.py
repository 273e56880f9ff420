"""Debian's Firefox by its own remote protocol, Marionette: JSON over a socket, no driver needed.

A message is its length, a colon and `[0, number, command, arguments]`; an answer is
`[1, number, error, result]`.
"""

from __future__ import annotations

import contextlib
import json
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path
from types import TracebackType
from typing import Any

FIREFOX = "/usr/bin/firefox-esr"
START_S = 60.0

# The network is cut: all goes to a proxy that nobody runs, and nothing is looked for by itself.
PREFERENCES: dict[str, object] = {
    "marionette.port": 0,
    "network.proxy.type": 1,
    "network.proxy.http": "127.0.0.1", "network.proxy.http_port": 9,
    "network.proxy.ssl": "127.0.0.1", "network.proxy.ssl_port": 9,
    "network.proxy.no_proxies_on": "",
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "app.update.enabled": False, "app.normandy.enabled": False,
    "browser.safebrowsing.malware.enabled": False, "browser.safebrowsing.phishing.enabled": False,
    "browser.safebrowsing.downloads.enabled": False,
    "browser.shell.checkDefaultBrowser": False, "browser.startup.page": 0,
    "browser.startup.homepage_override.mstone": "ignore",
    "datareporting.policy.dataSubmissionEnabled": False,
    "toolkit.telemetry.reportingpolicy.firstRun": False,
    "services.settings.server": "data:,", "extensions.update.enabled": False,
}  # fmt: skip


class Firefox:
    """A headless Firefox with a profile of its own; a context manager.

    Parameters
    ----------
    path : str
        Of the program.
    """

    def __init__(self, path: str = FIREFOX) -> None:
        self.profile = Path(tempfile.mkdtemp(prefix="firefox-"))
        lines = [f"user_pref({json.dumps(k)}, {json.dumps(v)});" for k, v in PREFERENCES.items()]
        (self.profile / "user.js").write_text("\n".join(lines))
        self.process = subprocess.Popen(
            [path, "--headless", "--no-remote", "--marionette", "--profile", str(self.profile)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self.number = 0
        try:
            self.socket = self._connected()
            self.stream = self.socket.makefile("rb")
            self._read()  # its greeting
            self.send("WebDriver:NewSession", {"capabilities": {}})
        except BaseException:
            self.close()
            raise

    def _connected(self) -> socket.socket:
        """Wait until it has written the port it listens at into its profile."""
        told = self.profile / "MarionetteActivePort"
        end = time.monotonic() + START_S
        while time.monotonic() < end and self.process.poll() is None:
            if told.exists() and (port := told.read_text().strip()):
                return socket.create_connection(("127.0.0.1", int(port)), timeout=START_S)
            time.sleep(0.05)
        raise RuntimeError("firefox did not start")

    def _read(self) -> Any:
        length = b""
        while (byte := self.stream.read(1)) != b":":
            if not byte:
                raise RuntimeError("firefox closed the connection")
            length += byte
        return json.loads(self.stream.read(int(length)))

    def send(self, command: str, arguments: dict[str, Any] | None = None) -> Any:
        """Send a command and return its result; an error of the browser is raised."""
        self.number += 1
        text = json.dumps([0, self.number, command, arguments or {}]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, result = self._read()
        if error:
            raise RuntimeError(f"{command}: {error['error']}: {error['message']}")
        return result

    def open(self, url: str, width: int, height: int) -> None:
        """Open an address in a window whose page has about this size."""
        self.send("WebDriver:SetWindowRect", {"width": width, "height": height})
        self.send("WebDriver:Navigate", {"url": url})

    def evaluate(self, function: str, *arguments: Any) -> Any:
        """Call a function, given as a text, in the page and return its result."""
        script = f"return ({function}).apply(null, arguments)"
        sent = {"script": script, "args": list(arguments), "sandbox": None, "newSandbox": False}
        return self.send("WebDriver:ExecuteScript", sent)["value"]

    def picture(self, path: Path) -> None:
        """Save what is seen as a PNG."""
        import base64

        made = self.send("WebDriver:TakeScreenshot", {"full": False})
        path.write_bytes(base64.b64decode(made["value"]))

    def close(self) -> None:
        """End it and remove its profile."""
        if hasattr(self, "socket"):
            with contextlib.suppress(OSError, RuntimeError):
                self.send("Marionette:Quit", {"flags": ["eForceQuit"]})
            self.socket.close()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def __enter__(self) -> Firefox:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
