# SPDX-License-Identifier: MIT
"""A process that makes runs, as seen by the requesting one.

It is a copy of this process (``fork``), which already has machine and program, or, if there is no
``fork`` or this process has several threads, of which a copy would have one, a new process that
loads them.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import subprocess
import sys
import threading
import warnings
from collections.abc import Callable, Sequence
from typing import IO, Self

from nctakt.base import interrupts
from nctakt.base.diagnostics import Text
from nctakt.base.failure import Failure
from nctakt.base.python_process import python_command, python_environment
from nctakt.messages import diagnostic
from nctakt.messages.commands.studies import WORKER_NOT_STARTED
from nctakt.studies.plans.plan import Plan
from nctakt.studies.runs.blocks import MadeBlock, RowWriter
from nctakt.studies.runs.study_runner import StudyRunner
from nctakt.studies.workers.worker import serve

#: How often a process is started that ends before it is ready.
MAX_STARTS = 3


def can_copy() -> bool:
    """Return whether this process can be copied; elsewhere than on Linux libraries forbid it."""
    return sys.platform == "linux" and threading.active_count() == 1


class WorkerProcess:
    """A process by its number, and its pipes; ``wait`` returns its exit code once it has ended."""

    def __init__(
        self, pid: int, questions: IO[bytes], answers: IO[bytes], wait: Callable[[], int]
    ) -> None:
        self.pid = pid
        self._questions = questions
        self._answers = answers
        self._wait = wait
        self._has_ended = False

    @classmethod
    def copied(cls, runner: StudyRunner, others: Sequence[WorkerProcess]) -> Self:
        """Return a copy of this process; it leaves the pipes of the others.

        Raises ``Failure`` if the system refuses one (901486).
        """
        asked, questions = os.pipe()
        answers, answered = os.pipe()
        sys.stdout.flush()
        sys.stderr.flush()
        with interrupts.blocked_for_children(), warnings.catch_warnings():
            warnings.simplefilter(
                "ignore", DeprecationWarning
            )  # threads of numpy, which it has not
            try:
                pid = os.fork()
            except OSError as error:
                for end in (asked, questions, answers, answered):
                    os.close(end)
                raise _not_started(error.strerror or str(error)) from error
            if pid == 0:
                try:
                    interrupts.end_with_parent()
                    for other in others:
                        other._leave()
                    os.close(questions)
                    os.close(answers)
                    serve(runner, os.fdopen(asked, "rb"), os.fdopen(answered, "wb"))
                except BaseException:  # noqa: BLE001 - reported as a new process would
                    sys.excepthook(*sys.exc_info())
                finally:
                    sys.stdout.flush()
                    os._exit(0)
        os.close(asked)
        os.close(answered)
        pipes = os.fdopen(questions, "wb"), os.fdopen(answers, "rb")
        return cls(pid, *pipes, lambda: os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]))

    @classmethod
    def started(cls, plan: Plan) -> Self:
        """Return a new process that is ready.

        Raises ``Failure``: with its reason, or that there is no process (901486).
        """
        for _ in range(MAX_STARTS):
            try:
                with interrupts.blocked_for_children():
                    process = subprocess.Popen(
                        python_command("nctakt.studies.workers.worker"),
                        stdin=subprocess.PIPE,
                        stdout=subprocess.PIPE,
                        env={**python_environment(), "OPENBLAS_NUM_THREADS": "1"},
                    )
            except OSError as error:
                raise _not_started(error.strerror or str(error)) from error
            assert process.stdin is not None
            assert process.stdout is not None
            worker = cls(process.pid, process.stdin, process.stdout, process.wait)
            worker._send(sys.path)
            worker._send(plan)
            answer = worker._received()
            if isinstance(answer, Failure):
                worker.end()
                raise answer
            if answer is not None:
                return worker
            code = worker.end()
        raise _not_started(Text(f"exit code {code}", f"Exit-Code {code}"))

    def ask(self, block: Sequence[int], writer: RowWriter | None) -> None:
        """Request the rows of a block; requests are answered in order."""
        self._send((tuple(block), writer))

    def answer(self) -> MadeBlock | None:
        """Return the next rows; ``None`` if the process has ended.

        Raises the ``Failure`` of their writer.
        """
        answer = self._received()
        if isinstance(answer, Failure):
            raise answer
        assert answer is None or isinstance(answer, MadeBlock)
        return answer

    def kill(self) -> None:
        """Let it end at once; ``end`` is still due."""
        if not self._has_ended:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, signal.SIGTERM if os.name == "nt" else signal.SIGKILL)

    def end(self) -> int:
        """Close the pipes and wait until the process has ended; return its exit code."""
        self._leave()
        code = self._wait()
        self._has_ended = True
        return code

    def _leave(self) -> None:
        for stream in (self._questions, self._answers):
            with contextlib.suppress(OSError):
                stream.close()

    def _send(self, value: object) -> None:
        with contextlib.suppress(BrokenPipeError):
            pickle.dump(value, self._questions)
            self._questions.flush()

    def _received(self) -> object:
        try:
            return pickle.load(self._answers)
        except (EOFError, pickle.UnpicklingError):
            return None


def _not_started(reason: str | Text) -> Failure:
    return Failure(diagnostic(WORKER_NOT_STARTED, reason=reason))
