# SPDX-License-Identifier: MIT
"""The clients of others drive the ADS server: pyads (the vendor's own library), ads-client (npm).

What both read and write is right: the oracle of AD-1 … AD-6.
"""

from __future__ import annotations

import json
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from support.ads_wire import write

pytest.importorskip("pyads", reason="pyads needs a compiler, which is missing here")

pytestmark = pytest.mark.slow

FOLDER = Path(__file__).parent
LIMIT_S = 60.0

PROGRAM = """\
#RT CYCLE [ID=1 SCOPE=GLOBAL]
  $IF EDGE V.E.TRIGGER > 0
    V.E.COUNT_POS = V.E.COUNT_POS + 1
  $ENDIF
#RT CYCLE END
G01 X10 F600
M30
"""


def until(holds: Callable[[], bool]) -> None:
    """Wait until something holds."""
    end = time.monotonic() + LIMIT_S
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.005)


class Server:
    """``nctakt serve`` in a process of its own."""

    def __init__(self, folder: Path, *words: str) -> None:
        self.folder = folder
        self.program = folder / "part.nc"
        self.program.write_text(PROGRAM, "utf-8")
        ready = folder / "ready.json"
        command = [sys.executable, "-m", "nctakt", "serve", str(self.program)]
        self.process = subprocess.Popen(
            [*command, "--ads=127.0.0.1:0", f"--ready-file={ready}", "--quiet", *words],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        until(lambda: ready.exists() or self.process.poll() is not None)
        assert ready.exists(), self.process.communicate()
        address = json.loads(ready.read_text("utf-8"))["addresses"]["ads"]
        self.address, self.net_id = address.split("/")

    def end(self) -> tuple[int, str, str]:
        """End it as a service manager does; exit code and what it has printed."""
        self.process.send_signal(signal.SIGTERM)
        out, error = self.process.communicate(timeout=LIMIT_S)
        return self.process.returncode, out, error


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """A server whose run is on a tape."""
    folder = tmp_path_factory.mktemp("served")
    (folder / "back.nc").write_text("G01 X0 F6000\nM30\n", "utf-8")
    (folder / "there.nc").write_text("G01 X30 F6000\nM100\nG01 X60\nM30\n", "utf-8")
    found = Server(folder, "--pace=tick", f"--record={folder / 'run.tape'}", "--log=log.jsonl")
    yield found
    code, out, error = found.end()
    assert (code, error) == (0, "")
    assert out.startswith(f"ready ads={found.address}/")
    lines = [json.loads(line) for line in (folder / "log.jsonl").read_text("utf-8").splitlines()]
    assert lines[-1]["event"] == "closed"
    first = replayed(folder, "first.csv")
    assert first.count(b"\n") > 2
    assert replayed(folder, "second.csv") == first


def replayed(folder: Path, trace: str) -> bytes:
    """Return the trace of the run on the tape, run again."""
    signals = "V.E.COUNT_POS,V.E.TRIGGER,X.ACS.ACT_POS,PATH.SPEED"
    words = ["replay", "run.tape", "--trace", trace, "--signals", signals, "--quiet"]
    command = [sys.executable, "-m", "nctakt", *words]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return (folder / trace).read_bytes()


def test_the_library_of_the_vendor(server: Server) -> None:
    """pyads reads, writes, uploads and listens."""
    words = [sys.executable, "drive_pyads.py", server.address, server.net_id]
    done = subprocess.run(
        words, cwd=FOLDER, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert len(done.stdout.splitlines()) == 11


def test_ads_client_of_npm(server: Server, tmp_path: Path) -> None:
    """Another client reads structures by the uploaded types, writes, listens."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        pytest.skip("node and npm are not installed")
    for name in ("package.json", "drive_ads.js"):
        shutil.copy(FOLDER / name, tmp_path)
    words = ["npm", "install", "--no-audit", "--no-fund", "--no-package-lock", "--ignore-scripts"]
    try:
        installed = subprocess.run(
            words, cwd=tmp_path, capture_output=True, timeout=60, check=False
        )
    except subprocess.TimeoutExpired:
        pytest.skip("npm cannot install ads-client here")
    if installed.returncode:
        pytest.skip("npm cannot install ads-client here")
    host, port = server.address.split(":")
    driven = ["node", "drive_ads.js", host, port, server.net_id]
    done = subprocess.run(
        driven, cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.nightly
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no full disk to write to")
def test_a_full_disk_for_the_tape_is_told_at_the_end(tmp_path: Path) -> None:
    """Clients are served as ever; the end tells that the tape could not be written (900507)."""
    found = Server(tmp_path, "--record=/dev/full")
    with socket.create_connection(found.address.split(":")) as client:
        client.sendall(write(0x4040, 0, bytes(8)))
        assert len(client.recv(42)) == 42
    code, _, error = found.end()
    assert code == 2
    assert "900507" in error
