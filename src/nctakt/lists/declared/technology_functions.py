# SPDX-License-Identifier: MIT
"""M, H and spindle functions in a channel list: declarations and the record of one function.

A function that the list does not name is not defined, except for the internal ones, which are
defined and not output. Its synchronisation type decides when it is output and when the channel
waits (P-CHAN-00041); its process time counts in a simulation of the machining time.
"""

from __future__ import annotations

from collections.abc import Collection

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.parameter import with_indices
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.machines.lists import (
    LEAD_TIME_TOO_SHORT,
    LEAD_WITHOUT_EARLY_TYPE,
    PROCESS_TIME_WITHOUT_WAITING,
    SYNCHRONISATION_NOT_OF_FUNCTION,
    UNKNOWN_FUNCTION_AXIS,
)

MAX_FUNCTIONS = 1000
#: M functions of the controller itself, defined without an entry.
INTERNAL_M_FUNCTIONS = (0, 1, 2, 3, 4, 17, 19, 29, 30)

#: The synchronisation types with their bits, as far as known.
SYNCHRONISATIONS: dict[str, int | None] = {
    "NO_SYNCH": 0x0,
    "MOS": 0x1,
    "MVS_SVS": 0x2,
    "MVS_SNS": 0x4,
    "MNS_SNS": 0x8,
    "MNE_SNS": 0x20,
    "MVS_SLM": 0x4000,
    "MVS_SLP": 0x8000,
    "MOS_TS": 0x40000,
    "MEP_SVS": 0x1000000,
    "MEP_MOS": 0x100000,
    "MET_SVS": 0x2000000,
    "MET_MOS": 0x200000,
}
#: Modifiers of a synchronisation type.
MODIFIERS: dict[str, int | None] = {
    "PLC_INFO": 0x20000,
    "BWD_SYNCH": 0x400000,
    "FWD_SYNCH": 0x800000,
    "FAW_SYNCH": 0x10000000,
}
NOT_VALID = "NOT_VALID"
FLAGS = {NOT_VALID: 0x80000000, **SYNCHRONISATIONS, **MODIFIERS}
_REPLACEMENT = ("MVS_SVS",)
#: Units of the list for each mm or s of a lead.
_LEAD_UNITS = {"MEP_SVS": 1e4, "MEP_MOS": 1e4, "MET_SVS": 1e6, "MET_MOS": 1e6}

#: The spindle functions by their number in the list's keys; ``s`` is the S word.
SPINDLE_FUNCTION_KEYS = ("s", "m3", "m4", "m5", "m19")


@dataclass(frozen=True, slots=True)
class TechnologyFunction:
    """One M or H function, T, or a spindle's M3, M4, M5, M19 or S word.

    ``synchronisation`` is its type without modifiers. ``axis_name``: the axis or spindle in whose
    section of the interface it is output, empty for the channel's. ``process_time_us``: µs.
    ``lead``: how far ahead of its place on the path it is output, mm (MEP) or s (MET).
    """

    number: int
    synchronisation: str
    modifiers: tuple[str, ...]
    process_time_us: float
    axis_name: str
    lead: float = 0.0

    @property
    def synchronisation_bits(self) -> int:
        """The bits of its type and modifiers; 0 if they are unknown or invalid."""
        known = {**SYNCHRONISATIONS, **MODIFIERS}
        bits = 0
        for name in (self.synchronisation, *self.modifiers):
            bits |= known.get(name) or 0
        return bits


#: The synchronisation types of T.
TOOL_SYNCHRONISATIONS = ("MOS", "MVS_SVS", "MVS_SNS", "MNS_SNS", "MNE_SNS")


