# SPDX-License-Identifier: MIT
"""Slips in a PLC's file: reported when it is loaded, with place and nearest name (RC-002)."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt import Controller, Failure, NcText
from nctakt.plc import PlcError, load_plc, on, when

HEAD = "from nctakt.plc import *\n\n"

#: Text of a class, number of the message, line, the text under the carets, part of the remedy.
SLIPS = [
    (
        "class C:\n    def cycle(self, h):\n        h.overide_pct = 50\n",
        901008,
        5,
        "overide_pct",
        "override_pct",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.acknowlege_all()\n",
        901008,
        5,
        "acknowlege_all",
        "acknowledge_all",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.of_channel(2).stat\n",
        901008,
        5,
        "stat",
        "state",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.state = 'ready'\n",
        901009,
        5,
        "state",
        "override_pct",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.tick += 1\n",
        901009,
        5,
        "tick",
        "feed_hold",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.override_pct = '50'\n",
        901010,
        5,
        "'50'",
        "docs/plc.md",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.feed_hold = 'on'\n",
        901010,
        5,
        "'on'",
        "docs/plc.md",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.axis('X')['comand']\n",
        901012,
        5,
        "'comand'",
        "command",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        hli.channel()['path_sped']\n",
        901012,
        5,
        "'path_sped'",
        "path_speed",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        for o in hli.functions():\n            "
        "o.nam\n",
        901008,
        6,
        "nam",
        "name",
    ),
    (
        "class C:\n    def cycle(self, hli):\n        [1 for j in hli.spindle_jobs() if j.sped]\n",
        901008,
        5,
        "sped",
        "speed",
    ),
    ("class C:\n    def cycle(self):\n        pass\n", 901011, 4, "cycle", "def cycle(self, hli)"),
    ("class C(Plc):\n    acknowlege = NONE\n", 901008, 4, "acknowlege", "acknowledge"),
    ("class C(Plc):\n    spindels = NONE\n", 901008, 4, "spindels", "spindles"),
    (
        "class C(Plc):\n    def each_tik(self, hli):\n        pass\n",
        901008,
        4,
        "each_tik",
        "each_tick",
    ),
    (
        "class C(Plc):\n    def __init__(self):\n        self.acknowlege = NONE\n",
        901008,
        5,
        "acknowlege",
        "acknowledge",
    ),
    ("class C(Plc):\n    acknowledge = 20\n", 901010, 4, "acknowledge", "docs/plc.md"),
    ("class C(Plc):\n    acknowledge = after\n", 901010, 4, "acknowledge", "docs/plc.md"),
    ("class C(Plc):\n    inputs = ['a.csv']\n", 901010, 4, "inputs", "docs/plc.md"),
    (
        "class C(Plc):\n    @on('M100')\n    def f(self, hli):\n        pass\n",
        901011,
        5,
        "f",
        "def f(self, hli, function)",
    ),
    (
        "class C(Plc):\n    @at(1)\n    def f(self, hli, function):\n        pass\n",
        901011,
        5,
        "f",
        "def f(self, hli)",
    ),
    (
        "class C(Plc):\n    def begin_run(self):\n        pass\n",
        901011,
        4,
        "begin_run",
        "def begin_run(self, hli)",
    ),
    (
        "class C(Plc):\n    def each_tick(self):\n        pass\n",
        901011,
        4,
        "each_tick",
        "def each_tick(self, hli)",
    ),
    (
        "class C(Plc):\n    @on('M100')\n    def f(self, hli, function):\n        function.numbr\n",
        901008,
        6,
        "numbr",
        "number",
    ),
    (
        "class C(Plc):\n    @when(lambda h: h.is_armd)\n    def f(self, hli):\n        pass\n",
        901008,
        4,
        "is_armd",
        "is_armed",
    ),
    (
        "def help(hli):\n    'Grüße', hli.feedhold\n\nclass C(Plc):\n    pass\n",
        901008,
        4,
        "feedhold",
        "feed_hold",
    ),
]


def written(folder: Path, text: str) -> Path:
    """A PLC's file."""
    path = folder / "plc.py"
    path.write_text(HEAD + text, "utf-8")
    return path


@pytest.mark.parametrize(("text", "number", "line", "marked", "remedy"), SLIPS)
def test_a_slip_is_reported_at_its_place_when_the_file_is_loaded(
    text: str, number: int, line: int, marked: str, remedy: str, tmp_path: Path
) -> None:
    """One error each, the carets below the word, the remedy with what was meant."""
    with pytest.raises(PlcError) as failure:
        load_plc(written(tmp_path, text))
    (found,) = failure.value.diagnostics
    assert found.span is not None
    assert (found.id, found.span.line) == (number, line)
    assert found.source_line[found.span.column - 1 : found.span.end_column - 1] == marked
    assert remedy in found.remedy()
    assert found.text("de") != found.text()


