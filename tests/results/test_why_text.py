# SPDX-License-Identifier: MIT
"""The report as text: whole runs and single ticks, in both languages, and what is asked of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.why_runs import NESTED, NESTED_AT, ONCE, TOGGLE, why

from nctakt.base.failure import Failure
from nctakt.results.explained.why_words import ENDS_SHOWN
from nctakt.run.controller import Controller

ENGLISH = """\
realtime cycle 17  part.nc:1  PROG
  defined and started at tick 0 (0 s)
  ran in ticks 0 to 724
  ended at tick 725 (0.725 s): the program ended

  line 2  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    evaluated in ticks 0 to 463
    false from tick 0 (0 s): 0 > 200
    true from tick 463 (0.463 s): 200.25 > 200
    became true once, ran once, in tick 463 (0.463 s): M100
    ONCE: done, no longer evaluated
"""

GERMAN = """\
Echtzeit-Zyklus 17  part.nc:1  PROG
  definiert und gestartet in Takt 0 (0 s)
  gelaufen: Takte 0 bis 724
  beendet in Takt 725 (0.725 s): das Programm endete

  Zeile 2  $IF ONCE V.RTA.ACS.ACT_POS.X > 200
    ausgewertet: Takte 0 bis 463
    falsch ab Takt 0 (0 s): 0 > 200
    wahr ab Takt 463 (0.463 s): 200.25 > 200
    wurde einmal wahr, lief einmal: Takt 463 (0.463 s): M100
    ONCE: erledigt, nicht mehr ausgewertet
"""

ALWAYS = """\
  line 2  $IF V.E.CONDITION == 1
    evaluated in ticks 0 to 13
    false from tick 0 (0 s): 0 == 1
    true from tick 2 (0.002 s): 1 == 1
    false from tick 8 (0.008 s): 0 == 1
    true from tick 11 (0.011 s): 1 == 1
    became true 2 times, ran 9 times, in ticks 2 to 7, 11 to 13

    line 3  $IF ALWAYS V.E.VALUE > 100
      evaluated in ticks 2 to 4
      false from tick 2 (0.002 s): 0 > 100
      true from tick 4 (0.004 s): 150 > 100
      became true 2 times, ran 7 times, in ticks 4 to 7, 11 to 13: V.E.COUNT += 1
      ALWAYS: latched since tick 4 (0.004 s), no longer evaluated
"""

AT_TICK_9 = """\
tick 9 (0.009 s)

realtime cycle #1  part.nc:1  PROG
  ran in this tick

  line 2  $IF V.E.CONDITION == 1
    evaluated in this tick
    false since tick 8 (0.008 s): 0 == 1
    did not run

    line 3  $IF ALWAYS V.E.VALUE > 100
      not evaluated in this tick
      true since tick 4 (0.004 s): 150 > 100
      did not run: not reached: line 2 did not run: false since tick 8 (0.008 s): 0 == 1
"""


def test_a_report_in_english() -> None:
    """Each fact has its tick and time."""
    assert why(ONCE).render() == ENGLISH


def test_a_report_in_german() -> None:
    """The same in German."""
    assert why(ONCE).render("de") == GERMAN


def test_nested_conditions_are_indented() -> None:
    """The manual's latch inside a plain ``$IF`` (RC-204)."""
    text = why(NESTED, at=NESTED_AT, set={"V.E.VALUE": 200}).render()
    assert text.split("\n\n", 1)[1] == ALWAYS


def test_one_tick() -> None:
    """RC-204: how everything stood in tick 9, and why the latched body did not run."""
    report = why(NESTED, at=NESTED_AT, set={"V.E.VALUE": 200})
    assert report.render_at(9) == AT_TICK_9


def test_what_is_to_blame_is_followed_outwards() -> None:
    """The inner branch names the outer one, and why that did not run."""
    text = why(NESTED).render()
    reported = "never ran: not reached: line 2 did not run: never true, nearest at tick 0 (0 s): "
    assert f"{reported}0 == 1, 1 away" in text


