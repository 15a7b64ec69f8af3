# SPDX-License-Identifier: MIT
"""Tool lists (P-TOOL): declarations, and the values of a list -> the tools of a channel.

In: checked values. Out: ``Tool`` records by number, lengths in mm for any unit of the list. The
index of a tool is its number in D. Tool 0 has no dimensions: D0 deselects all of them.
"""

from __future__ import annotations

from collections.abc import Mapping

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter, Value, ValueType
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.table import ParameterTable
from nctakt.lists.format.values import Values
from nctakt.messages import Collector
from nctakt.messages.folders import TOOL_ZERO_WITHOUT_DIMENSIONS, UNKNOWN_AXIS_INDEX

MAX_TOOLS = 201
MAX_AXES = 32
MAX_PARAMETERS = 60
MAX_KINEMATIC_PARAMETERS = 75
#: Lengths of the lists (0.1 µm, 0.0001 inch) per mm or inch.
_LENGTH_UNITS = 10_000
_MM_PER_INCH = 25.4
_LENGTH = "0.1 µm, 0.0001 inch"
_SPEED = "1e-3°/s"


@dataclass(frozen=True, slots=True)
class Tool:
    """One tool; lengths in mm.

    ``valid``: programs may use it (P-TOOL-00005). ``axis_offsets``: index of an axis in the channel
    -> offset in mm, for rotary axes in degrees; only those that the list gives. ``parameters``:
    free values (P-TOOL-00007). ``spindle_number``: the logical number of the spindle that
    holds the tool; 0: none. ``kinematic_id``: the kinematic that its selection preselects (P-TOOL-
    00011); 0: none. ``kinematic_parameters``: index -> what is added to a parameter of the
    kinematic of the first step, in 0.1 µm or 1e-4° (P-TOOL-00009). ``type``: P-TOOL-00001;
    ``is_inch``: lengths of the list are inches. ``identity``: basic, sister and variant number by
    which programs select it; 0 for one that is not valid. ``speeds``: the least and the highest
    one of its spindle in 1e-3 degrees per second, ``acceleration`` in degrees per second²; 0: that
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


def _tool(
    id_: str,
    path: str,
    type_: ValueType,
    default: Value,
    en: str,
    de: str,
    *,
    low: int | None = None,
    high: int | None = None,
    unit: str = "",
    also: tuple[float, ...] = (),
) -> Parameter:
    path = f"wz[0..{MAX_TOOLS - 1}].{path}"
    text = Text(en, de)
    return Parameter(id_, path, type_, default, text, low=low, high=high, unit=unit, also=also)


_DIMENSIONS = (
    _tool(
        "P-TOOL-00001",
        "typ",
        ValueType.UNS16,
        0,
        "Kind of tool: 0 milling, 1 turning, 2 grinding",
        "Art des Werkzeugs: 0 Fräsen, 1 Drehen, 2 Schleifen",
        high=3,
    ),
    _tool(
        "P-TOOL-00005",
        "gueltig",
        ValueType.BOOLEAN,
        False,
        "Programs may use the tool",
        "Programme dürfen das Werkzeug verwenden",
    ),
    _tool(
        "P-TOOL-00002",
        "srk_lage",
        ValueType.UNS16,
        0,
        "Position of the cutting edge of a turning tool",
        "Lage der Schneide eines Drehwerkzeugs",
        high=9,
    ),
    _tool(
        "P-TOOL-00008",
        "mass_einheit",
        ValueType.UNS16,
        0,
        "Unit of length, radius and offsets: 0 mm, 1 inch",
        "Einheit von Länge, Radius und Versätzen: 0 mm, 1 Inch",
        high=1,
    ),
    _tool(
        "P-TOOL-00003",
        "laenge",
        ValueType.SGN32,
        0,
        "Length of the tool",
        "Länge des Werkzeugs",
        unit=_LENGTH,
    ),
    _tool(
        "P-TOOL-00004",
        "radius",
        ValueType.SGN32,
        0,
        "Radius of the tool",
        "Radius des Werkzeugs",
        unit=_LENGTH,
    ),
    _tool(
        "P-TOOL-00006",
        f"ax_versatz[0..{MAX_AXES - 1}]",
        ValueType.SGN32,
        0,
        "Offset of the tool in an axis of the channel",
        "Versatz des Werkzeugs in einer Achse des Kanals",
        unit=f"{_LENGTH}, 1e-4°",
    ),
    _tool(
        "P-TOOL-00007",
        f"param[0..{MAX_PARAMETERS - 1}]",
        ValueType.REAL64,
        0.0,
        "Value for the user's own purposes",
        "Wert für eigene Zwecke des Anwenders",
    ),
)

_IDENTITY = (
    Parameter(
        "P-TOOL-00140",
        "tool_data_with_id",
        ValueType.BOOLEAN,
        False,
        Text(
            "Programs select tools by their IDs, not by their index in the list",
            "Programme wählen Werkzeuge nach ihrer ID statt nach dem Index der Liste",
        ),
    ),
    _tool(
        "P-TOOL-00141",
        "tool_id.basic",
        ValueType.SGN32,
        0,
        "Basic number of the ID",
        "Grundnummer der ID",
    ),
    _tool(
        "P-TOOL-00142",
        "tool_id.sister",
        ValueType.SGN32,
        0,
        "Number of the sister tool",
        "Nummer des Schwesterwerkzeugs",
    ),
    _tool(
        "P-TOOL-00143",
        "tool_id.variant",
        ValueType.SGN32,
        0,
        "Number of the variant",
        "Nummer der Variante",
    ),
    _tool(
        "P-TOOL-00144",
        "tool_id.sister_valid",
        ValueType.BOOLEAN,
        False,
        "The number of the sister tool is valid",
        "Die Nummer des Schwesterwerkzeugs ist gültig",
    ),
    _tool(
        "P-TOOL-00145",
        "tool_id.variant_valid",
        ValueType.BOOLEAN,
        False,
        "The number of the variant is valid",
        "Die Nummer der Variante ist gültig",
    ),
)

_SPINDLE = (
    _tool(
        "P-TOOL-00012",
        "log_ax_nr_spdl",
        ValueType.UNS16,
        0,
        "Logical number of the spindle that holds the tool; 0: none",
        "Logische Nummer der Spindel, die das Werkzeug hält; 0: keine",
    ),
    _tool(
        "P-TOOL-00013",
        "vb_min",
        ValueType.REAL64,
        0.0,
        "Least speed of the spindle with the tool, in endless rotation",
        "Kleinste Drehzahl der Spindel mit dem Werkzeug, beim Endlosdrehen",
        low=0,
        unit=_SPEED,
    ),
    _tool(
        "P-TOOL-00014",
        "vb_max",
        ValueType.REAL64,
        0.0,
        "Highest speed of the spindle with the tool; 0: that of the spindle",
        "Höchste Drehzahl der Spindel mit dem Werkzeug; 0: die der Spindel",
        low=1,
        high=2_000_000_000,
        unit=_SPEED,
        also=(0.0,),
    ),
    _tool(
        "P-TOOL-00015",
        "a_max",
        ValueType.REAL64,
        0.0,
        "Highest acceleration of the spindle with the tool; 0: that of the spindle",
        "Höchste Beschleunigung der Spindel mit dem Werkzeug; 0: die der Spindel",
        low=1,
        high=100_000_000,
        unit="°/s²",
        also=(0.0,),
    ),
)

_KINEMATIC = (
    _tool(
        "P-TOOL-00009",
        f"kinematic.param[0..{MAX_KINEMATIC_PARAMETERS - 1}]",
        ValueType.SGN32,
        0,
        "Added to a parameter of the kinematic while the tool is active",
        "Kommt zu einem Parameter der Kinematik hinzu, solange das Werkzeug aktiv ist",
        unit=f"{_LENGTH}, 1e-4°",
    ),
    _tool(
        "P-TOOL-00011",
        "kin_id",
        ValueType.UNS16,
        0,
        "Kinematic that the tool preselects; 0: none",
        "Kinematik, die das Werkzeug vorwählt; 0: keine",
    ),
)

TOOLS = Schema(
    "tools",
    Text("Tool list", "Werkzeugliste"),
    ListDialect(),
    _DIMENSIONS + _IDENTITY + _SPINDLE + _KINEMATIC,
    ParameterTable("tools.tsv"),
)


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
