# SPDX-License-Identifier: MIT
"""The clients of others drive the ADS server: pyads (the vendor's own library), ads-client (npm).

What both read and write is right: the oracle of AD-1 … AD-6.
"""

from __future__ import annotations

import json
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from support.ads_server import Server, drive_with_npm
from support.ads_wire import write

pytest.importorskip("pyads", reason="pyads needs a compiler, which is missing here")

pytestmark = pytest.mark.slow

FOLDER = Path(__file__).parent


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
    drive_with_npm(server, "drive_ads.js", tmp_path)


@pytest.mark.nightly
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no full disk to write to")
def test_a_full_disk_for_the_tape_is_reported_at_the_end(tmp_path: Path) -> None:
    """Clients are served as ever; the end reports that the tape could not be written (900507)."""
    found = Server(tmp_path, "--record=/dev/full")
    with socket.create_connection(found.address.split(":")) as client:
        client.sendall(write(0x4040, 0, bytes(8)))
        assert len(client.recv(42)) == 42
    code, _, error = found.end()
    assert code == 2
    assert "900507" in error
