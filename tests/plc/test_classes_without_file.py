# SPDX-License-Identifier: MIT
"""Slips of a PLC whose class is in no file of its own: found when its run begins."""

from __future__ import annotations

import pytest

from nctakt.base.failure import Failure
from nctakt.plc.script import Plc
from nctakt.run.controller import Controller, NcText

HEAD = "from nctakt.plc.script import Plc, at, on, when\n"


def slips(text: str) -> list[tuple[int, str]]:
    """Number and remedy of each slip of the class ``Cell``, which has no source."""
    names: dict[str, type[Plc]] = {}
    exec(HEAD + text, names)  # type: ignore[arg-type]  # as a notebook does
    try:
        Controller().run(NcText("p.nc", "M100\nM30"), plc=names["Cell"]())
    except Failure as failure:
        return [(one.id, one.remedy().split(" docs/")[0]) for one in failure.diagnostics]
    return []


@pytest.mark.parametrize(
    ("body", "number", "remedy"),
    [
        ("def each_tik(self, hli): pass", 901008, "Did you mean each_tick?"),
        ("acknowlege = None", 901008, "Did you mean acknowledge?"),
        ("def each_tick(self, hli): hli.overide_pct = 5", 901008, "Did you mean override_pct?"),
        ("@on('M100')\n def f(self, hli): pass", 901011, "Write def f(self, hli, function)."),
        ("@at('1ms')\n def f(self, hli, x): pass", 901011, "Write def f(self, hli)."),
    ],
)
def test_a_slip_is_an_error_when_the_run_begins(body: str, number: int, remedy: str) -> None:
    """Members of the class, names of the HLI and parameters, from the compiled methods alone."""
    assert slips(f"class Cell(Plc):\n {body}") == [(number, remedy)]


@pytest.mark.parametrize(
    "body",
    [
        "def each_tick(self, hli): hli.override_pct = 5",
        "def each_tick(self, *rest): pass",
        "def each_tick(self, hli):\n  hli = None",
        "def each_tik(self): pass\n def each_tick(self, hli): self.each_tik()",
        "@on('M100')\n def f(self, hli, function, more=1): pass",
    ],
)
def test_what_works_is_no_slip(body: str) -> None:
    """A helper that is called by its name is the user's own."""
    assert slips(f"class Cell(Plc):\n {body}") == []


def test_a_slip_in_a_class_of_a_function_has_its_place() -> None:
    """Its file and line, where Python has the text."""

    class Cell(Plc):
        def each_tik(self, hli: object) -> None:
            """Misspelt."""

    with pytest.raises(Failure) as failure:
        Controller().run(NcText("p.nc", "M30"), plc=Cell())
    (found,) = failure.value.diagnostics
    assert found.span is not None
    assert found.span.file.endswith("test_classes_without_file.py")
    assert "def each_tik" in found.source_line
