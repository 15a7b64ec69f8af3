# SPDX-License-Identifier: MIT
"""The summary at the end of a run."""

import io

from nctakt.base.diagnostics import Span
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import RUNNING_UNCOMPILED
from nctakt.messages.files import STDIN_NAMED_TWICE
from nctakt.results.run import CycleResult, OutputCount, ReactionResult, Run
from nctakt.results.summary import print_summary

RUN = Run(
    ("part.nc", "next.nc"),
    1000,
    0,
    726,
    "ended",
    diagnostics=(diagnostic(RUNNING_UNCOMPILED), diagnostic(STDIN_NAMED_TWICE)),
    messages=((5000, "half way"),),
    cycles=(
        CycleResult(
            "17",
            "PROG",
            Span("part.nc", 3, 1, 2),
            (
                ReactionResult(Span("part.nc", 5, 3, 4), "ONCE", 1, 1, 463, 463),
                ReactionResult(Span("part.nc", 9, 3, 4), "", 0, 0, None, None),
            ),
            runs=725,
        ),
        CycleResult("#1", "BLOCK", Span("next.nc", 1, 1, 2), (), instances=3),
    ),
    outputs=(OutputCount("M", 100, True, 1, 463), OutputCount("H", 5, False, 2, 7)),
)


class Terminal(io.StringIO):
    """A stream that says it is a terminal."""

    def isatty(self) -> bool:
        return True


def summary(run: Run, language: str = "en") -> list[str]:
    """The lines of the summary where the output is no terminal."""
    file = io.StringIO()
    print_summary(run, file, "de" if language == "de" else "en", wall_s=0.01)
    return file.getvalue().splitlines()


def test_the_plain_summary_tells_all_and_is_stable() -> None:
    """Programs, ticks, time, reactions, functions, counts; no wall-clock time in a file."""
    assert summary(RUN) == [
        "part.nc, next.nc: ended, 726 ticks = 0.726000 s",
        "",
        "Realtime cycle         Scope  Runs  Reaction        Became true  Ran  First",
        "-" * 91,
        "17 part.nc:3           PROG   725   part.nc:5 ONCE  1            1    "
        "tick 463 = 0.463000 s",
        "                                    part.nc:9       never",
        "#1 next.nc:1, 3 times  BLOCK        no branch",
        "",
        "Function  From            Count  First",
        "-" * 54,
        "M100      realtime cycle  1      tick 463 = 0.463000 s",
        "H5        program         2      tick 7 = 0.007000 s",
        "",
        "1 message, 1 error, 0 warnings, 1 note",
    ]


def test_the_summary_speaks_german() -> None:
    """The same in German."""
    lines = summary(RUN, "de")
    assert lines[0] == "part.nc, next.nc: beendet, 726 Takte = 0.726000 s"
    assert lines[-1] == "1 Meldung, 1 Fehler, 0 Warnungen, 1 Hinweis"
    assert any("nie" in line for line in lines)


def test_a_run_without_cycles_and_functions_has_no_tables() -> None:
    """What there is nothing to say about is left out."""
    assert summary(Run(("a.nc",), 2000, 0, 5, "interrupted")) == [
        "a.nc: interrupted, 5 ticks = 0.010000 s",
        "",
        "0 messages, 0 errors, 0 warnings, 0 notes",
    ]


def test_the_limit_is_reported_with_the_options_that_set_it() -> None:
    """A run that came to its limit says how to go further."""
    assert "--until" in summary(Run(("a.nc",), 1000, 0, 5, "limit"))[0]


def test_a_program_that_did_not_run_is_reported() -> None:
    """No tick was run, since the program has errors."""
    assert summary(Run(("a.nc",), 1000, 0, 0, "error"))[0] == "a.nc: not run"


def test_on_a_terminal_the_factor_is_reported_and_the_tables_are_drawn() -> None:
    """0.726 s of machine time in 0.01 s are 73 times as fast."""
    file = Terminal()
    print_summary(RUN, file, wall_s=0.01)
    text = file.getvalue()
    assert "in 10 ms, 73 times as fast as the machine" in text
    print_summary(RUN, file, wall_s=2.0)
    assert "in 2.0 s, 0.4 times as fast as the machine" in file.getvalue()
    assert "M100" in text
    assert "part.nc:5 ONCE" in text
