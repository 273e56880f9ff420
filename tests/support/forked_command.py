"""The command, or a script, in a process of its own that need not start from nothing.

To import all that the command may need takes longer than most commands do. So one process
imports it once, and every command asked of it is a fork of it: with its own limits, its own
signals, its own end. What the start itself does is tested where real processes start.
"""

from __future__ import annotations

import gc
import importlib
import json
import os
import pkgutil
import runpy
import signal
import socket
import subprocess
import sys
from concurrent.futures import Future, ThreadPoolExecutor
from concurrent.futures import TimeoutError as TooLong
from pathlib import Path
from typing import Any

from inspected_plans import inspect_every_plan

HEAVY = (
    "fontTools.subset", "geopandas", "matplotlib.backends.backend_agg",
    "matplotlib.backends.backend_pdf", "matplotlib.backends.backend_svg", "pyarrow", "pyogrio",
)  # fmt: skip
"""What modules of the package import only when they work."""

LONGEST_S = 120
"""No command of a test takes longer than this [s]."""


class Running:
    """A command at work, or done."""

    def __init__(self, pid: int, status: Future[int], out: Future[str], err: Future[str]) -> None:
        self.pid = pid
        self._status, self._out, self._err = status, out, err

    def poll(self) -> int | None:
        return self._status.result() if self._status.done() else None

    def send_signal(self, number: int) -> None:
        if not self._status.done():
            os.kill(self.pid, number)

    def communicate(self, timeout: float = LONGEST_S) -> tuple[str, str]:
        """Return what it wrote to standard output and standard error, once it has ended."""
        try:
            self._status.result(timeout)
        except TooLong:
            raise subprocess.TimeoutExpired("platoon-osm", timeout) from None
        return self.stdout, self.stderr

    @property
    def returncode(self) -> int:
        return self._status.result(LONGEST_S)

    @property
    def stdout(self) -> str:
        return self._out.result(LONGEST_S)

    @property
    def stderr(self) -> str:
        return self._err.result(LONGEST_S)


class Mother:
    """The process with everything imported, whose forks are the commands, one at a time."""

    def __init__(self, root: Path) -> None:
        self._line, theirs = socket.socketpair()
        self._process = subprocess.Popen(
            [sys.executable, __file__, str(theirs.fileno())], pass_fds=[theirs.fileno()],
            env={**os.environ, "PYTHONPATH": str(root)},
        )  # fmt: skip
        theirs.close()
        self._answers = self._line.makefile()
        self._watch = ThreadPoolExecutor(max_workers=3)

    def start(
        self,
        *arguments: str,
        largest: int | None = None,
        out: Any = None,
        script: Path | None = None,
        folder: Path | None = None,
    ) -> Running:
        """Start the command in the folder where the test is.

        Parameters
        ----------
        *arguments : str
            As typed.
        largest : int, optional
            Bytes that a file may have at most; a write beyond it fails as on a disk that is full.
        out : file, optional
            What takes standard output.
        script : Path, optional
            A script to run instead of the command.
        folder : Path, optional
            Where to run it instead.
        """
        asked = {
            "arguments": arguments, "folder": str(folder or Path.cwd()), "largest": largest,
            "script": str(script) if script else None,
        }  # fmt: skip
        read, written = zip(os.pipe(), os.pipe(), strict=True)
        into = [out.fileno() if out else written[0], written[1]]
        socket.send_fds(self._line, [json.dumps(asked).encode()], into)
        for number in written:
            os.close(number)
        pid = self._answer()
        said = [self._watch.submit(Path(f"/dev/fd/{number}").read_text) for number in read]
        return Running(pid, self._watch.submit(self._answer), said[0], said[1])

    def run(self, *arguments: str, **how: Any) -> Running:
        """Start the command, and wait for its end."""
        running = self.start(*arguments, **how)
        running.communicate()
        return running

    def end(self) -> None:
        self._watch.shutdown()
        self._answers.close()
        self._line.close()
        self._process.wait()

    def _answer(self) -> int:
        return int(self._answers.readline())


def _serve(line: socket.socket) -> None:
    """Fork whenever asked; answer with the fork's number, and with its status when it has ended."""
    package = importlib.import_module("platoon_osm")
    for found in pkgutil.walk_packages(package.__path__, "platoon_osm."):
        if not found.name.endswith("__main__"):
            importlib.import_module(found.name)
    for name in HEAVY:
        importlib.import_module(name)
    inspect_every_plan()
    gc.freeze()  # so that no fork copies what is imported only to look for rubbish in it
    while True:
        text, files, _, _ = socket.recv_fds(line, 65_536, 2)
        if not text:
            return
        asked = json.loads(text)
        number = os.fork()
        if number == 0:
            line.close()
            _become(asked, files)
            if asked["script"]:
                _run(asked["script"], asked["arguments"])
                sys.exit(0)
            sys.exit(importlib.import_module("platoon_osm.cli").main(asked["arguments"]))
        for file in files:
            os.close(file)
        line.sendall(b"%d\n" % number)
        _, status = os.waitpid(number, 0)
        line.sendall(b"%d\n" % os.waitstatus_to_exitcode(status))


def _run(script: str, arguments: list[str]) -> None:
    """Run a script as Python does: it is the main module, and its folder comes first."""
    sys.argv = [script, *arguments]
    sys.path.insert(0, str(Path(script).parent))
    runpy.run_path(script, run_name="__main__")


def _become(asked: dict[str, Any], files: list[int]) -> None:
    """Take the folder, files and limits of the command that is asked for."""
    import resource

    os.chdir(asked["folder"])
    for number, file in ((0, os.open(os.devnull, os.O_RDONLY)), *zip((1, 2), files, strict=True)):
        os.dup2(file, number)
        os.close(file)
    # A stream remembers what kind of file it was made for.
    sys.stdout, sys.stderr = (os.fdopen(number, "w", encoding="utf-8") for number in (1, 2))
    if asked["largest"] is not None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        most = resource.getrlimit(resource.RLIMIT_FSIZE)[1]
        resource.setrlimit(resource.RLIMIT_FSIZE, (asked["largest"], most))


if __name__ == "__main__":
    _serve(socket.socket(fileno=int(sys.argv[1])))
