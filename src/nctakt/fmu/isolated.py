# SPDX-License-Identifier: MIT
"""One instance of an FMU in a separate process, with the calls of ``FmuInstance``.

In: a description, its unpacked files. Out: values that are set and read, steps. A model that ends
its process or does not return becomes an ``FmuError``; nctakt continues.
"""

from __future__ import annotations

import contextlib
import json
import pickle
import signal
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Text
from nctakt.base.python_process import python_command, python_environment
from nctakt.fmu.call_watch import CallWatch
from nctakt.fmu.description import FmuDescription, FmuVariable
from nctakt.fmu.failures import FmuError
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import (
    FMU_CRASHED,
    FMU_ENDED,
    FMU_FAILED,
    FMU_HANGS,
    FMU_LIBRARY_MISSING,
    FMU_NOT_INSTANTIATED,
)

#: Reports of the other process, by number.
_REPORTED = {
    one.id: one for one in (FMU_FAILED, FMU_ENDED, FMU_LIBRARY_MISSING, FMU_NOT_INSTANTIATED)
}
#: The calls, in words.
_CALLS = {
    "load": Text("when it is loaded", "beim Laden"),
    "begin": Text("at its begin", "bei seinem Beginn"),
    "get": Text("when values are read", "beim Lesen von Werten"),
    "advance": Text("in a step", "in einem Schritt"),
    "end": Text("at its end", "an seinem Ende"),
}


class IsolatedInstance:
    """An instance; ``limit_s``: how long a call may last before its process is ended."""

    def __init__(self, description: FmuDescription, folder: Path, limit_s: float) -> None:
        self._file = str(description.file)
        self._limit_us = round(limit_s * 1e6)
        self.time_us = 0
        self._is_late = False
        self._process = subprocess.Popen(
            python_command("nctakt.fmu.guest"),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=python_environment(),
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._questions, self._answers = self._process.stdin, self._process.stdout
        self._watch = CallWatch(limit_s, self._end_late)
        try:
            with contextlib.suppress(BrokenPipeError):
                pickle.dump((description, folder), self._questions)
                self._questions.flush()
            self._answers.readline()  # when Python and FMPy are loaded, which the limit leaves out
            self._ask("load")
        except FmuError:
            self._give_up()
            raise

    def begin(self, start: Mapping[FmuVariable, Any], inputs: Mapping[FmuVariable, Any]) -> None:
        """Initialise with start values, then inputs; raises ``FmuError``."""
        self._ask("begin", _by_name(start), _by_name(inputs))

    def get(self, variables: Sequence[FmuVariable]) -> dict[str, float | bool | str]:
        """Return the values of variables by name; raises ``FmuError``."""
        found: dict[str, float | bool | str] = self._ask("get", [one.name for one in variables])
        return found

    def advance(
        self, inputs: Mapping[FmuVariable, Any], step_us: int, variables: Sequence[FmuVariable]
    ) -> dict[str, float | bool | str]:
        """Set inputs, make a step, and return the values of variables; raises ``FmuError``."""
        names = [one.name for one in variables]
        found: dict[str, float | bool | str] = self._ask(
            "advance", _by_name(inputs), step_us, names
        )
        self.time_us += step_us
        return found

    def end(self) -> None:
        """End the instance and its process."""
        if self._process.returncode is not None:
            return
        try:
            self._ask("end")
        finally:
            self._give_up()

    def _ask(self, call: str, *words: Any) -> Any:
        """Return the answer to a call; raises ``FmuError``, also if there is none."""
        self._watch.begin()
        try:
            self._questions.write(json.dumps([call, *words]).encode() + b"\n")
            self._questions.flush()
            line = self._answers.readline()
        except BrokenPipeError:
            line = b""
        finally:
            self._watch.end()
        if not line.endswith(b"\n"):
            raise self._broken(call)
        answer = json.loads(line)
        if failures := answer.get("failures"):
            raise FmuError(*(diagnostic(_REPORTED[one], **values) for one, values in failures))
        return answer["value"]

    def _broken(self, call: str) -> FmuError:
        """End the process that gave no answer, and return the error for it."""
        code = self._give_up()
        shown: dict[str, Any] = {
            "file": self._file,
            "time": str(Time(self.time_us)),
            "call": _CALLS[call],
        }
        if self._is_late:
            return FmuError(diagnostic(FMU_HANGS, limit=str(Time(self._limit_us)), **shown))
        return FmuError(diagnostic(FMU_CRASHED, reason=_ending(code), **shown))

    def _end_late(self) -> None:
        self._is_late = True
        self._process.kill()

    def _give_up(self) -> int:
        """Let the process end and return its exit code."""
        self._watch.stop()
        with contextlib.suppress(OSError):
            self._questions.close()
        try:
            return self._process.wait(self._limit_us / 1e6)
        except subprocess.TimeoutExpired:
            self._process.kill()
            return self._process.wait()
        finally:
            self._answers.close()


def _by_name(values: Mapping[FmuVariable, Any]) -> dict[str, Any]:
    return {one.name: value for one, value in values.items()}


def _ending(code: int) -> str:
    """Return how a process has ended."""
    if code < 0:
        with contextlib.suppress(ValueError):
            return signal.Signals(-code).name
    return f"exit code {code}"
