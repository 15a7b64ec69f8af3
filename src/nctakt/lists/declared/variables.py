# SPDX-License-Identifier: MIT
"""Variables lists (P-EXTV): declarations of V.E and V.CH variables and of their structures.

Their values become variables in ``variables.py``. Truth values may be written TRUE and FALSE here.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import MAX_UNS16, Alias, Parameter, ValueType
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.table import ParameterTable
from nctakt.messages.variables import INVALID_SCOPE

#: Maximum length of V.E.name in characters; the controller may accept longer ones.
NAME_LENGTH = 26
#: Maximum length of a name, in characters.
MAX_NAME_LENGTH = 256
#: Inherited access rights.
INHERIT_ACCESS = "INHERIT_ACCESS"
#: Names beside truth values; the last one means an inherited value.
_SYNCHRONISATIONS: dict[str, int | None] = {"SYN": 1, "ASYN": 0, "VE_INHERIT_SYNCH": None}
_LAST_VARIABLE = MAX_UNS16 - 1
_LAST_STRUCTURE = 255
_LAST_ELEMENT = 255
_TYPE_LENGTH = 64


@dataclass(frozen=True, slots=True)
class ScalarType:
    """A basic type: its size in bytes (0: in the list) and, for numbers, its range."""

    name: str
    size_bytes: int
    low: float = 0.0
    high: float = 0.0

    @property
    def is_numeric(self) -> bool:
        """Whether a realtime cycle can use it; it cannot use character strings."""
        return self.name not in {"STRING", "VSTRING"}

    @property
    def is_integer(self) -> bool:
        """Whether assignments round."""
        return self.is_numeric and self.name != "REAL64"


_LARGEST_REAL = 1.7976931348623157e308

#: All basic types by name.
SCALARS: dict[str, ScalarType] = {
    scalar.name: scalar
    for scalar in (
        ScalarType("BOOLEAN", 1, 0, 1),
        ScalarType("SGN08", 1, -128, 127),
        ScalarType("UNS08", 1, 0, 255),
        ScalarType("SGN16", 2, -32_768, 32_767),
        ScalarType("UNS16", 2, 0, 65_535),
        ScalarType("SGN32", 4, -2_147_483_648, 2_147_483_647),
        ScalarType("UNS32", 4, 0, 4_294_967_295),
        ScalarType("REAL64", 8, -_LARGEST_REAL, _LARGEST_REAL),
        ScalarType("STRING", 0),
        ScalarType("VSTRING", 0),
    )
}

_GENERAL = (
    Parameter(
        "P-EXTV-00010",
        "number_used_variables",
        ValueType.UNS16,
        0,
        Text(
            "Highest index of V.E variables plus 1; variables beyond it do not exist",
            "Höchster Index der V.E-Variablen plus 1; Variablen darüber gibt es nicht",
        ),
        aliases=(Alias("anzahl_belegt", silent=True),),
        restart=True,
    ),
    Parameter(
        "P-EXTV-00022",
        "use_extended_string_var",
        ValueType.BOOLEAN,
        False,
        Text(
            "STRING variables have 127 characters instead of 20",
            "STRING-Variablen haben 127 statt 20 Zeichen",
        ),
        restart=True,
    ),
    Parameter(
        "P-EXTV-00011",
        "check_overlapping_variables",
        ValueType.BOOLEAN,
        False,
        Text(
            "Tell variables whose places overlap in the memory that the PLC sees",
            "Variablen melden, deren Orte sich im Speicher der SPS überlappen",
        ),
        restart=True,
    ),
)


def _name(
    id_: str, path: str, en: str = "Name of a variable", de: str = "Name einer Variablen"
) -> Parameter:
    return Parameter(id_, path, ValueType.STRING, "", Text(en, de))


def _type(id_: str, path: str) -> Parameter:
    text = Text("Type: a basic one or a structure of the list", "Typ: Basistyp oder Struktur")
    return Parameter(id_, path, ValueType.STRING, "UNS32", text, high=_TYPE_LENGTH)


def _synchronisation(id_: str, path: str) -> Parameter:
    text = Text(
        "Accessed in the realtime part, not when a block is decoded",
        "Zugriff im Echtzeit-Teil, nicht beim Dekodieren eines Satzes",
    )
    return Parameter(id_, path, ValueType.BOOLEAN, True, text, names=_SYNCHRONISATIONS)


def _rights(id_: str, path: str) -> Parameter:
    return Parameter(
        id_,
        path,
        ValueType.NAME,
        "READ_WRITE",
        Text("What NC programs may do", "Was NC-Programme dürfen"),
        names={"READ_WRITE": None, "READ_ONLY": None, "WRITE_ONLY": None, INHERIT_ACCESS: None},
    )


def _array(id_: str, path: str, alias_id: str = "") -> Parameter:
    return Parameter(
        id_,
        f"{path}.array_elements",
        ValueType.UNS16,
        0,
        Text("Elements of an array; 0: no array", "Elemente eines Felds; 0: kein Feld"),
        aliases=(Alias(f"{path}.array_size", silent=True, id=alias_id),),
    )


def _size(id_: str, path: str) -> Parameter:
    return Parameter(
        id_,
        path,
        ValueType.UNS16,
        0,
        Text("Size of a VSTRING; 0: 128", "Größe eines VSTRING; 0: 128"),
        high=800,
        unit="byte",
    )


_VAR = f"var[0..{_LAST_VARIABLE}]"
_VCH = f"vch[0..{_LAST_VARIABLE}]"
_STRUCT = f"struct[0..{_LAST_STRUCTURE}]"
_ELEMENT = f"{_STRUCT}.element[0..{_LAST_ELEMENT}]"

_EXTERNAL = (
    _name("P-EXTV-00001", f"{_VAR}.name"),
    Parameter(
        "P-EXTV-00002",
        f"{_VAR}.byte_offset",
        ValueType.SGN32,
        -1,
        Text(
            "Place in the memory that the PLC sees; -1: behind the variable before",
            "Ort im Speicher, den die SPS sieht; -1: hinter der Variablen davor",
        ),
        low=-1,
        unit="byte",
    ),
    _type("P-EXTV-00003", f"{_VAR}.type"),
    Parameter(
        "P-EXTV-00004",
        f"{_VAR}.scope",
        ValueType.NAME,
        "CHANNEL",
        Text("One for all channels, or one for each", "Eine für alle Kanäle oder eine für jeden"),
        names={"CHANNEL": None, "GLOBAL": None},
        invalid="CHANNEL",
        invalid_message=INVALID_SCOPE,
    ),
    _synchronisation("P-EXTV-00005", f"{_VAR}.synchronisation"),
    _rights("P-EXTV-00006", f"{_VAR}.access_rights"),
    _array("P-EXTV-00007", _VAR, "P-EXTV-00046"),
    _size("P-EXTV-00008", f"{_VAR}.size"),
)

_CHANNEL = (
    _name("", f"{_VCH}.name"),
    _type("", f"{_VCH}.type"),
    _synchronisation("", f"{_VCH}.synchronisation"),
    _array("", _VCH),
    _size("", f"{_VCH}.size"),
)

_STRUCTURES = (
    _name(
        "P-EXTV-00015",
        f"{_STRUCT}.name",
        "Name of a structure, the type of variables",
        "Name einer Struktur, des Typs von Variablen",
    ),
    _name(
        "P-EXTV-00016",
        f"{_ELEMENT}.name",
        "Name of an element of a structure",
        "Name eines Elements einer Struktur",
    ),
    _type("P-EXTV-00017", f"{_ELEMENT}.type"),
    _synchronisation("P-EXTV-00018", f"{_ELEMENT}.synchronisation"),
    _rights("P-EXTV-00019", f"{_ELEMENT}.access_rights"),
    _array("P-EXTV-00020", _ELEMENT),
    _size("P-EXTV-00021", f"{_ELEMENT}.size"),
)

VARIABLES = Schema(
    "variables",
    Text("Variables list", "Variablenliste"),
    ListDialect(),
    _GENERAL + _EXTERNAL + _CHANNEL + _STRUCTURES,
    ParameterTable("variables.tsv"),
)
