# SPDX-License-Identifier: MIT
"""What would be checked by nobody: misspelt keywords, branches where there are none."""

from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.run.controller import Controller
from nctakt.testing.expectations import read_script
from nctakt.testing.keywords import has_expectation, keyword_near
from nctakt.testing.queries import run_program

PROGRAM = (
    "#RT CYCLE [SCOPE=PROG]\n$IF V.RTA.ACS.ACT_POS.X > 1\nM100\n$ENDIF\n#RT CYCLE END\nG00 X5\nM30"
)


@pytest.mark.parametrize("word", ["expct", "exepct", "expects", "Expected", "epxect", "EXPETC"])
def test_a_misspelt_expectation_is_an_error(word: str) -> None:
    """900662 with the place of the word; a file with nothing else is a test all the same."""
    text = f"G00 X5 ; {word}: ended"
    assert has_expectation(text)
    with pytest.raises(Failure) as failure:
        read_script(Path("part.nc"), text)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.id == 900662
    assert diagnostic.span is not None
    assert (diagnostic.span.line, diagnostic.span.column) == (1, 10)
    assert "'; expect: …'" in diagnostic.remedy()


@pytest.mark.parametrize("word", ["gvien", "givn", "givens"])
def test_a_misspelt_condition_is_an_error(word: str) -> None:
    """``given`` likewise."""
    with pytest.raises(Failure) as failure:
        read_script(Path("part.nc"), f"; expect: ended\n; {word}: V.E.VALUE = 5\nM30")
    assert [one.id for one in failure.value.diagnostics] == [900662]


@pytest.mark.parametrize("word", ["note", "feed", "spindle", "inspect", "aspect", "tool", "effect"])
def test_other_words_are_comments(word: str) -> None:
    """A comment may have a colon."""
    assert keyword_near(word) == ""
    assert read_script(Path("part.nc"), f"G00 X5 ; {word}: 5").expectations == []


def test_a_line_without_a_branch_is_an_error() -> None:
    """900663 names the lines that have one, whether or not it fired."""
    run = run_program(Controller(), PROGRAM, Path())
    assert run.fired(line=2)
    with pytest.raises(Failure, match="line 99") as failure:
        run.fired(line=99)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.id == 900663
    assert diagnostic.remedy() == "Lines with branches: 2."
    assert not run_program(Controller(), PROGRAM.replace("> 1", "> 100"), Path()).fired(line=2)