GOOD = """
class C(Plc):
    input = 5
    spindel = 7

    def __init__(self):
        self.moment = self.input

    def helper(self, view, hli: dict):
        hli = hli.anything
        return hli.anything_else, self.spindel

    @on("M100", "h100")
    @on("M101")
    def clamp(self, hli, *rest):
        entry = rest[0]
        self.note(entry, hli.axis("X")["command"], hli.channel()["path_speed"])

    def note(self, *words):
        hli = words
        hli.count(3)

    def each_tick(self, hli, extra=1):
        hli.override_pct = 50
        hli.feed_hold = False
        hli.single_block = 0
        with_names = {"hli": hli}
        axis = "X"
        hli.axis(axis)[str("command")]
"""


def test_what_is_the_users_own_is_no_slip(tmp_path: Path) -> None:
    """Attributes that are read, parameters with another annotation, parameters given anew."""
    plc = load_plc(written(tmp_path, GOOD))
    run = Controller().run(NcText("a.nc", "M100\nM101\nH100\nM30"), plc=plc)
    assert not run.diagnostics


def test_a_class_with_a_misspelt_cycle_is_reported(tmp_path: Path) -> None:
    """900520 says that the method is missing, 901008 which one may be it."""
    with pytest.raises(PlcError) as failure:
        load_plc(written(tmp_path, "class C:\n    def cycel(self, hli):\n        pass\n"))
    first, second = failure.value.diagnostics
    assert (first.id, second.id) == (900520, 901008)
    assert "cycel" in second.remedy()


@pytest.mark.parametrize(
    ("member", "name", "near"),
    [
        ("    @on('M777')\n    def f(self, hli, function):\n        pass\n", "M777", ""),
        (
            "    @on('M100', 'm1000')\n    def f(self, hli, function):\n        pass\n",
            "M1000",
            "M100",
        ),
        ("    @on('S7')\n    def f(self, hli, function):\n        pass\n", "S7", ""),
        ("    acknowledge = only('H1000')\n", "H1000", "H100"),
        ("    spindles = only('X')\n", "X", ""),
    ],
)
def test_a_function_that_the_channel_list_lacks_is_reported_before_the_first_tick(
    member: str, name: str, near: str, tmp_path: Path
) -> None:
    """901013 at its word, the file named as the user gave it."""
    path = written(tmp_path, f"class C(Plc):\n{member}")
    controller = Controller()
    with pytest.raises(PlcError) as failure:
        controller.run(NcText("a.nc", "M30"), plc=load_plc(path))
    (found,) = failure.value.diagnostics
    assert (found.id, found.values["name"], controller.tick) == (901013, name, 0)
    assert found.span is not None
    assert found.span.file == str(path)
    place = found.source_line[found.span.column - 1 : found.span.end_column - 1]
    assert place.upper() == name
    assert near in found.remedy()


def test_what_was_never_called_is_reported_at_the_end(tmp_path: Path) -> None:
    """901014 for each mark with its reason, 901007 for inputs that were left over."""
    text = """
class C(Plc):
    inputs = "inputs.csv"

    @at("1h")
    def late(self, hli):
        pass

    @when(lambda hli: hli.error)
    def failed(self, hli):
        pass

    @on("M101")
    @on("M100")
    def clamp(self, hli, function):
        pass
"""
    (tmp_path / "inputs.csv").write_text("time,V.E.COUNT\n0,1\n2h,5\n", "utf-8")
    run = Controller().run(NcText("a.nc", "M100\nM30"), plc=load_plc(written(tmp_path, text)))
    reported = [(one.id, one.text().split(":")[-1].strip()) for one in run.diagnostics]
    each_tick = "the condition of failed is a Python function, so the PLC is called after each tick"
    assert reported == [
        (902140, each_tick),
        (901007, "the run ended before, after 0.001 s"),
        (901014, "the run ended before 3600 s"),
        (901014, "its condition did not become true"),
        (901014, "M101 did not appear"),
    ]
    spans = [one.span for one in run.diagnostics[1:]]
    assert [span.line for span in spans if span is not None] == [8, 12, 17]


def test_decorators_refuse_what_is_no_condition_and_no_name() -> None:
    """901010 at once, where Python shows the line."""
    for call in (lambda: when(5), lambda: on(100)):  # type: ignore[arg-type]
        with pytest.raises(Failure) as failure:
            call()
        assert [one.id for one in failure.value.diagnostics] == [901010]


def test_names_that_are_computed_are_reported_when_they_are_used() -> None:
    """Attributes with the nearest one; keys and axes as diagnostics (901012, 900656)."""
    hli = Controller().hli
    with pytest.raises(AttributeError, match="did you mean override_pct"):
        hli.overide_pct = 5  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="did you mean acknowledge"):
        hli.acknowlege(None)  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="no tick to use"):
        hli.tick = 5  # type: ignore[misc]
    for values, wrong, right in (
        (hli.axis("X"), "comand", "command"),
        (hli.channel(), "blok", "block"),
    ):
        with pytest.raises(Failure) as failure:
            values[wrong]
        (found,) = failure.value.diagnostics
        assert (found.id, found.values["nearest"]) == (901012, right)
    with pytest.raises(Failure) as failure:
        hli.axis("x")
    (found,) = failure.value.diagnostics
    assert (found.id, found.values["nearest"]) == (900656, "X")
