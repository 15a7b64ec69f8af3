# SPDX-License-Identifier: MIT
"""``nctakt run --hli`` says what it waits for, and again when that changes."""

from __future__ import annotations

import contextlib
import os
import secrets
import threading
from types import SimpleNamespace
from typing import Any, cast

import pytest

from nctakt import Controller, hli
from nctakt.cli.common import hli_partner
from nctakt.hli.connection import FOLDER
from nctakt.plc import PartnerPlc, PlcError

pytestmark = pytest.mark.skipif(not FOLDER.is_dir(), reason="shared memory without files")


def options(*, language: str = "en", quiet: bool = False) -> Any:
    """The options of a run, as far as they count here."""
    return cast("Any", SimpleNamespace(language=language, quiet=quiet))


def new_name() -> str:
    """A name that nobody else uses."""
    return f"nctakt_{os.getpid()}_{secrets.token_hex(4)}"


def connect(words: Any, name: str) -> PartnerPlc:
    """Share the HLI of a controller, and wait for a PLC."""
    with contextlib.ExitStack() as files:
        return hli_partner.connect_partner(words, name, Controller(), files)


def test_what_it_waits_for_is_said_at_once(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """901440 comes before the PLC; without one the run ends with 900650."""
    monkeypatch.setattr(hli_partner, "_COMES_S", 0.01)
    name = new_name()
    with pytest.raises(PlcError) as caught:
        connect(options(language="de"), name)
    assert caught.value.diagnostics[0].id == 900650
    reported = capsys.readouterr().err
    assert f"901440: es wird bis zu 0.01 s auf eine SPS am HLI {name} gewartet" in reported
    assert "nctakt.hli.attach" in reported


def test_who_has_come_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    """901441 with the PLC's process."""
    name = new_name()
    left = threading.Event()

    def be_a_plc() -> None:
        with hli.attach(name):
            left.wait(60)

    thread = threading.Thread(target=be_a_plc)
    thread.start()
    connect(options(), name)
    left.set()
    thread.join()
    assert f"901441: a PLC has connected to the HLI {name}: process {os.getpid()}" in (
        capsys.readouterr().err
    )


def test_a_slow_answer_is_said_and_its_end(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """901442 while the CNC waits for longer than usual, 901443 when it continues."""
    monkeypatch.setattr(hli_partner, "_PATIENCE_S", 0.0)
    patience = hli_partner._Patience(options(), Controller())
    looks = iter(range(1000))
    assert patience.wait(lambda: next(looks) > 100)
    reported = capsys.readouterr().err
    assert "901442" in reported
    assert "901443" in reported
    monkeypatch.setattr(hli_partner, "_ANSWERS_S", 0.0)
    assert not hli_partner._Patience(options(quiet=True), Controller()).wait(lambda: False)
    quiet = capsys.readouterr().err
    assert "901442" in quiet
    assert "901443" not in quiet
