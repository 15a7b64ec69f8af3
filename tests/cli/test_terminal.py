# SPDX-License-Identifier: MIT
"""The progress bar and the lines that a command shows."""

import io
import os

import pytest

from nctakt.cli.common import terminal
from nctakt.cli.common.terminal import ProgressBar, show_at_the_end
from nctakt.run.option_kinds import split_names


class Terminal(io.StringIO):
    """A stream that says it is a terminal."""

    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(("file", "patience_s"), [(io.StringIO(), 0.0), (Terminal(), 60.0)])
def test_no_bar_in_files_and_for_short_runs(
    file: io.StringIO, patience_s: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Progress is for a person who waits."""
    monkeypatch.setattr(terminal, "PATIENCE_S", patience_s)
    bar = ProgressBar(file)
    bar.update(5, 10)
    bar.hide()
    assert file.getvalue() == ""


def test_the_bar_comes_goes_and_comes_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a terminal a long run shows how far it is, between what else is shown."""
    monkeypatch.setattr(terminal, "PATIENCE_S", 0.0)
    monkeypatch.setattr(terminal, "_REFRESH_S", 0.0)
    monkeypatch.setenv("TERM", "xterm")
    file = Terminal()
    bar = ProgressBar(file)
    bar.update(5, 10)
    bar.hide()
    assert "50%" in file.getvalue()
    bar.update(9, None)
    bar.update(10, 10)
    bar.hide()
    bar.hide()
    assert "100%" in file.getvalue()


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("A,B", ("A", "B")),
        (" A , B ,", ("A", "B")),
        ("V.E.M[1,2],B", ("V.E.M[1,2]", "B")),
        ("", ()),
    ],
)
def test_names_are_divided_outside_brackets(text: str, names: tuple[str, ...]) -> None:
    """A comma between indices belongs to the name."""
    assert split_names(text) == names


@pytest.mark.skipif(os.name != "posix", reason="pipes close in another way there")
def test_a_closed_output_is_no_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """A closed pipe swallows the summary, then and when Python flushes at its end."""
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "w") as file:
        monkeypatch.setattr("sys.stdout", file)
        show_at_the_end(lambda stream: print("summary", file=stream))
