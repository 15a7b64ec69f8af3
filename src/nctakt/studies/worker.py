# SPDX-License-Identifier: MIT
"""A worker: a process that makes runs of a plan, asked over its standard input.

In: the plan, then lists of numbers of runs, each pickled. Out: for each list its rows, pickled. A
worker has one thread, so that it can copy itself, and it ends when its standard input does. What a
user's PLC prints goes to standard error.
"""

from __future__ import annotations

import contextlib
import gc
import os
import pickle
import signal
import sys

from nctakt.studies.schedule_bench import bench_of
from nctakt.studies.shared_beginning import maker_of


def main() -> None:
    """Make runs until nobody asks for more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # who has started it decides
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    questions = sys.stdin.buffer
    maker = maker_of(bench_of(pickle.load(questions)), may_copy=True)
    gc.collect()
    gc.freeze()
    with contextlib.suppress(EOFError, BrokenPipeError):
        while True:
            rows = [maker.row(number) for number in pickle.load(questions)]
            pickle.dump(rows, answers)
            answers.flush()


if __name__ == "__main__":
    main()
