# SPDX-License-Identifier: MIT
"""The values of the HLI as a PLC in Python meets them: waiting functions and jobs, named values.

The same for a scripted PLC (``run/plcs/plc_view.py``) and for one in another process
(``plc_side.py``).
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.hli.layout import AXIS, CHANNEL, LAMPS
from nctakt.messages import diagnostic
from nctakt.messages.plcs.plc import UNKNOWN_HLI_VALUE

#: The values of ``PlcView.axis`` and ``PlcView.channel``.
AXIS_NAMES = tuple(entry.name for entry in AXIS.entries if entry.source)
CHANNEL_NAMES = tuple(entry.name for entry in CHANNEL.entries if entry in LAMPS or entry.source)

#: Longer names of these values, which say more where they are attributes.
AXIS_ALIASES = {
    "command_position": "command",
    "actual_position": "actual",
    "target_position": "target",
    "machine_position": "machine",
    "program_position": "program",
}
CHANNEL_ALIASES = {"path_feed": "path_speed", "override": "override_total"}


@dataclass(frozen=True, slots=True)
class TechnologyEntry:
    """A function that waits for its acknowledgement.

    ``letter`` is M, H or T, ``sequence`` its number among those of the same tick and section,
    ``time_us`` its time stamp. ``is_realtime``: a realtime cycle has commanded it (POS_RT).
    ``synchronisation`` is its type: MOS for those of cycles, else that of the channel list
    (P-CHAN-00041, P-CHAN-00027).
    ``process_time_us`` is its time in the channel list (P-CHAN-00040, P-CHAN-00026), ``axis`` its
    axis or spindle (P-CHAN-00039, P-CHAN-00025), empty for the channel. ``value`` is its value in
    the program, as in ``M110=130``, 0 without one. ``serial`` distinguishes it from earlier entries
    in its slot. A PLC annotates it as ``nctakt.Function``.

    >>> names = []
    >>> class Listener(Plc):
    ...     @on("M100")
    ...     def listen(self, hli: HliView, function: Function) -> None:
    ...         names.append(function.name)
    >>> run = Controller().run(NcText("listen.nc", "M100 M30"), plc=Listener())
    >>> names
    ['M100']
    """

    letter: str
    number: int
    sequence: int
    time_us: int
    is_realtime: bool
    process_time_us: float
    axis: str
    slot: int
    value: int = 0
    serial: int = 0
    synchronisation: str = "MOS"

    @property
    def identifier(self) -> str:
        """``POS_RT`` for a function of a realtime cycle, otherwise empty."""
        return "POS_RT" if self.is_realtime else ""

    @property
    def name(self) -> str:
        """The function as in a program: ``M100``."""
        return f"{self.letter}{self.number}"

    @property
    def key(self) -> tuple[str, int]:
        """Its section and slot."""
        return "realtime" if self.is_realtime else "program", self.slot

    @property
    def stamp(self) -> tuple[int, int]:
        """The numbers that distinguish it from earlier entries in its slot."""
        return self.time_us, self.sequence


@dataclass(frozen=True, slots=True)
class SpindleEntry:
    """A job of a spindle that the PLC turns, until it is acknowledged.

    ``function``: M 3, 4, 5 or 19. ``speed``: in revolutions per minute. ``position``: of M19, in
    degrees. ``direction``: of M19, 1 forward, -1 backward, 0 the shorter way. ``speed_before``: the
    speed after the last acknowledged job, in revolutions per minute, negative under M4. ``index``:
    that of the spindle in the channel. ``serial`` distinguishes it from earlier jobs. A PLC
    annotates it as ``nctakt.SpindleJob``.

    >>> job = SpindleJob("S3", 3, 1000.0, 0.0, 0, 20_000, 0.0, 2)
    >>> job.name, job.speed
    ('S3', 1000.0)
    """

    spindle: str
    function: int
    speed: float
    position: float
    direction: int
    time_us: int
    speed_before: float
    index: int
    serial: int = 0

    @property
    def name(self) -> str:
        """The name of the spindle."""
        return self.spindle

    @property
    def key(self) -> tuple[str, int]:
        """The index of its spindle."""
        return "spindle", self.index

    @property
    def stamp(self) -> tuple[int, int]:
        """The numbers that distinguish it from earlier jobs of the spindle."""
        return self.time_us, self.function


class NamedValues(dict[str, float]):
    """Values by the names of the interface, as items and as attributes.

    Raises ``Failure`` (901012) for another name.
    """

    __slots__ = ()

    def __missing__(self, name: object) -> float:
        short = AXIS_ALIASES.get(str(name)) or CHANNEL_ALIASES.get(str(name), "")
        if short in self:
            return self[short]
        near = nearest(str(name), self) or NOTHING
        raise Failure(diagnostic(UNKNOWN_HLI_VALUE, name=name, nearest=near, known=", ".join(self)))

    def __getattr__(self, name: str) -> float:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]
