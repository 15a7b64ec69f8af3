# SPDX-License-Identifier: MIT
"""The command that shows a run of a study: ``nctakt run``, a replay, or ``nctakt study`` itself.

In: a study and its rows. Out: a command for each number of a run; with ``--record`` the tapes of
the failed runs.
"""

from __future__ import annotations

import itertools
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from nctakt.run.options import accepted_by, command_words
from nctakt.studies.runs.study_runner import FAILED
from nctakt.studies.study import Study, StudyResult

#: The most tapes of one study.
MAX_TAPES = 100

#: Options of ``nctakt study`` that decide which runs there are, besides those of the run.
_OPTIONS = ("each_tick", "sample")


def commands_of(
    study: Study, result: StudyResult, file: str, words: dict[str, Any]
) -> Callable[[int], str]:
    """Return the command of each run; write tapes of the failed ones with ``--record``.

    Raises ``Failure`` for files that cannot be written.
    """
    recorded: dict[int, str] = {}
    if words["record"] is not None:
        folder = Path(words["record"])
        for number in _numbers(result):
            recorded[number] = study.record(number, folder / f"run-{number}.tape")

    def command(number: int) -> str:
        return recorded.get(number) or study.command(number) or _again(file, words, number)

    return command


def _numbers(result: StudyResult) -> Iterator[int]:
    """Yield the numbers of the runs that have a tape."""
    broken = (int(row["run"] or 0) for row in result.rows if row["verdict"] == FAILED)
    return itertools.islice(broken, MAX_TAPES)


def _again(file: str, words: dict[str, Any], number: int) -> str:
    """Return the words that make one run of the study alone, and its tape."""
    parts = ["nctakt", "study", file]
    for name in _OPTIONS:
        if words[name] is not None:
            parts += [f"--{name.replace('_', '-')}", str(words[name])]
    for row in accepted_by("study"):
        if "plan" in row.front_ends:
            parts += command_words(row, words[row.word])
    for text in words["expect"]:
        parts += ["--expect", text]
    return shlex.join([*parts, "--only", str(number), "--record", words["record"] or "tapes"])
