# SPDX-License-Identifier: MIT
"""One instance of an FMU in this process, with the same calls for FMI 2.0 and 3.0.

In: a description, its unpacked files. Out: values that are set and read, steps. Any answer of the
model other than ok becomes an ``FmuError`` with the last lines of the model's log.
"""

from __future__ import annotations

import ctypes
import os
import sys
from collections import deque
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.diagnostics import Text
from nctakt.fmu.call_watch import CallWatch
from nctakt.fmu.description import FmuDescription, FmuVariable
from nctakt.fmu.failures import FmuError, fmpy
from nctakt.lists.format.times import Time
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import FMU_ENDED, FMU_FAILED, FMU_LATE, FMU_NOT_INSTANTIATED

_STATUSES = ("ok", "warning", "discard", "error", "fatal", "pending")
_ERROR, _FATAL = 3, 4

#: Lines of the model's log that a failure shows, and their length.
_LOG_LINES = 3
_LINE_LENGTH = 300
_SILENT = Text("it does not say why", "sie sagt nicht, warum")


class FmuInstance:
    """An instance; ``time_us``: the time of the run up to which it has come.

    A call that lasts longer than ``limit_s`` is reported on the error output; 0: no check.
    """

    def __init__(self, description: FmuDescription, folder: Path, limit_s: float = 0.0) -> None:
        self._description = description
        self._library = fmpy()
        self._log: deque[bytes] = deque(maxlen=_LOG_LINES)
        self._status = 0
        self.time_us = 0
        self._keeps_callbacks: Any = None
        kind = (
            self._library.fmi2.FMU2Slave
            if description.version == 2
            else self._library.fmi3.FMU3Slave
        )
        self._function = ""
        self._limit_us = round(limit_s * 1e6)
        self._watch = CallWatch(limit_s, self._report_late) if limit_s else None
        self._model: Any = None
        self._model = self._call(
            "load",
            lambda: _in_this_folder(
                lambda: kind(
                    guid=description.token,
                    unzipDirectory=str(folder),
                    modelIdentifier=description.identifier,
                    instanceName="nctakt",
                )
            ),
        )
        self._is_begun = False

    # --- life -----------------------------------------------------------------------------------

    def begin(self, start: Mapping[FmuVariable, Any], inputs: Mapping[FmuVariable, Any]) -> None:
        """Initialise with start values, then inputs; raises ``FmuError``."""
        self._instantiate()
        self._is_begun = True
        model = self._model
        self.set(start)
        if self._description.version == 2:
            self._call("fmi2SetupExperiment", lambda: model.setupExperiment(startTime=0.0))
            self._call("fmi2EnterInitializationMode", model.enterInitializationMode)
        else:
            self._call(
                "fmi3EnterInitializationMode",
                lambda: model.enterInitializationMode(startTime=0.0),
            )
        self.set(inputs)
        name = f"fmi{self._description.version}ExitInitializationMode"
        self._call(name, model.exitInitializationMode)

    def advance(
        self, inputs: Mapping[FmuVariable, Any], step_us: int, variables: Sequence[FmuVariable]
    ) -> dict[str, float | bool | str]:
        """Set inputs, make a step, and return the values of variables; raises ``FmuError``."""
        self.set(inputs)
        self.step(self.time_us, step_us)
        return self.get(variables)

    def _instantiate(self) -> None:
        """Instantiate the model; raises ``FmuError``, 902952 if it makes no instance."""
        try:
            self._make_instance()
        except FmuError as error:
            if getattr(self._model, "component", None) is not None:
                raise
            self._status = _FATAL  # there is nothing to free
            found = diagnostic(
                FMU_NOT_INSTANTIATED,
                file=self._name,
                token=self._description.token,
                reason="; ".join(self._last_lines()) or _SILENT,
            )
            raise FmuError(found) from error

    def _make_instance(self) -> None:
        if self._description.version == 2:
            self._keeps_callbacks = callbacks = self._callbacks()
            self._call(
                "fmi2Instantiate",
                lambda: self._model.instantiate(callbacks=callbacks, loggingOn=True),
            )
        else:

            def note(_: Any, status: int, category: bytes, message: bytes) -> None:
                self._log.append(message or b"")

            self._call("fmi3InstantiateCoSimulation", lambda: self._model.instantiate(
                loggingOn=True, logMessage=note
            ))  # fmt: skip

    def _callbacks(self) -> Any:
        """Return the callbacks of FMI 2.0, with this instance's log."""
        fmi2 = self._library.fmi2

        def note(_: Any, name: bytes, status: int, category: bytes, message: bytes) -> None:
            self._log.append(message or b"")

        callbacks = fmi2.fmi2CallbackFunctions()
        callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(note)
        callbacks.allocateMemory = fmi2.defaultCallbacks.allocateMemory
        callbacks.freeMemory = fmi2.defaultCallbacks.freeMemory
        fmi2.addLoggerProxy(ctypes.byref(callbacks))
        return callbacks

    def _last_lines(self) -> list[str]:
        """Return the last lines of the model's log; only messages need them decoded."""
        texts = (one.decode("utf-8", errors="replace") for one in self._log)
        return [" ".join(text.split())[:_LINE_LENGTH] for text in texts]

    def end(self) -> None:
        """End the instance; a failed one is freed as far as FMI permits."""
        try:
            self._end()
        finally:
            if self._watch is not None:
                self._watch.stop()

    def _end(self) -> None:
        if not self._is_begun:
            return
        self._is_begun = False
        model = self._model
        if self._status < _ERROR:
            self._call(f"fmi{self._description.version}Terminate", model.terminate)
        if self._status < _FATAL:
            model.freeInstance()

    # --- values and steps -----------------------------------------------------------------------

    def set(self, values: Mapping[FmuVariable, Any]) -> None:
        """Set variables; raises ``FmuError``."""
        for access, variables in _by_access(list(values)):
            references = [one.reference for one in variables]
            given = [values[one] for one in variables]
            function = getattr(self._model, f"set{access}")
            self._call(
                f"fmi{self._description.version}Set{access}",
                lambda function=function, references=references, given=given: function(
                    references, given
                ),
            )

    def get(self, variables: Sequence[FmuVariable]) -> dict[str, float | bool | str]:
        """Return the values of variables by name; raises ``FmuError``."""
        found: dict[str, float | bool | str] = {}
        for access, own in _by_access(variables):
            references = [one.reference for one in own]
            function = getattr(self._model, f"get{access}")
            values = self._call(
                f"fmi{self._description.version}Get{access}",
                lambda function=function, references=references: function(references),
            )
            for one, value in zip(own, values, strict=True):
                is_bytes = isinstance(value, bytes)
                found[one.name] = value.decode("utf-8", errors="replace") if is_bytes else value
        return found

    def step(self, time_us: int, step_us: int) -> None:
        """Advance from a time of the run by a step; raises ``FmuError``, 902610 if it wants to end.

        Times are worked out from whole microseconds and never summed.
        """
        time, step = time_us / 1e6, (time_us + step_us) / 1e6 - time_us / 1e6
        model = self._model
        answer = self._call(
            f"fmi{self._description.version}DoStep", lambda: model.doStep(time, step)
        )
        if answer is not None:
            _, wants_end, is_early, _ = answer
            if wants_end or is_early:
                raise FmuError(diagnostic(FMU_ENDED, file=self._name, time=str(Time(time_us))))
        self.time_us = time_us + step_us

    # --- failures -------------------------------------------------------------------------------

    @property
    def _name(self) -> str:
        return str(self._description.file)

    def _call(self, function: str, call: Any) -> Any:
        """Return the result of a call of the library; raises ``FmuError`` (902609)."""
        watch = self._watch
        if watch is not None:
            self._function = function
            watch.begin()
        try:
            return call()
        except Exception as error:  # FMPy raises bare exceptions, ctypes its own
            status = getattr(error, "status", None)
            self._status = max(self._status, _ERROR if status is None else status)
            text = str(error) if status is None else _status_name(status)
            reason = "; ".join([" ".join(text.split()), *self._last_lines()])
            found = diagnostic(
                FMU_FAILED,
                file=self._name,
                function=function,
                time=str(Time(self.time_us)),
                reason=reason,
            )
            raise FmuError(found) from error
        finally:
            if watch is not None:
                watch.end()

    def _report_late(self) -> None:
        late = diagnostic(
            FMU_LATE,
            file=self._name,
            function=self._function,
            time=str(Time(self.time_us)),
            limit=str(Time(self._limit_us)),
        )
        print(late.render(), file=sys.stderr, flush=True)


def _status_name(status: int) -> str:
    name = _STATUSES[status] if 0 <= status < len(_STATUSES) else "?"
    return f"status {status} ({name})"


def _in_this_folder(call: Any) -> Any:
    """Return the result of a call; the working directory stays, even if the call fails."""
    before = os.getcwd()  # noqa: PTH109 - as the call changes it
    try:
        return call()
    finally:
        os.chdir(before)


def _by_access(variables: Sequence[FmuVariable]) -> list[tuple[str, list[FmuVariable]]]:
    """Return the variables by the function that gets or sets them."""
    found: dict[str, list[FmuVariable]] = {}
    for one in variables:
        found.setdefault(one.access, []).append(one)
    return list(found.items())
