# SPDX-License-Identifier: MIT
"""Finds slips in a PLC's file when it is loaded, before it costs a run.

In: the file, its class. Out: diagnostics with their positions: names that ``hli``, a function or
the class does not have, attributes that cannot be set, values of a wrong type, methods with wrong
parameters. Only certain slips are reported: a user's own attribute that is read somewhere never
counts as a misspelt one.
"""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from nctakt.base.diagnostics import NOTHING, Diagnostic, Message, Span, Text
from nctakt.base.misspelling import KnownNames, nearest
from nctakt.base.text import decode_text, split_lines
from nctakt.hli.operator_panel import SETTABLE
from nctakt.hli.plc_entries import (
    AXIS_ALIASES,
    AXIS_NAMES,
    CHANNEL_ALIASES,
    CHANNEL_NAMES,
    SpindleEntry,
    TechnologyEntry,
)
from nctakt.messages import Collector
from nctakt.messages.plcs.plc import (
    PLC_NAME_NOT_SETTABLE,
    UNKNOWN_HLI_VALUE,
    UNKNOWN_PLC_NAME,
    WRONG_HANDLER_PARAMETERS,
    WRONG_PLC_TYPE,
)
from nctakt.plc.script import Plc, handler_parameters
from nctakt.plc.tool_manager import ToolRequest
from nctakt.run.plcs.plc_view import PlcView, public_names

#: The members of a PLC's class that are called or read by name.
_MEMBERS = ("cycle", "each_tick", "acknowledge", "spindles", "inputs")
_VIEW = tuple(public_names(PlcView))
_REQUEST = tuple(public_names(ToolRequest))
_ENTRY = tuple(dict.fromkeys([*public_names(TechnologyEntry), *public_names(SpindleEntry)]))
_LISTS = ("functions", "spindle_jobs")
_VALUES = {
    "axis": (*AXIS_NAMES, *AXIS_ALIASES),
    "channel": (*CHANNEL_NAMES, *CHANNEL_ALIASES),
}

_POLICY = Text(
    "ALL, NONE, after(…), only(…) or run_up(…)", "ALL, NONE, after(…), only(…), run_up(…)"
)
_FILE_NAME = Text("the name of a CSV file", "der Name einer CSV-Datei")
_NUMBER = Text("a number", "eine Zahl")
_TRUTH = Text("True or False", "True oder False")


def inspect_plc(path: Path, kind: type) -> list[Diagnostic]:
    """Return the slips in the file of a PLC of class ``kind``, in the order of their positions."""
    data = path.read_bytes()
    inspection = _Inspection(str(path), split_lines(decode_text(data).text))
    tree = ast.parse(data)
    classes = {base.__name__: base for base in kind.__mro__ if base.__module__ == kind.__module__}
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and node.name in classes:
            inspection.check_class(node, classes[node.name], _names_read(tree))
    inspection.check_views(tree)
    return sorted(inspection.diagnostics, key=lambda message: message.span or Span("", 0, 0, 0))


def nearest_member(kind: type) -> str:
    """Return the method of a class that may be a misspelt ``cycle``; empty without one."""
    names = KnownNames(["cycle"])
    return next((name for name in vars(kind) if names.nearest(name) is not None), "")


def _names_read(tree: ast.AST) -> frozenset[str]:
    """Return the names of attributes and variables that are read anywhere in a file."""
    return frozenset(
        node.attr if isinstance(node, ast.Attribute) else node.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute | ast.Name) and isinstance(node.ctx, ast.Load)
    )


