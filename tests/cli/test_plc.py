# SPDX-License-Identifier: MIT
"""PLCs from files of the user's."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, cast

import pytest

from nctakt.plc import PlcError, load_plc

if TYPE_CHECKING:
    from nctakt.run.plcs.plc_view import PlcView

GOOD = """
from __future__ import annotations
from dataclasses import dataclass
from helper import STEP

@dataclass
class Counter:
    count: int = 0

    def cycle(self, hli):
        self.count += STEP
        seen.append(self.count)

class _Other:
    def cycle(self, hli): ...

seen = []
"""


class Hli:
    """The PLC's side of the interface image after tick 2."""

    tick = 2


def write(folder: Path, text: str, name: str = "plc.py") -> Path:
    """A file with this text."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def failure_of(path: Path) -> PlcError:
    """What loading raises."""
    with pytest.raises(PlcError) as failure:
        load_plc(path)
    assert len(failure.value.diagnostics) == 1
    return failure.value


def test_a_plc_is_the_one_class_with_a_method_cycle(tmp_path: Path) -> None:
    """It may import files next to it, and nothing of it stays in the interpreter's tables."""
    write(tmp_path, "STEP = 2", "helper.py")
    modules, paths = set(sys.modules), list(sys.path)
    plc = load_plc(write(tmp_path, GOOD))
    plc.cycle(cast("PlcView", Hli()))
    plc.cycle(cast("PlcView", Hli()))
    new = {name for name in set(sys.modules) - modules if not name.startswith("nctakt.")}
    assert new <= {"helper"}
    assert sys.path == paths
    sys.modules.pop("helper", None)


def test_a_base_class_is_not_counted(tmp_path: Path) -> None:
    """Of classes that derive from one another the last one is the PLC."""
    text = "class A:\n    def cycle(self, hli): ...\nclass B(A): pass\nalias = B\n"
    load_plc(write(tmp_path, text)).cycle(cast("PlcView", Hli()))


@pytest.mark.parametrize(
    ("text", "number", "words"),
    [
        ("", 900520, "no class"),
        ("class A: pass\n", 900520, "no class"),
        ("from nctakt.plc import AnyPlc\n", 900520, "no class"),
        (
            "class A:\n    def cycle(self, hli): ...\nclass B:\n    def cycle(self, hli): ...\n",
            900521,
            "A, B",
        ),
        ("x = 1\nimport nothing_of_this_name\n", 900522, "No module named"),
        ("def cycle(:\n", 900522, "SyntaxError"),
        ("raise SystemExit(3)\n", 900522, "SystemExit: 3"),
        ("open('/nothing/here')\n", 900522, "FileNotFoundError"),
        (
            "class A:\n    def __init__(self, port): ...\n    def cycle(self, hli): ...\n",
            900522,
            "missing 1 required positional argument",
        ),
    ],
)
def test_a_file_without_a_usable_plc_is_a_diagnostic(
    tmp_path: Path, text: str, number: int, words: str
) -> None:
    """No class, several, and exceptions of the user's own are reported by number and in words."""
    failure = failure_of(write(tmp_path, text))
    assert failure.diagnostics[0].id == number
    assert words in failure.diagnostics[0].text()


@pytest.mark.parametrize(("name", "number"), [("missing.py", 900500), ("", 900501)])
def test_a_plc_that_is_no_file_is_a_diagnostic(tmp_path: Path, name: str, number: int) -> None:
    """A missing file and a folder are distinguished."""
    assert failure_of(tmp_path / name).diagnostics[0].id == number


def test_a_file_that_is_no_python_has_no_plc(tmp_path: Path) -> None:
    """Another suffix than .py is not loaded."""
    assert failure_of(write(tmp_path, "M30", "plc.nc")).diagnostics[0].id == 900520


def test_the_diagnostic_shows_the_users_lines_only(tmp_path: Path) -> None:
    """The way to an exception begins in the user's file, not in ours."""
    text = "def make():\n    return 1 / 0\nVALUE = make()\n"
    reported = failure_of(write(tmp_path, text)).diagnostics[0].text()
    assert "ZeroDivisionError" in reported
    assert "line 3" in reported
    assert "return 1 / 0" in reported
    assert "nctakt/plc.py" not in reported.replace("\\", "/")


def test_a_syntax_error_shows_its_line(tmp_path: Path) -> None:
    """A file that cannot be compiled says where."""
    reported = failure_of(write(tmp_path, "a = 1\nb = = 2\n")).diagnostics[0].text()
    assert "line 2" in reported
    assert "b = = 2" in reported


def test_an_exception_while_it_runs_names_the_tick(tmp_path: Path) -> None:
    """A PLC that raises in its third call fails after tick 2, and the line is shown."""
    text = """
class Plc:
    left = 2
    def cycle(self, hli):
        self.left -= 1
        assert self.left >= 0, "no more"
"""
    plc = load_plc(write(tmp_path, text))
    plc.cycle(cast("PlcView", Hli()))
    plc.cycle(cast("PlcView", Hli()))
    with pytest.raises(PlcError) as failure:
        plc.cycle(cast("PlcView", Hli()))
    (found,) = failure.value.diagnostics
    assert found.id == 900523
    assert found.values["tick"] == 2
    assert "AssertionError: no more" in found.text()
    assert "line 6" in found.text()


def test_what_we_refuse_the_plc_is_reported_with_its_remedy(tmp_path: Path) -> None:
    """A wrong name in the PLC's file shows the user's line and our diagnostic, not our files."""
    text = """
from nctakt.lists.format.times import read_time
class Plc:
    def cycle(self, hli):
        read_time("soon")
"""
    plc = load_plc(write(tmp_path, text))
    with pytest.raises(PlcError) as failure:
        plc.cycle(cast("PlcView", Hli()))
    found, ours = failure.value.diagnostics
    assert (found.id, ours.id) == (900523, 900510)
    assert found.text().endswith('read_time("soon")')
    assert "times.py" not in found.text()
    assert "'soon' is not a valid time" in found.text()
