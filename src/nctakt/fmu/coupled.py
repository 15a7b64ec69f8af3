# SPDX-License-Identifier: MIT
"""An FMU coupled to a run in addition to the PLC: a plant that sees the machine and answers.

In: its file, a communication step, connections. Out: values that the machine's tick latches as
inputs from outside, so that a tape has them and a replay needs no FMU.

The machine goes first: after its n ticks the FMU gets their results, makes its step over the same
time, and its outputs count from the next tick on (RC-002), after those of a PLC.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from nctakt.base.diagnostics import Span
from nctakt.base.failure import Failure
from nctakt.files.access import FileAccess
from nctakt.fmu.archive import unpack
from nctakt.fmu.connections import Connection, Connections, FmuTables
from nctakt.fmu.description import FmuVariable, read_fmu
from nctakt.fmu.failures import FmuError
from nctakt.fmu.instance import FmuInstance
from nctakt.fmu.isolated import IsolatedInstance
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import FMU_STEP_NOT_POSSIBLE, FMU_VALUE_REFUSED
from nctakt.project.project_file import FmuSettings
from nctakt.run.access.inputs import FMU, NEVER

if TYPE_CHECKING:
    from nctakt.run.realtime.assembly import AssembledMachine


class Fmu:
    """An FMU for ``Controller.run(…, fmu=…)``; ``inputs`` and ``outputs`` name what it is tied to.

    ``every``: its communication step, a whole number of ticks. ``inputs``: its variables -> signals
    and variables of the machine; ``outputs``: its variables -> what they set; without both,
    variables of equal names. ``start``: values before the first step; ``places``: where a file has
    them. ``isolate``: it runs in a separate process, which is ended if a call lasts longer than
    ``limit``; otherwise such a call is reported. Raises ``FmuError``.
    """

    def __init__(
        self,
        file: str | Path,
        *,
        every: TimeLike = "1 tick",
        inputs: Mapping[str, str] | None = None,
        outputs: Mapping[str, str] | None = None,
        start: Mapping[str, float | bool | str] | None = None,
        places: Mapping[str, tuple[Span, str]] = MappingProxyType({}),
        isolate: bool = False,
        limit: TimeLike = "10 s",
        access: FileAccess | None = None,
    ) -> None:
        self._every = read_time(every)
        self._description = read_fmu(Path(file), access or FileAccess())
        self._tables = FmuTables(inputs or {}, outputs or {}, start or {}, places)
        self._is_isolated, self._limit = isolate, read_time(limit)
        self._next = NEVER
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._instance: FmuInstance | IsolatedInstance | None = None

    def begin(self, machine: AssembledMachine) -> None:
        """Get ready for a run from the machine's next tick on; raises ``FmuError``."""
        self.close()
        self._machine = machine
        self._step_us = self._checked_step(machine.configuration.cycle_time_us)
        self._ticks = self._step_us // machine.configuration.cycle_time_us
        connections = Connections(self._description, self._tables, machine)
        self._inputs = [(one, connections.reader(one.name)) for one in connections.inputs]
        self._outputs = connections.outputs
        self._read = [one.variable for one in self._outputs]
        self._folder = tempfile.TemporaryDirectory(prefix="nctakt-fmu-", ignore_cleanup_errors=True)
        unpack(self._description.file, Path(self._folder.name))
        kind = IsolatedInstance if self._is_isolated else FmuInstance
        limit_s = self._limit.us(machine.configuration.cycle_time_us) / 1e6
        instance = kind(self._description, Path(self._folder.name), limit_s)
        self._instance = instance
        instance.begin(connections.start, self._values())
        self._next = self._first = machine.kernel.tick

    def _checked_step(self, cycle_time_us: int) -> int:
        """Return the communication step in µs; raises ``FmuError`` (902611)."""
        step_us = self._every.us(cycle_time_us)
        inside_us = round(self._description.step_us)
        for unit_us in (cycle_time_us, inside_us):
            if step_us == 0 or (unit_us and step_us % unit_us):
                found = diagnostic(
                    FMU_STEP_NOT_POSSIBLE,
                    file=str(self._description.file),
                    every=str(self._every),
                    step=str(Time(unit_us)),
                )
                raise FmuError(found)
        return step_us

    @property
    def next_tick(self) -> int:
        """The tick before which it is due."""
        return self._next

    def step(self) -> None:
        """Continue up to the machine's next tick and write the outputs; raises ``FmuError``."""
        instance = self._instance
        assert instance is not None
        if self._next > self._first:
            values = instance.advance(self._values(), self._step_us, self._read)
        else:
            values = instance.get(self._read)
        for one in self._outputs:
            self._write(one, values[one.variable.name])
        self._next += self._ticks

    def _values(self) -> dict[FmuVariable, Any]:
        """Return the values of the inputs as the machine's latest tick has left them."""
        found: dict[FmuVariable, Any] = {}
        for connection, read in self._inputs:
            value = connection.scaled(read())
            try:
                found[connection.variable] = connection.variable.converted(value)
            except ValueError as error:
                raise self._refused(value, connection.name, connection.variable.name) from error
        return found

    def _write(self, connection: Connection, value: float | bool | str) -> None:
        value = connection.scaled(value)
        try:
            self._machine.write(connection.name, value, FMU)
        except Failure as failure:
            refused = self._refused(value, connection.variable.name, connection.name)
            raise FmuError(*refused.diagnostics, *failure.diagnostics) from failure

    def _refused(self, value: object, origin: str, target: str) -> FmuError:
        at_us = 0 if self._instance is None else self._instance.time_us
        return FmuError(
            diagnostic(
                FMU_VALUE_REFUSED,
                file=str(self._description.file),
                value=value,
                origin=origin,
                target=target,
                time=str(Time(at_us)),
            )
        )

    def close(self) -> None:
        """Free the instance and its files; raises ``FmuError`` if it fails even then."""
        instance, self._instance = self._instance, None
        folder, self._folder = self._folder, None
        self._next = NEVER
        try:
            if instance is not None:
                instance.end()
        finally:
            if folder is not None:
                folder.cleanup()


def fmu_of(settings: FmuSettings, access: FileAccess | None = None) -> Fmu:
    """Return the FMU of a project or a command; raises ``FmuError``."""
    assert settings.file is not None
    return Fmu(
        settings.file,
        every=settings.every,
        inputs=settings.inputs,
        outputs=settings.outputs,
        start=settings.start,
        places=settings.places,
        isolate=settings.isolate,
        limit=settings.limit,
        access=access,
    )
