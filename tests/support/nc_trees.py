# SPDX-License-Identifier: MIT
"""Trees of NC programs in tests: reading a few lines, and comparing without places."""

from __future__ import annotations

import dataclasses
from typing import Any

from nctakt.base.diagnostics import Diagnostic
from nctakt.messages import Collector
from nctakt.nc.parse.parser import parse_program
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    Assignment,
    Binary,
    Call,
    Expression,
    Number,
    Program,
    Statement,
    Unary,
)


def read(text: str) -> tuple[Program, list[Diagnostic]]:
    """The program and what was reported."""
    collector = Collector()
    program = parse_program(Source("test.nc", text.split("\n")), collector)
    return program, collector.diagnostics


def statements(text: str) -> tuple[Statement, ...]:
    """The statements of a text without mistakes."""
    program, diagnostics = read(text)
    assert [found.headline() for found in diagnostics] == []
    return program.statements


def statement(text: str) -> Statement:
    """The only statement of a text without mistakes."""
    (only,) = statements(text)
    return only


def expression(text: str) -> Expression:
    """An expression, read as the value of an assignment."""
    assignment = statement(f"P1 = {text}")
    assert isinstance(assignment, Assignment)
    return assignment.value


def numbers(text: str) -> list[int]:
    """The numbers of what is reported for a text."""
    return [found.id for found in read(text)[1]]


def shape(node: Any) -> Any:
    """A tree without its places and its source, for comparison."""
    if isinstance(node, tuple):
        return tuple(shape(item) for item in node)
    if not dataclasses.is_dataclass(node):
        return node
    fields = {
        field.name: shape(getattr(node, field.name))
        for field in dataclasses.fields(node)
        if field.name not in ("span", "else_span", "end_span", "source")
    }
    return (type(node).__name__, *fields.items())


def grouped(node: Expression) -> str:
    """An expression with brackets around each operator."""
    if isinstance(node, Number):
        return f"{node.value:g}"
    if isinstance(node, Unary):
        return f"({node.operator} {grouped(node.operand)})"
    if isinstance(node, Call):
        return f"{node.function}({', '.join(grouped(item) for item in node.arguments)})"
    assert isinstance(node, Binary)
    return f"({grouped(node.left)} {node.operator} {grouped(node.right)})"
