# SPDX-License-Identifier: MIT
"""The start-up list (hochlauf.lis, startup.lis): the parts of the controller (P-STUP).

In: checked values. Out: ``StartupConfiguration``: the channels and axes, their lists, and the
values of the controller as a whole.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text
from nctakt.lists.format.parameter import Alias, Parameter, ValueType
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.table import ParameterTable
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.backward import BACKWARD_MEMORY_TOO_SMALL
from nctakt.messages.variables import INVALID_ALIGNMENT

MAX_CHANNELS = 12
MAX_AXES = 64
MAX_VOLUMETRIC_COMPENSATIONS = 5
_PATH_LENGTH = 256
#: Alignments of a structure's members in bytes; 0: chosen by the controller.
ALIGNMENTS = (0, 1, 2, 4, 8)

_LOOK_AHEAD = {
    "FCT_LOOK_AHEAD_LOW": 30,
    "FCT_LOOK_AHEAD_STANDARD": 120,
    "FCT_LOOK_AHEAD_HIGH": 190,
}
_CUSTOM_LOOK_AHEAD = "FCT_LOOK_AHEAD_CUSTOM"
_INTERPOLATOR_FLAGS: dict[str, int | None] = dict.fromkeys(
    (
        "FCT_IPO_DEFAULT",
        *_LOOK_AHEAD,
        _CUSTOM_LOOK_AHEAD,
        "FCT_LOOK_AHEAD_OPT",
        "FCT_SYNC",
        "FCT_LIFT_UP_TIME",
        "FCT_SHIFT_NCBL",
        "FCT_CALC_STATE_AT_T",
    )
)

#: Lists that are read and checked, but have no effect: entry -> kind of list.
_OTHER_KINDS = {
    "hand_mds": "manual_mode",
    "achs_kw[]": "axis_compensation",
    "vol_comp[].file_name": "volumetric_compensation",
    "hw_configuration_list": "hardware",
    "scene_mds[]": "scene",
}

#: Minimum memory of backward motion in bytes (P-STUP-00033), if there is one.
MIN_BACKWARD_MEMORY = 16384


@dataclass(frozen=True, slots=True)
class ListReference:
    """A list that another list names: its path as written and its position there."""

    path: str
    span: Span
    line: str


@dataclass(frozen=True, slots=True)
class ChannelStartup:
    """The entries of the start-up list for one channel; ``None``: no such list.

    ``backward_memory_bytes`` 0: no backward motion on the path (P-STUP-00033).
    ``look_ahead_blocks``: the number of blocks of the look-ahead (P-STUP-00070/71).
    """

    index: int
    parameters: ListReference | None
    variables: ListReference | None
    tools: ListReference | None
    zero_offsets: ListReference | None
    clamp_offsets: ListReference | None
    backward_memory_bytes: int
    look_ahead_blocks: int


@dataclass(frozen=True, slots=True)
class StartupConfiguration:
    """The start-up list; ``axes`` has an item per axis, ``None`` without a list.

    ``others``: lists that are read and checked without an effect, each with its kind.
    ``external_variables_bytes``: memory for the V.E variables of a channel, 0 if not limited.
    ``member_alignment``: P-STUP-00145, 0 automatic.
    """

    channel_defaults: ListReference | None
    channels: tuple[ChannelStartup, ...]
    axis_defaults: ListReference | None
    axes: tuple[ListReference | None, ...]
    rtconf: ListReference | None
    others: tuple[tuple[str, ListReference], ...]
    external_variables_bytes: int
    member_alignment: int
    error_texts: str


def _list(id_: str, path: str, en: str, de: str, *aliases: str) -> Parameter:
    """Return the declaration of a path to another list."""
    old = tuple(Alias(alias, silent=True) for alias in aliases)
    return Parameter(
        id_, path, ValueType.STRING, "", Text(en, de), high=_PATH_LENGTH, aliases=old, restart=True
    )


_LISTS = (
    Parameter(
        "P-STUP-00008",
        "listen",
        ValueType.NAME,
        "ASCII",
        Text(
            "Format of the lists; ASCII and XML are read",
            "Format der Listen; gelesen werden ASCII und XML",
        ),
        names={"ASCII": None, "BINAER": None, "BINARY": None, "XML": None},
        restart=True,
    ),
    Parameter(
        "P-STUP-00001",
        "kanal_anzahl",
        ValueType.UNS16,
        1,
        Text("Number of channels", "Anzahl der Kanäle"),
        low=1,
        high=MAX_CHANNELS,
        restart=True,
    ),
    Parameter(
        "P-STUP-00014",
        "zahl_mds",
        ValueType.UNS16,
        0,
        Text("Number of axis lists", "Anzahl der Achslisten"),
        high=MAX_AXES,
        restart=True,
    ),
    _list(
        "P-STUP-00034",
        "default_sda_mds",
        "List with defaults for all channels",
        "Liste mit Standardwerten für alle Kanäle",
    ),
    _list("P-STUP-00009", "sda_mds[0..11]", "List of a channel", "Liste eines Kanals"),
    _list(
        "P-STUP-00035",
        "default_achs_mds",
        "List with defaults for all axes",
        "Liste mit Standardwerten für alle Achsen",
    ),
    _list("P-STUP-00015", f"achs_mds[0..{MAX_AXES - 1}]", "List of an axis", "Liste einer Achse"),
    _list(
        "P-STUP-00146",
        "ve_var[0..11]",
        "Variables of a channel",
        "Variablen eines Kanals",
        "ext_var[0..11]",
    ),
    _list(
        "P-STUP-00010",
        "werkz_data[0..11]",
        "Tools of a channel",
        "Werkzeuge eines Kanals",
    ),
    _list(
        "P-STUP-00011",
        "nullp_data[0..11]",
        "Zero offsets of a channel",
        "Nullpunktverschiebungen eines Kanals",
    ),
    _list(
        "P-STUP-00012",
        "pzv_data[0..11]",
        "Clamp offsets of a channel",
        "Platzverschiebungen eines Kanals",
    ),
    _list(
        "P-STUP-00013",
        "hand_mds",
        "Manual mode of all channels",
        "Handbetrieb aller Kanäle",
    ),
    _list(
        "P-STUP-00017",
        f"achs_kw[0..{MAX_AXES - 1}]",
        "Compensations of an axis",
        "Kompensationen einer Achse",
    ),
    _list(
        "P-STUP-00101",
        f"vol_comp[0..{MAX_VOLUMETRIC_COMPENSATIONS - 1}].file_name",
        "A volumetric compensation",
        "Eine volumetrische Kompensation",
    ),
    _list(
        "P-STUP-00136",
        "hw_configuration_list",
        "Hardware devices",
        "Hardwaregeräte",
    ),
    _list(
        "P-STUP-00137",
        "scene_mds[0..11]",
        "Scene of a channel with its collisions",
        "Szene eines Kanals mit ihren Kollisionen",
    ),
    _list("P-STUP-00135", "rtconf_lis", "Scheduling of the threads", "Scheduling der Threads"),
)

_CONTROLLER = (
    Parameter(
        "P-STUP-00033",
        "fb_storage_size[0..11]",
        ValueType.UNS32,
        0,
        Text(
            "Memory for backward motion on the path; 0: not available",
            "Speicher für das Rückwärtsfahren auf der Bahn; 0: nicht verfügbar",
        ),
        unit="byte",
        restart=True,
    ),
    Parameter(
        "P-STUP-00037",
        "ext_var_max",
        ValueType.UNS16,
        0,
        Text(
            "Memory for the V.E variables of each channel, in blocks of 24 byte; 0: no limit",
            "Speicher für die V.E-Variablen jedes Kanals, in Blöcken zu 24 Byte; 0: ohne Grenze",
        ),
        unit="24 byte",
        restart=True,
    ),
    Parameter(
        "P-STUP-00145",
        "ext_var_struct_member_alignment",
        ValueType.UNS16,
        0,
        Text(
            "Alignment of the members of V.E structures: 1, 2, 4, 8, or 0 for automatic",
            "Ausrichtung der Elemente von V.E-Strukturen: 1, 2, 4, 8 oder 0 für automatisch",
        ),
        unit="byte",
        restart=True,
    ),
    Parameter(
        "P-STUP-00070",
        "configuration.channel[0..11].interpolator.function",
        ValueType.FLAGS,
        ("FCT_IPO_DEFAULT",),
        Text(
            "Functions of the interpolator, above all the size of the look-ahead",
            "Funktionen des Interpolators, vor allem die Weite der Vorausschau",
        ),
        names=_INTERPOLATOR_FLAGS,
        restart=True,
    ),
    Parameter(
        "P-STUP-00071",
        "configuration.channel[0..11].interpolator.parameter",
        ValueType.UNS32,
        120,
        Text(
            "Blocks of look-ahead with FCT_LOOK_AHEAD_CUSTOM",
            "Sätze der Vorausschau bei FCT_LOOK_AHEAD_CUSTOM",
        ),
        high=10000,
        aliases=(
            Alias("configuration.channel[0..11].interpolator.number_blocks_lah", silent=True),
            Alias("configuration.channel[0..11].interpolator.param", silent=True),
        ),
        restart=True,
    ),
    Parameter(
        "P-STUP-00169",
        "error_text_user_of_id",
        ValueType.STRING,
        "",
        Text("File with the texts of user errors", "Datei mit den Texten der Anwenderfehler"),
        high=_PATH_LENGTH,
        restart=True,
    ),
)


STARTUP = Schema(
    "startup",
    Text("Start-up list", "Hochlaufliste"),
    ListDialect(),
    _LISTS + _CONTROLLER,
    ParameterTable("startup.tsv"),
)


def startup_configuration(values: Values, collector: Collector) -> StartupConfiguration:
    """Return the values of the start-up list; an invalid alignment becomes 0."""
    alignment = values.integer("ext_var_struct_member_alignment")
    if alignment not in ALIGNMENTS:
        key = "ext_var_struct_member_alignment"
        values.report(collector, INVALID_ALIGNMENT, (key,), value=alignment)
        alignment = 0
    return StartupConfiguration(
        _reference(values, "default_sda_mds"),
        tuple(
            _channel(values, index, collector) for index in range(values.integer("kanal_anzahl"))
        ),
        _reference(values, "default_achs_mds"),
        tuple(_reference(values, "achs_mds[]", index) for index in range(_axis_count(values))),
        _reference(values, "rtconf_lis"),
        _others(values),
        values.integer("ext_var_max") * 24,
        alignment,
        values.text("error_text_user_of_id"),
    )


def _others(values: Values) -> tuple[tuple[str, ListReference], ...]:
    """Return the lists without effect, each with its kind."""
    others: list[tuple[str, ListReference]] = []
    for pattern, indices in values.entry_values:
        kind = _OTHER_KINDS.get(pattern)
        reference = None if kind is None else _reference(values, pattern, *indices)
        if kind is not None and reference is not None:
            others.append((kind, reference))
    return tuple(others)


def _axis_count(values: Values) -> int:
    """Return the number of axes in the list, else that of the named ones."""
    if values.is_set("zahl_mds"):
        return values.integer("zahl_mds")
    return max(values.indices("achs_mds[]"), default=-1) + 1


def _reference(values: Values, pattern: str, *indices: int) -> ListReference | None:
    path = values.text(pattern, *indices)
    if not path:
        return None
    return ListReference(path, *values.position(pattern, *indices))


def _channel(values: Values, index: int, collector: Collector) -> ChannelStartup:
    return ChannelStartup(
        index,
        _reference(values, "sda_mds[]", index),
        _reference(values, "ve_var[]", index),
        _reference(values, "werkz_data[]", index),
        _reference(values, "nullp_data[]", index),
        _reference(values, "pzv_data[]", index),
        _backward_memory(values, index, collector),
        _look_ahead(values, index),
    )


def _backward_memory(values: Values, index: int, collector: Collector) -> int:
    """Return the size of the path's history in bytes: 0, or at least ``MIN_BACKWARD_MEMORY``."""
    size = values.integer("fb_storage_size[]", index)
    if 0 < size < MIN_BACKWARD_MEMORY:
        values.report(
            collector,
            BACKWARD_MEMORY_TOO_SMALL,
            ("fb_storage_size[]", index),
            value=size,
            minimum=MIN_BACKWARD_MEMORY,
        )
        return MIN_BACKWARD_MEMORY
    return size


def _look_ahead(values: Values, index: int) -> int:
    """Return the blocks of look-ahead: those of CUSTOM, else of the flag, else the standard."""
    prefix = "configuration.channel[].interpolator"
    flags = values.names(f"{prefix}.function", index)
    if _CUSTOM_LOOK_AHEAD in flags:
        return values.integer(f"{prefix}.parameter", index)
    chosen = [blocks for name, blocks in _LOOK_AHEAD.items() if name in flags]
    return max(chosen, default=_LOOK_AHEAD["FCT_LOOK_AHEAD_STANDARD"])