def technology_functions(
    values: Values,
    letter: str,
    axes: Collection[str],
    collector: Collector,
    internal: tuple[int, ...] = (),
) -> dict[int, TechnologyFunction]:
    """Return the functions of ``letter`` (``m``, ``h``) that are defined, by number, ascending.

    ``axes``: the names of the channel's axes and spindles; a function for any other axis is the
    channel's (21131).
    """
    functions: dict[int, TechnologyFunction] = {}
    numbers = {*values.indices(f"{letter}_synch[]"), *internal}
    for number in sorted(numbers):
        default = "NO_SYNCH" if number in internal else NOT_VALID
        synchronisation, modifiers = split(values.names(f"{letter}_synch[]", number), default)
        if synchronisation == NOT_VALID:
            continue
        functions[number] = TechnologyFunction(
            number,
            synchronisation,
            modifiers,
            process_time_us(
                values, (f"{letter}_prozess_zeit[]", number), synchronisation, collector
            ),
            _axis_of(values, letter, number, axes, collector),
            _lead(values, (f"{letter}_pre_outp[]", number), synchronisation, collector),
        )
    return functions


def _lead(values: Values, at: tuple[str, int], synchronisation: str, collector: Collector) -> float:
    """Return how much a function goes out early, mm or s; other types than MEP, MET do not."""
    lead = values.integer(*at)
    unit = _LEAD_UNITS.get(synchronisation)
    if unit is not None:
        return lead / unit
    if lead:
        values.report(
            collector,
            LEAD_WITHOUT_EARLY_TYPE,
            at,
            key=with_indices(at[0], at[1:]),
            synchronisation=synchronisation,
        )
    return 0.0


def tool_output(values: Values, collector: Collector) -> TechnologyFunction | None:
    """Return how T is passed to the PLC, ``None``: not at all (P-CHAN-00086)."""
    synchronisation, modifiers = split(values.names("tool.synch"), "NO_SYNCH")
    if synchronisation == "NO_SYNCH":
        return None
    if synchronisation not in TOOL_SYNCHRONISATIONS:
        values.report(
            collector,
            SYNCHRONISATION_NOT_OF_FUNCTION,
            ("tool.synch",),
            key="tool.synch",
            value=synchronisation,
            default=_REPLACEMENT[0],
        )
        synchronisation = _REPLACEMENT[0]
    return TechnologyFunction(0, synchronisation, modifiers, 0.0, "")


def process_time_us(
    values: Values, at: tuple[str, int], synchronisation: str, collector: Collector
) -> float:
    """Return the process time of a function; nothing waits for functions of type MOS (20760)."""
    tenths = values.integer(*at)
    if tenths and synchronisation == "MOS":
        values.report(
            collector,
            PROCESS_TIME_WITHOUT_WAITING,
            at,
            key=with_indices(at[0], at[1:]),
            value=tenths,
        )
        return 0.0
    return tenths / 10


def check_lead_times(values: Values, cycle_time_us: int, collector: Collector) -> None:
    """Check that a function of the type MET_SVS is output at least one tick early (21203)."""
    for letter in "mh":
        for number in values.indices(f"{letter}_synch[]"):
            if "MET_SVS" not in values.names(f"{letter}_synch[]", number):
                continue
            lead = values.given(f"{letter}_pre_outp[]", number)
            if lead is None or float(str(lead.value)) < cycle_time_us:
                at = (f"{letter}_synch[]", number)
                values.report(
                    collector,
                    LEAD_TIME_TOO_SHORT,
                    at,
                    key=with_indices(at[0], at[1:]),
                    lead=with_indices(f"{letter}_pre_outp[]", (number,)),
                    minimum=cycle_time_us,
                )


def _axis_of(
    values: Values, letter: str, number: int, axes: Collection[str], collector: Collector
) -> str:
    name = values.text(f"{letter}_default_outp_ax_name[]", number)
    if name and name not in axes:
        key = (f"{letter}_default_outp_ax_name[]", number)
        path = with_indices(key[0], (number,))
        values.report(collector, UNKNOWN_FUNCTION_AXIS, key, key=path, value=name)
        return ""
    return name


def split(flags: tuple[str, ...], default: str) -> tuple[str, tuple[str, ...]]:
    """Return the type and the modifiers in ``flags``; without a type it is NO_SYNCH."""
    types = [name for name in flags if name in SYNCHRONISATIONS and name != "NO_SYNCH"]
    modifiers = tuple(name for name in flags if name in MODIFIERS)
    if types:
        return types[0], modifiers
    if NOT_VALID in flags:
        return default, modifiers
    return "NO_SYNCH", modifiers
