# SPDX-License-Identifier: MIT
"""Tool lists (P-TOOL): declarations, and the values of a list -> the tools of a channel.

In: checked values. Out: ``Tool`` records by number, lengths in mm for any unit of the list. The
index of a tool is its number in D. Tool 0 has no dimensions: D0 deselects all of them.
"""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.machines.folders import TOOL_ZERO_WITHOUT_DIMENSIONS, UNKNOWN_AXIS_INDEX

MAX_AXES = 32
MAX_PARAMETERS = 60
MAX_KINEMATIC_PARAMETERS = 75
#: Lengths of the lists (0.1 µm, 0.0001 inch) per mm or inch.
_LENGTH_UNITS = 10_000
_MM_PER_INCH = 25.4


@dataclass(frozen=True, slots=True)
class Tool:
    """One tool; lengths in mm.

    ``valid``: programs may use it (P-TOOL-00005). ``axis_offsets``: index of an axis in the channel
    -> offset in mm, for rotary axes in degrees; only those that the list gives. ``parameters``:
    free values (P-TOOL-00007). ``spindle_number``: the logical number of the spindle that
    holds the tool; 0: none. ``kinematic_id``: the kinematic that its selection preselects (P-TOOL-
    00011); 0: none. ``kinematic_parameters``: index -> addition to a parameter of the kinematic of
    the first step, in 0.1 µm or 1e-4° (P-TOOL-00009). ``type``: P-TOOL-00001;
    ``is_inch``: lengths of the list are inches. ``identity``: basic, sister and variant number by
    which programs select it; 0 for one that is not valid. ``speeds``: lowest and highest speed of
    its spindle in 1e-3 degrees per second, ``acceleration`` in degrees per second²; 0: that
    of the spindle.
    """

    number: int
    valid: bool
    cutter_position: int
    length: float
    radius: float
    axis_offsets: Mapping[int, float]
    parameters: Mapping[int, float]
    spindle_number: int
    kinematic_id: int
    kinematic_parameters: Mapping[int, float]
    type: int = 0
    is_inch: bool = False
    identity: tuple[int, int, int] = (0, 0, 0)
    sister_is_valid: bool = False
    variant_is_valid: bool = False
    speeds: tuple[float, float] = (0.0, 0.0)
    acceleration: float = 0.0


#: The tool of D0: no dimensions.
NO_TOOL = Tool(0, False, 0, 0.0, 0.0, {}, {}, 0, 0, {})


def tools_configuration(
    values: Values, linear: tuple[bool, ...], collector: Collector
) -> dict[int, Tool]:
    """Return the tools of a channel by number; ``linear``: for each axis whether it is linear.

    Reported: dimensions of tool 0 (900740), an offset of an unknown axis (900741).
    """
    tools: dict[int, Tool] = {}
    for number in values.indices("wz[]"):
        if number == 0 and not values.flag("tool_data_with_id"):
            if _has_dimensions(values):
                values.report(collector, TOOL_ZERO_WITHOUT_DIMENSIONS, _first_key(values, 0))
            continue
        tools[number] = _tool_of(values, number, linear, collector)
    return tools


def _has_dimensions(values: Values) -> bool:
    numbers = (values.integer(f"wz[].{name}", 0) for name in ("laenge", "radius"))
    offsets = (values.integer("wz[].ax_versatz[]", 0, i) for i in _offset_indices(values, 0))
    return any(numbers) or any(offsets)


def _offset_indices(values: Values, number: int) -> tuple[int, ...]:
    return values.indices("wz[].ax_versatz[]", number)


def _first_key(values: Values, number: int) -> tuple[str, *tuple[int, ...]]:
    """Return the first entry of a tool in the list."""
    of_tool = [
        key for key in values.entry_values if key[0].startswith("wz[]") and key[1][0] == number
    ]
    pattern, indices = min(of_tool, key=lambda key: values.entry_values[key].entry.key_span.line)
    return pattern, *indices


def _tool_of(values: Values, number: int, linear: tuple[bool, ...], collector: Collector) -> Tool:
    scale = _MM_PER_INCH if values.integer("wz[].mass_einheit", number) == 1 else 1.0

    def length(pattern: str, *indices: int) -> float:
        return values.integer(pattern, number, *indices) / _LENGTH_UNITS

    offsets: dict[int, float] = {}
    for index in _offset_indices(values, number):
        if index >= len(linear):
            key = ("wz[].ax_versatz[]", number, index)
            values.report(collector, UNKNOWN_AXIS_INDEX, key, index=index, count=len(linear))
            continue
        offset = length("wz[].ax_versatz[]", index)
        offsets[index] = offset * scale if linear[index] else offset
    parameters = values.indices("wz[].param[]", number)
    return Tool(
        number,
        values.flag("wz[].gueltig", number),
        values.integer("wz[].srk_lage", number),
        length("wz[].laenge") * scale,
        length("wz[].radius") * scale,
        offsets,
        {index: values.real("wz[].param[]", number, index) for index in parameters},
        values.integer("wz[].log_ax_nr_spdl", number),
        values.integer("wz[].kin_id", number),
        {
            index: values.integer("wz[].kinematic.param[]", number, index)
            for index in values.indices("wz[].kinematic.param[]", number)
        },
        values.integer("wz[].typ", number),
        scale != 1.0,
        _identity(values, number),
        values.flag("wz[].tool_id.sister_valid", number),
        values.flag("wz[].tool_id.variant_valid", number),
        (values.real("wz[].vb_min", number), values.real("wz[].vb_max", number)),
        values.real("wz[].a_max", number),
    )


def _identity(values: Values, number: int) -> tuple[int, int, int]:
    """Return the ID by which programs select a tool: its index, or that of the list."""
    basic, sister, variant = (
        values.integer(f"wz[].tool_id.{part}", number) for part in ("basic", "sister", "variant")
    )
    if not values.flag("tool_data_with_id"):
        return (number, 0, 0)
    has_sister = values.flag("wz[].tool_id.sister_valid", number)
    has_variant = values.flag("wz[].tool_id.variant_valid", number)
    return (basic, sister if has_sister else 0, variant if has_variant else 0)