class _Inspection(Collector):
    """Gathers the slips in a file."""

    def __init__(self, file: str, lines: list[str]) -> None:
        super().__init__()
        self._file = file
        self._lines = lines
        #: Names of parameters that hold the HLI, and an entry of it, by the function's node.
        self._parameters: dict[ast.AST, tuple[str, str]] = {}

    def _report(self, message: Message, node: ast.AST, word: str = "", /, **values: object) -> None:
        """Report at ``node``, or at ``word`` on the line on which the node ends or begins."""
        line, column, end = _position(node, self._lines, word)
        text = self._lines[line - 1] if line <= len(self._lines) else ""
        self.report(message, Span(self._file, line, column, end), text, **values)

    # --- the class -------------------------------------------------------------------------------

    def check_class(self, node: ast.ClassDef, kind: type, read: frozenset[str]) -> None:
        """Check the members of a class of the file."""
        is_plc = issubclass(kind, Plc)
        for statement in node.body:
            for name in _assigned(statement):
                if is_plc:
                    self._check_member(statement, name, node.name, read)
                    self._check_type(statement, name, vars(kind).get(name))
            if isinstance(statement, ast.FunctionDef):
                self._check_method(statement, kind, is_plc)
                if is_plc and not statement.decorator_list:
                    self._check_member(statement, statement.name, node.name, read)
                if is_plc and statement.args.args:
                    for target in _own_attributes(statement, statement.args.args[0].arg):
                        self._check_member(target, target.attr, node.name, read)

    def _check_member(self, node: ast.AST, name: str, owner: str, read: frozenset[str]) -> None:
        """Report a member whose name is nearly one of ``Plc`` and that is not read."""
        near = None if name in _MEMBERS or name in read else KnownNames(_MEMBERS).nearest(name)
        if near is not None:
            self._report(UNKNOWN_PLC_NAME, node, name, owner=owner, name=name, nearest=near)

    def _check_type(self, node: ast.stmt, name: str, value: object) -> None:
        expression = node.value if isinstance(node, ast.Assign | ast.AnnAssign) else None
        shown = NOTHING if expression is None else ast.unparse(expression)
        if name in ("acknowledge", "spindles"):
            if isinstance(value, type) or not callable(getattr(value, "answers", None)):
                self._report(WRONG_PLC_TYPE, node, name, name=name, value=shown, expected=_POLICY)
        elif name == "inputs" and not isinstance(value, str | Path | None):
            self._report(WRONG_PLC_TYPE, node, name, name=name, value=shown, expected=_FILE_NAME)

    def _check_method(self, node: ast.FunctionDef, kind: type, is_plc: bool) -> None:
        """Check that a method takes the parameters with which it is called."""
        method = inspect.getattr_static(kind, node.name)
        needed = handler_parameters(node.name, method, is_plc=is_plc)
        if not needed or not inspect.isfunction(method):
            return
        try:
            inspect.signature(method).bind(*needed)
        except TypeError:
            self._report(
                WRONG_HANDLER_PARAMETERS,
                node,
                node.name,
                name=node.name,
                expected=", ".join(needed),
            )
            return
        parameters = [parameter.arg for parameter in (*node.args.posonlyargs, *node.args.args)]
        view, entry = (*parameters[1:3], "", "")[:2]
        self._parameters[node] = (view, entry if len(needed) > 2 else "")

    # --- uses of the HLI -------------------------------------------------------------------------

    def check_views(self, tree: ast.Module) -> None:
        """Check each function of the file that has the HLI as a parameter."""
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef | ast.Lambda):
                view, entry = self._parameters.get(node) or (_view_parameter(node), "")
                if view and not _is_assigned(node, view):
                    self._check_view(node, view)
                if entry and not _is_assigned(node, entry):
                    asks = isinstance(node, ast.FunctionDef) and node.name == "tool_data"
                    self._check_entries([node], entry, _REQUEST if asks else _ENTRY)
        for call in ast.walk(tree):
            condition = _condition(call)
            if condition is not None:
                self._check_view(condition, condition.args.args[0].arg)

    def _check_view(self, function: ast.AST, view: str) -> None:
        for node in ast.walk(function):
            if isinstance(node, ast.Attribute) and _is_view(node.value, view):
                self._check_attribute(node)
            elif isinstance(node, ast.Assign):
                for target in node.targets:
                    if isinstance(target, ast.Attribute) and _is_view(target.value, view):
                        self._check_value(target, node.value)
            elif isinstance(node, ast.Subscript):
                self._check_key(node, view)
            elif isinstance(node, ast.For | ast.comprehension):
                called = node.iter.func if isinstance(node.iter, ast.Call) else None
                if (
                    isinstance(called, ast.Attribute)
                    and called.attr in _LISTS
                    and _is_view(called.value, view)
                    and isinstance(node.target, ast.Name)
                ):
                    inner = node.body if isinstance(node, ast.For) else node.ifs
                    self._check_entries(inner, node.target.id)

    def _check_attribute(self, node: ast.Attribute) -> None:
        if node.attr.startswith("_"):
            return
        if node.attr not in _VIEW:
            names = _VIEW if isinstance(node.ctx, ast.Load) else SETTABLE
            near = nearest(node.attr, names) or NOTHING
            self._report(
                UNKNOWN_PLC_NAME, node, node.attr, owner="hli", name=node.attr, nearest=near
            )
        elif not isinstance(node.ctx, ast.Load) and node.attr not in SETTABLE:
            settable = ", ".join(SETTABLE)
            self._report(PLC_NAME_NOT_SETTABLE, node, node.attr, name=node.attr, settable=settable)

    def _check_value(self, target: ast.Attribute, value: ast.expr) -> None:
        """Check a constant that is assigned to an attribute of the HLI."""
        if target.attr not in SETTABLE or not isinstance(value, ast.Constant):
            return
        constant = value.value
        is_number = isinstance(constant, int | float)
        is_percentage = target.attr.endswith("_pct")
        fits = is_number and (
            not isinstance(constant, bool) if is_percentage else constant in (0, 1)
        )
        if not fits:
            self._report(
                WRONG_PLC_TYPE,
                value,
                name=f"hli.{target.attr}",
                value=ast.unparse(value),
                expected=_NUMBER if is_percentage else _TRUTH,
            )

    def _check_key(self, node: ast.Subscript, view: str) -> None:
        """Check ``hli.axis("X")["command"]``."""
        called = node.value.func if isinstance(node.value, ast.Call) else None
        if not isinstance(called, ast.Attribute) or not _is_view(called.value, view):
            return
        names = _VALUES.get(called.attr)
        key = node.slice.value if isinstance(node.slice, ast.Constant) else None
        if names is not None and isinstance(key, str) and key not in names:
            near = nearest(key, names) or NOTHING
            self._report(
                UNKNOWN_HLI_VALUE, node.slice, name=key, nearest=near, known=", ".join(names)
            )

    def _check_entries(
        self, nodes: Iterable[ast.AST], name: str, known: Sequence[str] = _ENTRY
    ) -> None:
        """Check the attributes read of a function, a spindle job or a request for a tool."""
        for node in (inner for part in nodes for inner in ast.walk(part)):
            if (
                isinstance(node, ast.Attribute)
                and isinstance(node.value, ast.Name)
                and node.value.id == name
                and node.attr not in known
            ):
                near = nearest(node.attr, known) or NOTHING
                self._report(
                    UNKNOWN_PLC_NAME, node, node.attr, owner=name, name=node.attr, nearest=near
                )


