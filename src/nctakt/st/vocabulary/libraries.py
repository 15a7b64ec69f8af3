# SPDX-License-Identifier: MIT
"""The libraries that nctakt knows, as Structured Text.

A POU with the attribute ``native`` has no body: the runtime computes it. All others run as written.
The declarations of the interface between CNC and PLC are generated from its table (``hli.table``).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from nctakt.hli import table

_FOLDER = Path(__file__).parent.parent / "libraries"

#: The library of the system itself, whose names need no reference.
SYSTEM = "System"
#: The CNC's interface, and its blocks for single axes.
CNC_INTERFACE, CNC_AXES, NC_AXES = "Tc2_CncHli", "McpPLCopenP1", "Tc2_MC2"
TEST_LIBRARY = "TcUnit"
#: The block of ``NC_AXES`` that represents an axis, and its method that runs before each cycle.
AXIS_REFERENCE, WRITTEN_BY_NC = "AXIS_REF", "__fromnc"
#: Members filled by the NC on the machine that are filled here, too (ST-742).
FILLED = {
    AXIS_REFERENCE: frozenset(("plctonc", "nctoplc", "status")),
    "NCTOPLC_AXIS_REF": frozenset(
        "statedword errorcode axisid actpos actvelo posdiff setpos setvelo setacc targetpos "
        "actacc axisstate opmodedword moduloactpos modulosetpos".split()
    ),
    "ST_AxisStatus": frozenset(
        "cyclecounter motionstate error errorid errorstop disabled stopping standstill "
        "discretemotion continuousmotion synchronizedmotion homing constantvelocity accelerating "
        "decelerating operational controlloopclosed hasjob homed homingbusy moving "
        "positivedirection negativedirection notmoving opmode".split()
    ),
    "ST_AxisOpModes": frozenset("modulo softlimitminmonitoring softlimitmaxmonitoring".split()),
}
#: The library of shared types; the only one here belongs to the system.
BASE_TYPES = "IBaseLibrary"

#: The libraries with their own text, in the order in which names are looked up.
_TEXTS = ("Tc2_Standard", "Tc2_System", "Tc2_Utilities", "Tc2_Math", NC_AXES, TEST_LIBRARY, SYSTEM)
#: Names that the texts of libraries use, whether a project refers to them or not.
BENEATH = _TEXTS[:4]
#: Further names under which projects refer to them; those without a text here have no names.
ALIASES = {
    "tc2_cnc": CNC_INTERFACE,
    "tc2_cnchli": CNC_INTERFACE,
    "mcpplcopenp1": CNC_AXES,
    "tc2_mcpplcopenp1": CNC_AXES,
    "standard": "Tc2_Standard",
    "base interfaces": BASE_TYPES,
    "tc3_module": SYSTEM,
    "tc3_interfaces": SYSTEM,
}
#: Members whose names are keywords here (ST-763).
_MEMBERS = {"type": "fkt_ctrl_r"}
_DECLARED = re.compile(r"\b(?:FUNCTION_BLOCK|FUNCTION|TYPE|INTERFACE)\s+(\w+)")
#: Parts of a text with names visible to others: enumerations with their items, lists with their
#: variables, and names of other objects; not bodies or members of structures.
_SEEN = re.compile(
    r"VAR_GLOBAL.*?END_VAR|\bTYPE\s+\w+\s*:\s*\(.*?END_TYPE|'list'\s*:=\s*'\w+'|"
    + _DECLARED.pattern,
    re.DOTALL,
)
#: POUs that the runtime computes itself.
_NATIVE = "{attribute 'native'} "
#: The file of the bodies of blocks with pins of the interface's table.
_BODIES = "CncBlocks"
#: Text that a library has for each of several types: the types, the text.
_REPEATED = re.compile(r"^// for each T in ([\w ]+):\n(.*?)^// end\n", re.DOTALL | re.MULTILINE)
_BODY = re.compile(r"^BODY (\w+)\n(.*?)^END_BODY", re.DOTALL | re.MULTILINE)
_HIGHEST_CHANNEL, _HIGHEST_AXIS = 31, 127
#: Types that pins have and no source describes.
_OPAQUE = re.compile(r"\b(?:MC|MCV|HLI|AXES|TRIGGER)_[A-Z_]+\b")


def known(name: str) -> str:
    """Return the library that a reference names, by its name here; "" if it is unknown."""
    lower = name.partition(",")[0].strip().lower()
    by_name = {text.lower(): text for text in (*_TEXTS, BASE_TYPES, CNC_INTERFACE, CNC_AXES)}
    return ALIASES.get(lower) or by_name.get(lower, "")


def default_libraries() -> list[str]:
    """Return the libraries of a text without a project: all but the other one for axes."""
    texts = [name for name in _TEXTS if name != NC_AXES]
    return [*texts, CNC_INTERFACE, CNC_AXES]


@cache
def text_of(name: str) -> str:
    """Return the text of a known library."""
    if name == CNC_INTERFACE:
        return _interface()
    if name == CNC_AXES:
        return _blocks("MC_")
    if name == BASE_TYPES:
        return _type_classes()
    return _REPEATED.sub(_each, (_FOLDER / f"{name}.st").read_text("utf-8"))


def _type_classes() -> str:
    """Return the enumeration of types under the name that the library of base types gives it."""
    match = re.search(r"TYPE TYPE_CLASS (:.*?END_TYPE)", text_of(SYSTEM), re.DOTALL)
    assert match is not None
    return f"{{attribute 'to_string'}} TYPE TypeClass {match[1]}"


def _each(match: re.Match[str]) -> str:
    """Return text that occurs once in a file, for each of the types that it names."""
    return "".join(match[2].replace("{T}", name) for name in match[1].split())


@cache
def seen_words(name: str) -> frozenset[str]:
    """Return words of a library's text in lower case: all names that others see, and some more."""
    parts = " ".join(match[0] for match in _SEEN.finditer(text_of(name)))
    return frozenset(re.findall(r"\w+", parts.lower()))


