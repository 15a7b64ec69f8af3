# SPDX-License-Identifier: MIT
"""A worker: a process that makes runs of a plan, asked over a pipe.

In: where Python finds modules, the plan, then lists of numbers of runs, each pickled with the
writer of their rows or ``None``. Out: ``True`` once it is ready, or the ``Failure`` that keeps it
from that; then for each list its rows, pickled, or the ``Failure`` to write them. A worker has one
thread, so that it can copy itself, and it ends when there are no more requests. Output of a user's
PLC goes to standard error, and its standard input is empty.
"""

from __future__ import annotations

import contextlib
import gc
import os
import pickle
import sys
from typing import IO

from nctakt.base import interrupts
from nctakt.base.failure import Failure
from nctakt.studies.runs.blocks import make_runs
from nctakt.studies.runs.schedule_runner import runner_of
from nctakt.studies.runs.shared_beginning import maker_of
from nctakt.studies.runs.study_runner import StudyRunner


def main() -> None:
    """Make runs until there are no more requests."""
    answers = os.fdopen(os.dup(1), "wb")
    questions = os.fdopen(os.dup(0), "rb")
    _leave_streams()
    sys.path[:] = pickle.load(questions)
    try:
        runner = runner_of(pickle.load(questions))
    except Failure as failure:
        _answer(answers, failure)
        return
    gc.collect()
    gc.freeze()  # machine and program stay: the garbage collector need not scan them again
    _answer(answers, True)
    serve(runner, questions, answers)


def serve(runner: StudyRunner, questions: IO[bytes], answers: IO[bytes]) -> None:
    """Answer lists of numbers with the rows of their runs until there are no more."""
    _leave_streams()
    maker = maker_of(runner, may_copy=True)
    with contextlib.suppress(EOFError, BrokenPipeError):
        while True:
            block, writer = pickle.load(questions)
            try:
                _answer(answers, make_runs(maker, block, writer))
            except Failure as failure:
                _answer(answers, failure)


def _leave_streams() -> None:
    """Leave Ctrl-C and SIGTERM to the process that asks, and its pipes to questions and answers."""
    interrupts.ignore()
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)


def _answer(answers: IO[bytes], value: object) -> None:
    pickle.dump(value, answers)
    answers.flush()


if __name__ == "__main__":
    main()