def _position(node: ast.AST, lines: list[str], name: str) -> tuple[int, int, int]:
    """Return line, column and end of a node, or of ``name`` in it, in characters from 1."""
    line = getattr(node, "lineno", 1)
    last = getattr(node, "end_lineno", line) or line
    if name and isinstance(node, ast.Attribute):
        line = last
    text = lines[line - 1] if line <= len(lines) else ""
    begin = _characters(text, getattr(node, "col_offset", 0))
    end = _characters(text, getattr(node, "end_col_offset", 0)) if line == last else len(text)
    if isinstance(node, ast.Attribute):
        return line, end - len(name) + 1, end + 1
    if name:
        begin = max(begin, text.find(name, begin))
        end = begin + len(name)
    return line, begin + 1, max(begin, end) + 1


def _characters(text: str, offset: int) -> int:
    """Return a count of UTF-8 bytes in characters."""
    return len(text.encode()[:offset].decode(errors="ignore"))


def _assigned(statement: ast.stmt) -> Iterator[str]:
    """Yield the names to which a statement of a class assigns."""
    targets: list[ast.expr] = []
    if isinstance(statement, ast.Assign):
        targets = statement.targets
    elif isinstance(statement, ast.AnnAssign) and statement.value is not None:
        targets = [statement.target]
    for target in targets:
        if isinstance(target, ast.Name):
            yield target.id


def _own_attributes(function: ast.FunctionDef, own: str) -> Iterator[ast.Attribute]:
    """Yield the attributes of ``self`` that a method sets."""
    for node in ast.walk(function):
        if (
            isinstance(node, ast.Attribute)
            and isinstance(node.ctx, ast.Store)
            and isinstance(node.value, ast.Name)
            and node.value.id == own
        ):
            yield node


def _view_parameter(node: ast.FunctionDef | ast.Lambda) -> str:
    """Return the parameter ``hli`` of any function, unless it is annotated as something else."""
    for parameter in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs):
        annotation = (
            "PlcView" if parameter.annotation is None else ast.unparse(parameter.annotation)
        )
        if parameter.arg == "hli" and annotation.strip("'\"").endswith("PlcView"):
            return parameter.arg
    return ""


def _condition(node: ast.AST) -> ast.Lambda | None:
    """Return the lambda of ``@when(lambda view: …)`` if its parameter is not called ``hli``."""
    if not isinstance(node, ast.Call) or len(node.args) != 1:
        return None
    name = node.func.attr if isinstance(node.func, ast.Attribute) else None
    name = node.func.id if isinstance(node.func, ast.Name) else name
    condition = node.args[0]
    if name != "when" or not isinstance(condition, ast.Lambda) or len(condition.args.args) != 1:
        return None
    return None if condition.args.args[0].arg == "hli" else condition


def _is_view(node: ast.expr, view: str) -> bool:
    """Return whether an expression is the HLI: the parameter, or ``of_channel`` of it."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        return node.func.attr == "of_channel" and _is_view(node.func.value, view)
    return isinstance(node, ast.Name) and node.id == view


def _is_assigned(function: ast.AST, name: str) -> bool:
    """Return whether a function gives the parameter another value."""
    return any(
        isinstance(node, ast.Name) and node.id == name and not isinstance(node.ctx, ast.Load)
        for node in ast.walk(function)
    )