@pytest.mark.parametrize(
    ("text", "language", "reported"),
    [
        (
            "#RT CYCLE DEF [ID=1]\n#RT CYCLE END\n",
            "en",
            "never ran: defined at tick 0 (0 s) with DEF",
        ),
        (
            "#RT CYCLE DEF [ID=1]\n#RT CYCLE END\n",
            "de",
            "nie gelaufen: in Takt 0 (0 s) mit DEF definiert",
        ),
        (
            "#RT CYCLE [SCOPE=BLOCK]\n#RT CYCLE END\n",
            "en",
            "never ran: ended at tick 1 (0.001 s): the",
        ),
        ("#RT CYCLE\nV.E.COUNT = 1/V.E.VALUE\n#RT CYCLE END\n", "en", "cycle: error 50879, line 2"),
        (
            "#RT CYCLE\nV.E.COUNT = 1/V.E.VALUE\n#RT CYCLE END\n",
            "de",
            "im Zyklus: Fehler 50879, Zeile 2",
        ),
        ("$IF 0\n#RT CYCLE\n#RT CYCLE END\n$ENDIF\n", "en", "never ran: not defined up to here"),
        ("G00 X1\n", "en", "no realtime cycles\n"),
        ("G00 X1\n", "de", "keine Echtzeit-Zyklen\n"),
        (
            "#RT CYCLE\n$IF V.E.VALUE\n$ENDIF\n#RT CYCLE END\n",
            "en",
            "0 (true from 0.5 on), 0.5 away",
        ),
        (
            "#RT CYCLE [ID=2]\n#RT CYCLE END\nG04 X1\n#RT CYCLE HOLD [ID=2]\nG04 X1\n",
            "en",
            "  put on hold at tick 1000 (1 s), line 4\n  ran in ticks 0 to 999\n  ended at",
        ),
    ],
)
def test_what_a_cycle_went_through(text: str, language: str, reported: str) -> None:
    """The steps of a life, and why there was none."""
    assert reported in why(f"{text}M30\n").render("de" if language == "de" else "en")


def test_a_long_list_shows_its_ends() -> None:
    """Of 50 changes the first and the last ones are reported, and how many are between."""
    text = why(TOGGLE, ticks=50).render()
    assert text.count("true from tick") + text.count("false from tick") == 2 * ENDS_SHOWN
    assert "    … 42 more …\n" in text
    assert (
        "became true 25 times, ran 25 times, in ticks 0, 2, 4, 6, … 17 more …, 42, 44, 46, 48: "
        "V.E.COUNT = 1\n" in text
    )


def test_a_line_is_that_of_the_branch_around_it() -> None:
    """Line 3, M100, belongs to the ``$IF`` in line 2; line 1 to the whole cycle."""
    report = why(ONCE)
    assert report.select(line=3).render() == ENGLISH
    assert report.select(line=1).render() == ENGLISH
    assert report.select(cycle="17").render() == ENGLISH


def test_a_line_outside_of_every_branch() -> None:
    """Such a statement runs in each run-through."""
    report = why(ONCE.replace("  $IF ONCE", "  V.E.COUNT += 1\n  $IF ONCE"))
    text = report.select(line=2).render()
    assert "statements outside $IF run in every run-through" in text
    assert "$IF ONCE" not in text


@pytest.mark.parametrize(
    ("text", "cycle", "line", "number", "reported"),
    [
        (ONCE, "18", None, 900574, "17"),
        (ONCE, None, 9, 900575, "3"),
        (ONCE, "17", 40, 900575, "3"),
        ("M30\n", "17", None, 900577, ""),
        ("M30\n", None, 1, 900578, ""),
    ],
)
def test_what_there_is_not(
    text: str, cycle: str | None, line: int | None, number: int, reported: str
) -> None:
    """An unknown cycle or line is reported with what there is."""
    with pytest.raises(Failure) as failure:
        why(text).select(cycle, line)
    (found,) = failure.value.diagnostics
    assert found.id == number
    assert reported in found.remedy()


@pytest.mark.parametrize("tick", [-1, 726])
def test_a_tick_outside_of_the_run(tick: int) -> None:
    """900576: the run went from tick 0 to tick 725."""
    report = why(ONCE)
    assert report.render_at(0)
    assert report.render_at(725)
    with pytest.raises(Failure) as failure:
        report.render_at(tick)
    assert failure.value.diagnostics[0].id == 900576


def test_a_frozen_value_is_reported() -> None:
    """RC-302: V.E.ASYNC is 7 when the definition is decoded; that it becomes 0 changes nothing."""
    text = "V.E.ASYNC = 7\n#RT CYCLE\n$IF V.E.VALUE > V.E.ASYNC\n$ENDIF\n#RT CYCLE END\n"
    report = why(f"{text}V.E.ASYNC = 0\n#TIME 0.01\nM30\n", set={"V.E.VALUE": 5})
    reported = "    V.E.ASYNC is 7, frozen when the definition was decoded\n"
    assert reported in report.render()
    assert reported in report.render_at(3)
    assert "5 > 7, 2 away" in report.render()


def test_a_distance_has_no_digits_of_rounding() -> None:
    """X ends its path 0.002 mm before 300; the difference of the two doubles is longer."""
    assert "> 300, 0.002 away" in why(ONCE.replace("200", "300")).render()


def test_a_line_of_another_file_names_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """RC-111: a subprogram deletes the cycle; a line number alone would be one of the program."""
    monkeypatch.chdir(tmp_path)
    Path("off.nc").write_text("#RT CYCLE DELETE [ID=2]\nM17\n", "utf-8")
    Path("part.nc").write_text(
        "#RT CYCLE [ID=2 SCOPE=PROG]\n  V.E.COUNT += 1\n#RT CYCLE END\n"
        "#TIME 0.005\nL off.nc\n#TIME 0.005\nM30\n",
        "utf-8",
    )
    report = Controller().run("part.nc", why=True).why
    assert report is not None
    assert "deleted, off.nc:1\n" in report.render()
