# SPDX-License-Identifier: MIT
"""The start-up list (hochlauf.lis, startup.lis): the parts of the controller (P-STUP).

In: checked values. Out: ``StartupConfiguration``: the channels and axes, their lists, and the
values of the controller as a whole.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.machines.variables import INVALID_ALIGNMENT
from nctakt.messages.path.backward import BACKWARD_MEMORY_TOO_LARGE, BACKWARD_MEMORY_TOO_SMALL

MAX_AXES = 64
#: Alignments of a structure's members in bytes; 0: chosen by the controller.
ALIGNMENTS = (0, 1, 2, 4, 8)

_LOOK_AHEAD = {
    "FCT_LOOK_AHEAD_LOW": 30,
    "FCT_LOOK_AHEAD_STANDARD": 120,
    "FCT_LOOK_AHEAD_HIGH": 190,
}
_CUSTOM_LOOK_AHEAD = "FCT_LOOK_AHEAD_CUSTOM"

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

#: Maximum memory of backward motion of a channel in bytes: some 180,000 blocks of three axes.
MAX_BACKWARD_MEMORY = 64 << 20


@dataclass(frozen=True, slots=True)
class ListReference:
    """A list that another list names: its path as written and its position there."""

    path: str
    span: Span
    line: str


@dataclass(frozen=True, slots=True)
class ChannelStartup:
    """The entries of the start-up list for one channel; ``None`` without a list.

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
    """Return the size of the path's history in bytes: 0, or a size within the limits."""
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
    if size > MAX_BACKWARD_MEMORY:
        at = ("fb_storage_size[]", index)
        numbers = {"value": size, "maximum": MAX_BACKWARD_MEMORY}
        values.report(collector, BACKWARD_MEMORY_TOO_LARGE, at, **numbers)
        return MAX_BACKWARD_MEMORY
    return size


def _look_ahead(values: Values, index: int) -> int:
    """Return the blocks of look-ahead: those of CUSTOM, else of the flag, else the standard."""
    prefix = "configuration.channel[].interpolator"
    flags = values.names(f"{prefix}.function", index)
    if _CUSTOM_LOOK_AHEAD in flags:
        return values.integer(f"{prefix}.parameter", index)
    chosen = [blocks for name, blocks in _LOOK_AHEAD.items() if name in flags]
    return max(chosen, default=_LOOK_AHEAD["FCT_LOOK_AHEAD_STANDARD"])
