# SPDX-License-Identifier: MIT
"""Values at times: from Python, and from the words of the command line."""

from pathlib import Path

import pytest

import nctakt
from nctakt.base.failure import Failure
from nctakt.lists.format.times import Time
from nctakt.run.access.stimuli import Stimulus, parse_assignment, parse_stimulus, read_stimulus


def test_a_number_alone_means_seconds() -> None:
    """One second, whichever way it is given."""
    assert Stimulus(1.0, "V.E.X", 5) == Stimulus("1s", "V.E.X", 5) == Stimulus(1, "V.E.X", 5)
    assert Stimulus(1.0, "V.E.X", 5).time == Time(1_000_000)


def test_a_tuple_is_a_stimulus() -> None:
    """Time, name and value; a stimulus stays what it is."""
    stimulus = read_stimulus(("1s", "V.E.X", 5))
    assert stimulus == Stimulus("1s", "V.E.X", 5)
    assert read_stimulus(stimulus) is stimulus


@pytest.mark.parametrize(
    "value", ["1s V.E.X=5", ("1s", "V.E.X"), ("1s", 5, "V.E.X"), {"1s": {"V.E.X": 5}}, None, 1.0]
)
def test_what_is_no_stimulus_is_a_diagnostic(value: object) -> None:
    """900514 with the form that is meant."""
    with pytest.raises(Failure) as failure:
        read_stimulus(value)  # type: ignore[arg-type]
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.id == 900514
    assert '("20 ms", "V.E.DOOR", 1)' in diagnostic.render()


@pytest.mark.parametrize(
    ("text", "name", "value"),
    [
        ("V.E.VALUE=5", "V.E.VALUE", 5.0),
        ("V.E.VALUE = -1.5e-3", "V.E.VALUE", -0.0015),
        ("V.E.VALUE=+.5", "V.E.VALUE", 0.5),
        ("V.E.BIT=TRUE", "V.E.BIT", 1.0),
        ("V.E.BIT=false", "V.E.BIT", 0.0),
        ("V.E.A[3].B=7.", "V.E.A[3].B", 7.0),
    ],
)
def test_assignments(text: str, name: str, value: float) -> None:
    """A name, an equals sign, a number or a truth value; blanks around the sign are free."""
    assert parse_assignment(text) == (name, value)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("V.E.VALUE", 900511),
        ("=5", 900511),
        ("", 900511),
        ("V.E.VALUE=", 900512),
        ("V.E.VALUE=five", 900512),
        ("V.E.VALUE==5", 900512),
        ("V.E.VALUE=nan", 900512),
        ("V.E.VALUE=inf", 900512),
        ("V.E.VALUE=1e999", 900512),
        ("V.E.VALUE=1_000", 900512),
        ("V.E.VALUE=0x10", 900512),
    ],
)
def test_what_is_no_assignment_is_a_diagnostic(text: str, number: int) -> None:
    """A missing sign, name or value, and what is no finite number, are reported by number."""
    with pytest.raises(Failure) as failure:
        parse_assignment(text)
    assert [found.id for found in failure.value.diagnostics] == [number]


def test_a_stimulus_has_a_time_and_an_assignment() -> None:
    """``--at 1.5ms V.E.VALUE=-1`` sets the variable at 1500 µs."""
    assert parse_stimulus("1.5ms", "V.E.VALUE=-1") == Stimulus("1.5 ms", "V.E.VALUE", -1.0)


def test_a_stimulus_after_the_end_of_the_run_is_a_warning() -> None:
    """901007 with the time that was missed; none where an error has ended the run."""
    program = nctakt.NcText("a.nc", "G04 0.01\nM30\n")
    late = ("1 h", "V.E.TRIGGER", 1)
    run = nctakt.Controller().run(program, at=[("2 ms", "V.E.TRIGGER", 1), late])
    (found,) = run.diagnostics
    assert (found.id, found.values["name"], found.values["time"]) == (
        901007,
        "V.E.TRIGGER",
        "3600 s",
    )
    assert [one.id for one in nctakt.Controller().run(program, at=[late], ticks=5).diagnostics] == [
        901007
    ]
    wrong = nctakt.NcText("b.nc", "P1 = 1 / 0\nM30\n")
    assert 901007 not in [one.id for one in nctakt.Controller().run(wrong, at=[late]).diagnostics]


def test_a_stimulus_in_the_last_tick_is_in_time() -> None:
    """The first tick that begins at or after its time is the last one of the run."""
    run = nctakt.Controller().run(
        nctakt.NcText("a.nc", "G04 0.01\nM30\n"), at=[("9 ms", "V.E.TRIGGER", 1)], ticks=10
    )
    assert run.diagnostics == ()
    late = nctakt.Controller().run(
        nctakt.NcText("a.nc", "G04 0.01\nM30\n"), at=[("10 ms", "V.E.TRIGGER", 1)], ticks=10
    )
    assert [one.id for one in late.diagnostics] == [901007]


@pytest.mark.parametrize("line", ["V.E.NOPE = 1", "G01 Q5", "M777", "P1 = V.RTA.ACS.ACT_POS.Q"])
def test_an_unknown_name_tells_that_the_machine_is_the_built_in_one(line: str) -> None:
    """901006 once, after the errors; not on one's own machine."""
    program = nctakt.NcText("a.nc", f"{line}\n{line}\nM30\n")
    found = [one.id for one in nctakt.Controller().run(program).diagnostics]
    assert found.count(901006) == 1
    assert found[-1] == 901006
    own = nctakt.Controller(Path(__file__).parents[1] / "machines" / "centre")
    assert 901006 not in [one.id for one in own.run(program).diagnostics]


def test_an_unknown_name_from_outside_tells_it_too() -> None:
    """As a value before the first tick, or one that is read."""
    controller = nctakt.Controller()
    for call in (lambda: controller.write("V.E.NOPE", 1), lambda: controller.read("V.E.NOPE")):
        with pytest.raises(Failure) as failure:
            call()
        assert [one.id for one in failure.value.diagnostics][1:] == [901006]
