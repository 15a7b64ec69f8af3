# SPDX-License-Identifier: MIT
"""A single expression of a debugger -> a node that is evaluated before a statement.

It sees what the statement sees, changes nothing and always ends: an expression that calls code of
the project, writes, or needs room in the PLC's memory is refused by name.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields
from typing import NoReturn

from nctakt.kernel.st.calls import Callee, Routine
from nctakt.kernel.st.reals import Real
from nctakt.kernel.st.wholes import Whole
from nctakt.st import tree
from nctakt.st.types import Callable, Expression, InterfaceType, Node, Pou, Property, Variable
from nctakt.translation.body import CannotRunError, value_type
from nctakt.translation.initialisation import Initialisation
from nctakt.translation.layout import Layout, is_real, kind_of
from nctakt.translation.observing.noting import NoteRows
from nctakt.translation.observing.probing import Probes

#: Functions that only compute.
_PURE = frozenset(
    """ABS SQRT LN LOG EXP SIN COS TAN ASIN ACOS ATAN EXPT TRUNC TRUNC_INT MIN MAX LIMIT SEL MUX
    MOVE SHL SHR ROL ROR ADR SIZEOF XSIZEOF LOWER_BOUND UPPER_BOUND __ISVALIDREF""".split()
)


class _KnownLiterals(Layout):
    """The layout of a program with a memory: it has the literals that it has."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self.data_end = layout.data_end
        self.stack_end = layout.stack_end
        self.data = layout.data

    def literal(self, content: bytes) -> int:
        """Return the address of bytes that the program has as well."""
        found = self._layout.known_literal(content)
        if found is None:
            raise CannotRunError(Node(0, 0), "a text that does not occur in the program")
        return found


class _Alone:
    """The project as seen by the body of an expression: its memory, and nothing to call."""

    def __init__(self, layout: Layout) -> None:
        self.layout: Layout = _KnownLiterals(layout)
        self.roots: set[str] = set()
        self.counted: Mapping[int, int] = {}
        self.notes: NoteRows | None = None
        self.probes: Probes | None = None

    def routine(self, called: Callable) -> Routine:
        """Refuse a call."""
        _refuse_call(called)

    def shared_bytes(self, called: Callable) -> int:
        """Refuse a call."""
        _refuse_call(called)

    def virtual(self, called: Callable, declared: Pou | InterfaceType) -> Callee:
        """Refuse a call."""
        _refuse_call(called)

    def types_of(self, declared: Pou | InterfaceType) -> list[tuple[int, int]]:
        """Refuse to ask for a type."""
        raise CannotRunError(Node(0, 0), f"the type {declared.name}")

    def exact(self, called: Callable, declared: Pou) -> Callee:
        """Refuse a call."""
        _refuse_call(called)

    def image_of_variable(self, variable: Variable) -> bytes:
        """Refuse to begin a variable."""
        raise CannotRunError(Node(0, 0), variable.name)

    def own_function(self, name: str) -> Pou | None:
        """Return that no function of the project checks values that are only inspected."""
        return None

    def starter(self, pou: Pou) -> Routine:
        """Refuse a call."""
        _refuse_call(pou)

    def number_of(self, pou: Pou) -> int:
        """Refuse to ask for a type."""
        raise CannotRunError(Node(0, 0), f"the type {pou.name}")


def _refuse_call(called: Callable) -> NoReturn:
    raise CannotRunError(Node(0, 0), f"a call of {called.path}")


def translate_single(
    expression: Expression, unit: Callable, pou: Pou | None, layout: Layout
) -> Whole | Real:
    """Return the node of a number or a truth, of anything else that of its address.

    ``pou``: the block whose variables the unit sees. Raises ``CannotRunError``.
    """
    for part in _nodes(expression):
        _check(part)
    body = Initialisation(_Alone(layout), unit, pou)
    found = value_type(expression)
    if is_real(found):
        node: Whole | Real = body.real(expression)
    elif kind_of(found) is not None:
        node = body.whole(expression)
    else:
        node = body.location(expression).address()
    if body.frame.size > Initialisation(_Alone(layout), unit, pou).frame.size:
        raise CannotRunError(expression, "a text that is put together")
    return node


def _check(node: Expression) -> None:
    """Raise ``CannotRunError`` for an expression that may change something."""
    if isinstance(node, tree.AssignmentExpression):
        raise CannotRunError(node, "an assignment")
    if isinstance(node, tree.Name | tree.Member) and isinstance(node.target, Property):
        raise CannotRunError(node, f"a call of the property {node.target.name}")
    if isinstance(node, tree.Call):
        is_pure = node.kind is tree.CallKind.BUILT_IN and node.function.upper() in _PURE
        if not is_pure and node.kind is not tree.CallKind.CONVERSION:
            name = node.function or getattr(node.target, "path", "")
            raise CannotRunError(node, f"a call of {name}")


def _nodes(expression: Expression) -> Iterator[Expression]:
    """Yield an expression and all its parts."""
    yield expression
    for field in fields(expression):
        yield from _inside(getattr(expression, field.name))


def _inside(value: object) -> Iterator[Expression]:
    if isinstance(value, Expression):
        yield from _nodes(value)
    elif isinstance(value, tree.Argument):
        yield from _inside(value.value)
    elif isinstance(value, list | tuple):
        for one in value:
            yield from _inside(one)
