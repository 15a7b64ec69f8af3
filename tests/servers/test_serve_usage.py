# SPDX-License-Identifier: MIT
"""``nctakt serve``: wrong words and addresses; the page beside ADS, and the end by SIGTERM."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

from nctakt.cli import EXIT_USAGE, main


@pytest.mark.parametrize(
    ("words", "number"),
    [
        ([], 901353),
        (["--ads", "part.nc"], 901352),
        (["--ads=127.0.0.1:0", "--ads-net-id=1.2.3"], 901476),
        (["--ads=127.0.0.1:0", "--ads-permit=1.2.3.4.5.256"], 901476),
        (["--ads=0.0.0.0:0"], 902021),
        (["--ads=[::]:0"], 902021),
        (["--ads=somewhere:0", "--ads-permit=1.2.3.4.1.1"], 902021),
        (["--ads=127.0.0.1:0", "--ads-from=192.168.0.7/24"], 902020),
        (["--ads=127.0.0.1:0", "--ads-from=somewhere"], 902020),
        (["--live=127.0.0.1:0"], 901477),
    ],
)
def test_wrong_words_are_refused(
    words: list[str], number: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """Each has its message and exit code 2."""
    pytest.importorskip("nicegui")
    assert main(["serve", "--quiet", *words]) == EXIT_USAGE
    assert str(number) in capsys.readouterr().err


@pytest.mark.slow
def test_a_port_that_is_taken_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    """901351, and nothing is left open."""
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert main(["serve", "--quiet", f"--ads=127.0.0.1:{port}"]) == EXIT_USAGE
    assert "901351" in capsys.readouterr().err


@pytest.mark.nightly
@pytest.mark.slow
def test_the_page_shares_the_session_with_ads_until_sigterm(tmp_path: Path) -> None:
    """Both have an address in the ready file; SIGTERM ends all, and the tape is complete."""
    pytest.importorskip("nicegui")
    program, ready, tape = (tmp_path / name for name in ("part.nc", "ready.json", "run.tape"))
    program.write_text("G01 X10 F600\nM30\n", "utf-8")
    ready.write_text("addresses of an earlier start", "utf-8")
    words = [f"--ready-file={ready}", f"--record={tape}", "--live=127.0.0.1:0", "--quiet"]
    with subprocess.Popen(
        [sys.executable, "-m", "nctakt", "serve", str(program), "--ads=127.0.0.1:0", *words],
        env={name: value for name, value in os.environ.items() if not name.startswith("PYTEST")},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as process:
        end = time.monotonic() + 60.0
        texts = ["an earlier start"]
        while "earlier" in (texts[-1] or "earlier") and time.monotonic() < end:
            assert process.poll() is None
            time.sleep(0.02)
            texts.append(ready.read_text("utf-8") if ready.exists() else "")
        assert "" in texts  # whoever waits for the file does not find that of an earlier start
        addresses = json.loads(texts[-1])["addresses"]
        with urllib.request.urlopen(addresses["live"], timeout=60) as page:
            assert page.status == 200
        os.killpg(process.pid, signal.SIGTERM)  # as a shell, timeout and build servers do
        out, error = process.communicate(timeout=60)
    assert (process.returncode, error) == (0, "")
    assert out == f"ready ads={addresses['ads']} live={addresses['live']}\n"
    assert tape.read_text("utf-8").splitlines()[-1].startswith("{")


HANGING_PLC = """import time

from nctakt.plc import Plc, at


class Hangs(Plc):
    @at("0.1s")
    def wait(self, hli):
        time.sleep(3600)
"""


@pytest.mark.slow
def test_a_controller_that_hangs_does_not_hold_up_the_end(tmp_path: Path) -> None:
    """SIGTERM ends the command within seconds, with 901507, and the tape that there is."""
    program, plc, ready, tape = (
        tmp_path / name for name in ("part.nc", "plc.py", "ready.json", "run.tape")
    )
    program.write_text("G01 X10 F60\nM30\n", "utf-8")
    plc.write_text(HANGING_PLC, "utf-8")
    words = [f"--plc={plc}", f"--ready-file={ready}", f"--record={tape}", "--ads=127.0.0.1:0"]
    with subprocess.Popen(
        [sys.executable, "-m", "nctakt", "serve", str(program), *words],
        env={name: value for name, value in os.environ.items() if not name.startswith("PYTEST")},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        end = time.monotonic() + 60.0
        while not ready.exists() and time.monotonic() < end:
            assert process.poll() is None
            time.sleep(0.02)
        time.sleep(0.5)  # the PLC hangs by then; if not, the test proves less
        process.send_signal(signal.SIGTERM)
        _, error = process.communicate(timeout=60)
    assert process.returncode == EXIT_USAGE
    assert "901507" in error
    assert main(["replay", str(tape), "--quiet"]) == 0
