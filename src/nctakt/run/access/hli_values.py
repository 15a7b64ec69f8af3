# SPDX-License-Identifier: MIT
"""The present values of an axis or a channel by the names of the HLI, bound once.

In: the cells of a machine. Out: ``hli.axis("X").command``, also as ``hli.axis("X")["command"]``;
``dict(hli.axis("X"))`` keeps the values of a moment.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, ClassVar, NoReturn

from nctakt.base.diagnostics import NOTHING
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.hli.plc_entries import (
    AXIS_ALIASES,
    AXIS_NAMES,
    CHANNEL_ALIASES,
    CHANNEL_NAMES,
)
from nctakt.kernel.kernel import Kernel
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import UNKNOWN_HLI_VALUE
from nctakt.run.access.bound_values import BoundAttribute, BoundValues, value_at


class HliValues(BoundValues, Mapping[str, float]):
    """Values by their names, as attributes and as items; raises ``Failure`` (901012)."""

    __slots__ = ()
    names: ClassVar[tuple[str, ...]] = ()
    aliases: ClassVar[Mapping[str, str]] = {}
    indices: ClassVar[dict[str, int]] = {}

    def __init__(self, kernel: Kernel, cells: Mapping[str, int]) -> None:
        super().__init__(kernel, [cells[name] for name in self.names])

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.indices = {name: index for index, name in enumerate(cls.names)}
        cls.indices |= {long: cls.indices[short] for long, short in cls.aliases.items()}
        for name, index in cls.indices.items():
            setattr(cls, name, BoundAttribute(index))

    def __getitem__(self, name: str) -> float:
        index = self.indices.get(name)
        if index is None:
            known = ", ".join(self.names)
            near = nearest(str(name), self.indices) or NOTHING
            raise Failure(diagnostic(UNKNOWN_HLI_VALUE, name=name, nearest=near, known=known))
        return value_at(self, index)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return repr(dict(self))

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> float:
            """Return the value of this name."""

    else:

        def __getattr__(self, name: str) -> NoReturn:
            near = nearest(name, self.indices)
            hint = f"; did you mean {near}?" if near else ""
            raise AttributeError(f"there is no value {name} here{hint}", name=name, obj=self)


class AxisValues(HliValues):
    """The values of an axis: ``command_position``, ``actual_position``, ``state`` …"""

    __slots__ = ()
    names = AXIS_NAMES
    aliases = AXIS_ALIASES

    if TYPE_CHECKING:  # for completion in editors; tests compare it with the names
        command: float
        command_position: float
        actual: float
        actual_position: float
        target: float
        target_position: float
        machine: float
        machine_position: float
        program: float
        program_position: float
        distance_to_go: float
        override_total: float
        state: float


class ChannelValues(HliValues):
    """The values of a channel: ``path_feed``, ``block``, ``state`` …"""

    __slots__ = ()
    names = CHANNEL_NAMES
    aliases = CHANNEL_ALIASES

    if TYPE_CHECKING:  # what editors complete; tests hold it to the names
        state: float
        paused: float
        armed: float
        error: float
        retrace: float
        history: float
        inside_rt_loop: float
        history_size: float
        tool_time: float
        tool_distance: float
        life_serial: float
        life_tool: float
        life_time: float
        life_distance: float
        error_serial: float
        override: float
        override_total: float
        path_speed: float
        path_feed: float
        distance_to_go: float
        block: float
        active_cycles: float
