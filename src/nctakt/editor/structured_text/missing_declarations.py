# SPDX-License-Identifier: MIT
"""An undeclared name in Structured Text -> the declaration that its use asks for.

In: a file whose expressions have types, the position of the name. Out: where a line with its
declaration belongs, and the line. The type is that of the value assigned to it, of the target it is
assigned to, of its parameter, of the other operand; BOOL as a condition.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nctakt.base.dataclass import dataclass
from nctakt.editor.structured_text.occurrences import parts_of
from nctakt.editor.structured_text.plc_project import PlcFile
from nctakt.editor.structured_text.project_names import ProjectNames
from nctakt.st import tree
from nctakt.st.sources import Piece
from nctakt.st.tree import Header, PouNode, VariableBlock
from nctakt.st.types import (
    ArrayType,
    Expression,
    Node,
    PointerType,
    ReferenceType,
    Type,
)
from nctakt.st.vocabulary.elementary import UNTYPED, UNTYPED_REAL

#: Whole numbers that a declared INT, or DINT, can hold.
_INT, _DINT = range(-(1 << 15), 1 << 15), range(-(1 << 31), 1 << 31)

#: An edit of a piece: its offsets and the new text.
PieceEdit = tuple[Piece, int, int, str]


@dataclass(frozen=True, slots=True)
class _Unit:
    """A unit with a body, and the unit that declares the variables for it."""

    body: Header
    owner: Header


def declarations(
    names: ProjectNames, file: PlcFile, position: int
) -> Iterator[tuple[PieceEdit, str]]:
    """Yield the edit that declares a name, and its line, where its use shows its type."""
    names.of(file)  # lets the expressions of the file have their types
    for unit in _units(file.nodes):
        for node in _all(unit.body.body):
            found = _type_from(node, position)
            if found is None:
                continue
            name, kind = found
            written = f"{name} : {kind};"
            edit = _placed(names, file, unit.owner, written)
            if edit is not None:
                yield edit, written
            return


def _units(nodes: Iterable[tree.Declaration]) -> Iterator[_Unit]:
    for node in nodes:
        if not isinstance(node, PouNode):
            continue
        yield _Unit(node, node)
        for method in node.methods:
            yield _Unit(method, node if method.is_action else method)
        for one in node.properties:
            yield from (_Unit(part, part) for part in (one.get, one.set) if part is not None)


def _all(nodes: Iterable[Node]) -> Iterator[Node]:
    """Yield nodes with all that is in them."""
    for node in nodes:
        yield node
        yield from _all(parts_of(node))


# --- the type ------------------------------------------------------------------------------------


def _type_from(node: Node, position: int) -> tuple[str, str] | None:
    """Return the name at a position with its type, if its use in this node determines it."""

    def is_it(one: object) -> bool:
        return isinstance(one, tree.Name) and one.start == position and not one.is_global

    pairs: list[tuple[Expression, str]] = []
    match node:
        case tree.Assignment(operator=":="):
            pairs = [(node.target, _named(node.value)), (node.value, _named(node.target))]
        case tree.Branch() | tree.While() | tree.Repeat():
            pairs = [(node.condition, "BOOL")]
        case tree.Unary(operator=tree.Operator.NOT):
            pairs = [(node.operand, "BOOL")]
        case tree.Binary():
            pairs = [(node.left, _named(node.right)), (node.right, _named(node.left))]
        case tree.For():
            pairs = [(node.counter, _named(node.last, node.first))]
        case tree.Call():
            pairs = [(value, _name_of(parameter.type)) for parameter, value in node.bound]
    for expression, kind in pairs:
        if is_it(expression) and kind:
            assert isinstance(expression, tree.Name)
            return expression.name, kind
    return None


def _named(*nodes: Expression) -> str:
    """Return the declared type of expressions; for literals the smallest of INT, DINT …"""
    kind = nodes[0].type
    values = [one.value for one in nodes]
    if all(isinstance(one, tree.Literal | tree.Unary) for one in nodes):
        if all(isinstance(one, int) and not isinstance(one, bool) for one in values):
            is_plain = all(not _prefix(one) for one in nodes)
            if is_plain:
                small = all(one in _INT for one in values)
                return "INT" if small else "DINT" if all(one in _DINT for one in values) else "LINT"
    return "" if kind is None else _name_of(kind)


def _prefix(node: Expression) -> str:
    """Return the type that a literal names, such as ``UINT``."""
    if isinstance(node, tree.Unary):
        return _prefix(node.operand)
    return node.prefix if isinstance(node, tree.Literal) else ""


def _name_of(kind: Type) -> str:
    """Return a type as a declaration names it, empty where it has no name."""
    if isinstance(kind, ReferenceType):
        kind = kind.target
    if kind is UNTYPED:
        return "LINT"
    if kind is UNTYPED_REAL:
        return "LREAL"
    return "" if isinstance(kind, ArrayType | PointerType) else kind.name


# --- the place -----------------------------------------------------------------------------------


def _placed(names: ProjectNames, file: PlcFile, owner: Header, written: str) -> PieceEdit | None:
    """Return the edit that adds a declaration: to the last VAR block, else in a new block."""
    sources = names.project.sources
    piece = sources.piece_of(owner.start)
    if piece is None or piece not in file.pieces:
        return None
    text = piece.text
    plain = [one for one in owner.variables if one.keyword == "VAR" and not one.qualifiers]
    if plain:
        end = _end_of(plain[-1], piece)
        begin = text.rfind("\n", 0, end) + 1
        if end < 0 or text[begin:end].strip():
            return None
        indent = _indent(text, _last_start(plain[-1]) - piece.base)
        if not plain[-1].variables:
            indent += "    "
        return piece, begin, begin, f"{indent}{written}\n"
    return _with_block(piece, owner, written)


def _with_block(piece: Piece, owner: Header, written: str) -> PieceEdit:
    """Return the edit that adds a VAR block after the last block, else after the header."""
    text = piece.text
    if owner.variables:
        start = _end_of(owner.variables[-1], piece)
    else:
        parts = [owner.result] if owner.result is not None else []
        if isinstance(owner, PouNode):
            parts += [*([owner.base] if owner.base else []), *owner.interfaces]
        start = max([owner.end, *(one.end for one in parts)]) - piece.base
    end = text.find("\n", max(start, 0))
    indent = _indent(text, owner.start - piece.base)
    block = f"{indent}VAR\n{indent}    {written}\n{indent}END_VAR"
    if end < 0:
        return piece, len(text), len(text), f"\n{block}"
    return piece, end, end, f"\n{block}"


def _end_of(block: VariableBlock, piece: Piece) -> int:
    """Return the offset of the END_VAR of a block."""
    start = _last_start(block) - piece.base
    return piece.text.upper().find("END_VAR", start)


def _last_start(block: VariableBlock) -> int:
    return block.variables[-1].start if block.variables else block.start


def _indent(text: str, offset: int) -> str:
    """Return the white space before the first word of a line."""
    begin = text.rfind("\n", 0, offset) + 1
    line = text[begin:]
    return line[: len(line) - len(line.lstrip(" \t"))]
