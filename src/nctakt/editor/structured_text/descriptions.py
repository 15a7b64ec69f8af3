# SPDX-License-Identifier: MIT
"""Descriptions of names: declaration, value, comments.

In: targets of names. Out: Structured Text of one declaration, and comments: those at the end of a
declaration's line, else those in the lines before it.
"""

from __future__ import annotations

import re

from nctakt.base.diagnostics import Language, Text
from nctakt.st.sources import Sources
from nctakt.st.tree import GlobalList, Library, Target
from nctakt.st.types import (
    Callable,
    Elementary,
    EnumType,
    EnumValue,
    InterfaceType,
    Method,
    Pou,
    Property,
    Section,
    StructType,
    Type,
    Value,
    Variable,
)

#: Members of a structure or values of an enumeration that are shown at most.
MAX_MEMBERS = 24

_VALUE = Text("value", "Wert")
_OF = Text("of", "von")
_BYTES = Text("bytes", "Bytes")

_TRAILING = re.compile(r"(?://+[ \t]?(?P<line>[^\n]*)|\(\*(?P<block>.*?)\*\))[ \t]*$", re.DOTALL)
_PRAGMA = re.compile(r"\{[^}]*\}")
_COMMENT_LINES = re.compile(
    r"(?:^[ \t]*(?://[^\n]*|\(\*(?:(?!\*\)).)*\*\)|/\*(?:(?!\*/).)*\*/|\{[^}\n]*\})[ \t]*\n)+\Z",
    re.DOTALL | re.MULTILINE,
)
_MARKS = re.compile(r"^[ \t]*(?://+|\(\*+|/\*+|\*+(?![)/]))?[ \t]?|[ \t]*(?:\*+\)|\*+/)?[ \t]*$")


def declaration_of(target: Target) -> str:
    """Return the declaration of a name's target, as Structured Text."""
    match target:
        case Variable():
            return _variable(target)
        case Property():
            return f"PROPERTY {target.name} : {target.type.name}"
        case EnumValue():
            return f"{target.type.name}.{target.name} := {target.number}"
        case Pou():
            return _pou(target)
        case Callable():
            return _callable("METHOD", target)
        case GlobalList():
            return f"VAR_GLOBAL // {target.name}"
        case Library():
            return f"// library {target.name}"
    return _type(target)


def _variable(target: Variable) -> str:
    section = "" if target.section is Section.MEMBER else f"{target.section.value} "
    if target.section is Section.RESULT:
        section = ""
    words = [
        word
        for word, holds in (
            ("CONSTANT", target.is_constant),
            ("RETAIN", target.is_retain),
            ("PERSISTENT", target.is_persistent),
        )
        if holds
    ]
    address = f" AT {target.address}" if target.address else ""
    return f"{section}{' '.join([*words, target.name])}{address} : {target.type.name};"


def parameter_text(one: Variable) -> str:
    """Return a parameter as a signature shows it."""
    mark = {Section.OUTPUT: "=>", Section.IN_OUT: "IN_OUT "}.get(one.section, "")
    if one.section is Section.OUTPUT:
        return f"{one.name} {mark} {one.type.name}"
    return f"{mark}{one.name} : {one.type.name}"


def signature_of(target: Callable, name: str = "") -> str:
    """Return name, parameters and result of a callable, in one line."""
    listed = ", ".join(parameter_text(one) for one in target.parameters)
    result = "" if target.result is None else f" : {target.result.type.name}"
    return f"{name or target.name}({listed}){result}"


def _callable(keyword: str, target: Callable) -> str:
    if isinstance(target, Method) and target.is_action:
        return f"ACTION {target.name}"
    access = ""
    if isinstance(target, Method) and target.access.value != "PUBLIC":
        access = f"{target.access.value} "
    return f"{keyword} {access}{signature_of(target)}"


def _pou(target: Pou) -> str:
    base = "" if target.base is None else f" EXTENDS {target.base.name}"
    names = ", ".join(one.name for one in target.interfaces)
    implements = f" IMPLEMENTS {names}" if names else ""
    if not target.parameters:
        result = "" if target.result is None else f" : {target.result.type.name}"
        return f"{target.kind.value} {target.name}{result}{base}{implements}"
    return f"{target.kind.value} {signature_of(target)}{base}{implements}"


def _type(target: Type) -> str:
    if isinstance(target, EnumType):
        values = list(target.values.values())
        shown = ", ".join(f"{one.name} := {one.number}" for one in values[:MAX_MEMBERS])
        more = ", …" if len(values) > MAX_MEMBERS else ""
        return f"TYPE {target.name} : ({shown}{more}) {target.base.name};"
    if isinstance(target, StructType):
        members = list(target.members.values())
        lines = [f"    {_variable(one)}" for one in members[:MAX_MEMBERS]]
        if len(members) > MAX_MEMBERS:
            lines.append("    …")
        keyword = "UNION" if target.is_union else "STRUCT"
        return "\n".join((f"TYPE {target.name} : {keyword}", *lines, f"END_{keyword}"))
    if isinstance(target, InterfaceType):
        methods = [f"    {_callable('METHOD', one)}" for one in target.methods.values()]
        return "\n".join((f"INTERFACE {target.name}", *methods[:MAX_MEMBERS]))
    return f"TYPE {target.name}"


def facts_of(target: Target, language: Language) -> list[str]:
    """Return facts besides the declaration: owner, value of a constant, sizes."""
    facts = []
    owner = getattr(target, "owner", None)
    owner_name = owner if isinstance(owner, str) else getattr(owner, "name", "")
    if owner_name:
        facts.append(f"{_OF.get(language)} `{owner_name}`")
    if isinstance(target, Variable):
        if target.value is not None:
            facts.append(f"{_VALUE.get(language)} `{value_text(target.value, target.type)}`")
    kind_ = target if isinstance(target, Elementary | StructType | EnumType) else None
    if kind_ is not None and kind_.size:
        facts.append(f"{kind_.size} {_BYTES.get(language)}")
    return facts


def value_text(value: Value, kind: Type) -> str:
    """Return a constant as written."""
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    if isinstance(value, bytes):
        wide = getattr(kind, "is_wide", False)
        text = value.decode("utf-16-le" if wide else "latin-1", "replace")
        return f'"{text}"' if wide else f"'{text}'"
    if isinstance(kind, EnumType):
        for one in kind.values.values():
            if one.number == value:
                return f"{kind.name}.{one.name} ({value})"
    if isinstance(kind, Elementary) and kind.name in ("TIME", "LTIME"):
        unit = "MS" if kind.name == "TIME" else "NS"
        return f"{'L' if unit == 'NS' else ''}T#{value}{unit}"
    return str(value)


def comment_of(sources: Sources, start: int) -> str:
    """Return the comments about the declaration at a position."""
    piece = sources.piece_of(start) if start else None
    if piece is None:
        return ""
    offset = start - piece.base
    end = piece.text.find("\n", offset)
    line = piece.text[offset : len(piece.text) if end < 0 else end]
    match = _TRAILING.search(line)
    if match is not None:
        return (match["line"] or match["block"] or "").strip()
    begin = piece.text.rfind("\n", 0, offset) + 1
    before = _COMMENT_LINES.search(piece.text, max(0, begin - 4000), begin)
    if before is None:
        return ""
    text = _PRAGMA.sub("", before[0])
    lines = [_MARKS.sub("", one).strip() for one in text.splitlines()]
    return "\n".join(lines).strip()