@cache
def declared_names(name: str) -> tuple[str, ...]:
    """Return the names of the POUs and types of a library."""
    return tuple(_DECLARED.findall(text_of(name)))


@cache
def bodies() -> Mapping[str, str]:
    """Return variables and statements of the blocks whose pins the table of the interface has."""
    text = (_FOLDER / f"{_BODIES}.st").read_text("utf-8")
    return {name: body.strip() for name, body in _BODY.findall(text)}


def _interface() -> str:
    """Return the interface as Structured Text: its structures, pointers and constants."""
    parts = []
    for kind in table.structures():
        members = " ".join(
            f"{_MEMBERS.get(one.name, one.name)} : {one.type.name};" for one in kind.members
        )
        parts.append(f"TYPE {kind.name} : STRUCT {members} END_STRUCT END_TYPE")
    pointers = []
    for root, structure in table.ROOTS.items():
        target = structure or table.root(root).type.name
        high = _HIGHEST_AXIS if root == "gpAx" else _HIGHEST_CHANNEL
        array = "" if root in table.SINGLE_ROOTS else f"ARRAY[0..{high}] OF "
        pointers.append(f"{root} : {array}POINTER TO {target};")
    list_name = table.LIST_NAME.rstrip(".")
    parts.append(f"{{attribute 'list' := '{list_name}'}} VAR_GLOBAL {' '.join(pointers)} END_VAR")
    constants = [
        f"{one.name} : DINT := {one.value};"
        for one in table.constants().values()
        if one.value is not None
    ]
    parts.append(f"VAR_GLOBAL CONSTANT {' '.join(constants)} END_VAR")
    parts.append(_blocks("MCV_"))
    return "\n".join(parts)


def _blocks(prefix: str) -> str:
    """Return the function blocks whose names begin with ``prefix``."""
    parts = []
    declared = {kind.name for kind in table.structures()}
    for block in table.blocks().values():
        if not block.name.startswith(prefix):
            continue
        sections = []
        for keyword, pins in (
            ("VAR_IN_OUT", block.in_out),
            ("VAR_INPUT", block.inputs),
            ("VAR_OUTPUT", block.outputs),
        ):
            if pins:
                content = " ".join(f"{name} : {kind};" for name, kind in pins)
                sections.append(f"{keyword} {content} END_VAR")
        body = bodies().get(block.name)
        sections.append("" if body is None else body)
        parts.append(
            f"{'' if body is not None else _NATIVE}FUNCTION_BLOCK {block.name} "
            f"{' '.join(sections)} END_FUNCTION_BLOCK"
        )
    text = "\n".join(parts)
    blocks = set(table.blocks())
    opaque = dict.fromkeys(_OPAQUE.findall(text))
    if prefix == "MC_":
        opaque["AXIS_REF"] = None
    types = [
        f"TYPE {name} : STRUCT log_ax_nr : UINT; END_STRUCT END_TYPE"
        for name in opaque
        if name not in declared and name not in blocks
    ]
    return "\n".join((*types, text))
