# SPDX-License-Identifier: MIT
"""M, H and spindle functions in a channel list: declarations and the record of one function.

A function that the list does not name is not defined, except for the internal ones, which are
defined and not output. Its synchronisation type decides when it is output and when the channel
waits (P-CHAN-00041); its process time counts in a simulation of the machining time.
"""

from __future__ import annotations

from collections.abc import Collection

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, ValueType, with_indices
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.lists import (
    INVALID_SYNCHRONISATION_TYPE,
    LEAD_TIME_TOO_SHORT,
    PROCESS_TIME_WITHOUT_WAITING,
    SYNCHRONISATION_NOT_OF_FUNCTION,
    UNKNOWN_FUNCTION_AXIS,
)

MAX_FUNCTIONS = 1000
_MAX_SPINDLES = 6
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
_FLAGS = {NOT_VALID: 0x80000000, **SYNCHRONISATIONS, **MODIFIERS}
_REPLACEMENT = ("MVS_SVS",)

#: The spindle functions by their number in the list's keys; ``s`` is the S word.
SPINDLE_FUNCTION_KEYS = ("s", "m3", "m4", "m5", "m19")


@dataclass(frozen=True, slots=True)
class TechnologyFunction:
    """One M or H function, T, or a spindle's M3, M4, M5, M19 or S word.

    ``synchronisation`` is its type without modifiers. ``axis_name``: the axis or spindle in whose
    section of the interface it is output, empty for the channel's. ``process_time_us``: µs.
    """

    number: int
    synchronisation: str
    modifiers: tuple[str, ...]
    process_time_us: float
    axis_name: str

    @property
    def synchronisation_bits(self) -> int:
        """The bits of its type and modifiers; 0 for what is not known or not valid."""
        known = {**SYNCHRONISATIONS, **MODIFIERS}
        bits = 0
        for name in (self.synchronisation, *self.modifiers):
            bits |= known.get(name) or 0
        return bits


def _synchronisation(id_: str, path: str, default: str, en: str, de: str) -> Parameter:
    return Parameter(
        id_,
        path,
        ValueType.FLAGS,
        (default,),
        Text(en, de),
        names=_FLAGS,
        invalid=_REPLACEMENT,
        invalid_message=INVALID_SYNCHRONISATION_TYPE,
    )


def _process_time(id_: str, path: str, en: str, de: str) -> Parameter:
    return Parameter(id_, path, ValueType.UNS32, 0, Text(en, de), unit="0.1 µs")


def _axis_name(id_: str, path: str, en: str, de: str) -> Parameter:
    text = Text(en, de)
    return Parameter(id_, path, ValueType.STRING, "", text, high=16)


_INDEX = f"[0..{MAX_FUNCTIONS - 1}]"

TECHNOLOGY = (
    _synchronisation(
        "P-CHAN-00041",
        f"m_synch{_INDEX}",
        NOT_VALID,
        "Synchronisation type of an M function",
        "Synchronisationsart einer M-Funktion",
    ),
    _synchronisation(
        "P-CHAN-00027",
        f"h_synch{_INDEX}",
        NOT_VALID,
        "Synchronisation type of an H function",
        "Synchronisationsart einer H-Funktion",
    ),
    _process_time(
        "P-CHAN-00040",
        f"m_prozess_zeit{_INDEX}",
        "Time that an M function takes, for simulations",
        "Dauer einer M-Funktion, für Simulationen",
    ),
    _process_time(
        "P-CHAN-00026",
        f"h_prozess_zeit{_INDEX}",
        "Time that an H function takes, for simulations",
        "Dauer einer H-Funktion, für Simulationen",
    ),
    _axis_name(
        "P-CHAN-00039",
        f"m_default_outp_ax_name{_INDEX}",
        "Axis for which an M function is output; empty: for the channel",
        "Achse, für die eine M-Funktion ausgegeben wird; leer: für den Kanal",
    ),
    _axis_name(
        "P-CHAN-00025",
        f"h_default_outp_ax_name{_INDEX}",
        "Axis for which an H function is output; empty: for the channel",
        "Achse, für die eine H-Funktion ausgegeben wird; leer: für den Kanal",
    ),
)

#: The synchronisation types of T.
TOOL_SYNCHRONISATIONS = ("MOS", "MVS_SVS", "MVS_SNS", "MNS_SNS", "MNE_SNS")

TOOL = (
    _synchronisation(
        "P-CHAN-00086",
        "tool.synch",
        "NO_SYNCH",
        "Synchronisation type of T; NO_SYNCH: T is not output",
        "Synchronisationsart von T; NO_SYNCH: T wird nicht ausgegeben",
    ),
)

_SPINDLE_IDS = {
    "s": ("P-CHAN-00081", "P-CHAN-00080"),
    "m3": ("P-CHAN-00045", "P-CHAN-00044"),
    "m4": ("P-CHAN-00047", "P-CHAN-00046"),
    "m5": ("P-CHAN-00049", "P-CHAN-00048"),
    "m19": ("P-CHAN-00043", "P-CHAN-00042"),
}


def _spindle_function(name: str) -> tuple[Parameter, Parameter]:
    prefix = f"spindel[0..{_MAX_SPINDLES - 1}].{name}"
    word = name.upper()
    synchronisation, process_time = _SPINDLE_IDS[name]
    return (
        _synchronisation(
            synchronisation,
            f"{prefix}_synch",
            "NO_SYNCH",
            f"Synchronisation type of a spindle's {word}",
            f"Synchronisationsart von {word} einer Spindel",
        ),
        _process_time(
            process_time,
            f"{prefix}_prozess_zeit",
            f"Time that a spindle's {word} takes, for simulations",
            f"Dauer von {word} einer Spindel, für Simulationen",
        ),
    )


SPINDLE_FUNCTIONS: tuple[Parameter, ...] = tuple(
    parameter for name in SPINDLE_FUNCTION_KEYS for parameter in _spindle_function(name)
)


def technology_functions(
    values: Values,
    letter: str,
    axes: Collection[str],
    collector: Collector,
    internal: tuple[int, ...] = (),
) -> dict[int, TechnologyFunction]:
    """Return the functions of ``letter`` (``m``, ``h``) that are defined, by number, ascending.

    ``axes``: the names of the channel's axes and spindles; a function for any other one is the
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
        )
    return functions


def tool_output(values: Values, collector: Collector) -> TechnologyFunction | None:
    """Return how T goes to the PLC, ``None``: not at all (P-CHAN-00086)."""
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
    """Return the process time of a function; nothing waits for one of the type MOS (20760)."""
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
