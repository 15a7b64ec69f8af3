# SPDX-License-Identifier: MIT
"""Where messages are reported: each by its name, with exactly the parameters that it declares."""

from __future__ import annotations

import ast
import functools
import importlib
import pkgutil
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

import nctakt.messages
from nctakt.base.diagnostics import Message
from nctakt.messages.catalogue import catalogue, is_own
from nctakt.messages.unreached import UNREACHED

SOURCES = Path(nctakt.__file__).parent
MESSAGES = SOURCES / "messages"
#: The realtime part imports nothing: there a message is its number.
KERNEL = SOURCES / "kernel"

NAMES = {
    name: message
    for module in pkgutil.walk_packages(nctakt.messages.__path__, "nctakt.messages.")
    for name, message in vars(importlib.import_module(module.name)).items()
    if isinstance(message, Message)
}


#: All modules but the catalogue's.
MODULES = [path for path in sorted(SOURCES.rglob("*.py")) if MESSAGES not in path.parents]


def reported(node: ast.expr) -> list[str]:
    """The names of the messages that an argument represents: one, or one of two."""
    if isinstance(node, ast.IfExp):
        return [*reported(node.body), *reported(node.orelse)]
    return [node.id] if isinstance(node, ast.Name) and node.id in NAMES else []


def given(call: ast.Call) -> set[str | None]:
    """The parameters of a call; those of a dictionary that is in it count as well."""
    values: set[str | None] = {word.arg for word in call.keywords}
    for argument in call.args:
        if isinstance(argument, ast.Dict):
            values |= {key.value for key in argument.keys if isinstance(key, ast.Constant)}
    return values


def calls() -> Iterator[tuple[str, ast.Call, Message]]:
    """Each call that has a message as an argument, with its place."""
    for path in MODULES:
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Call):
                for argument in node.args:
                    for name in reported(argument):
                        yield (
                            f"{path.relative_to(SOURCES)}:{node.lineno}: {name}",
                            node,
                            NAMES[name],
                        )


#: What its own call adds to the parameters that it is given.
ADDED = {
    "defect": {"key", "default"},
    "_may": {"name"},
    "_whole": {"value"},
    "HeldMotion": {"radius"},
    "UnusableKinematicError": {"id", "key"},
    "expected": {"found", "symbol"},
    "Finding": {"value", "word"},
    "get": {"said", "values"},
    "unknown": {"name", "nearest", "libraries"},
    "warn_at": {"key"},
}


def name_of(call: ast.Call) -> str:
    """The last word of what is called."""
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


@pytest.mark.nightly
def test_a_call_gives_the_parameters_of_its_message() -> None:
    """Else a mistake of a user would end in a traceback."""
    wrong = []
    for place, call, message in calls():
        names = given(call) - {"source_line", "span"}
        missing = message.parameters.keys() - names - ADDED.get(name_of(call), set())
        unknown = names - message.parameters.keys() - {None}
        if unknown or (missing and None not in names):
            wrong.append(f"{place}: missing {sorted(missing)}, unknown {sorted(map(str, unknown))}")
    assert wrong == []


def test_names_are_unique_and_upper_case() -> None:
    """A name means one message, wherever it is imported."""
    declared = Counter(
        target.id
        for module in MESSAGES.glob("*.py")
        for node in ast.parse(module.read_text("utf-8")).body
        if isinstance(node, ast.Assign)
        for target in node.targets
        if isinstance(target, ast.Name) and target.id in NAMES
    )
    assert [name for name, count in declared.items() if count > 1 or name != name.upper()] == []
    assert {*NAMES.values(), *UNREACHED} == set(catalogue())


#: Numbers below are those of anything else, too.
LEAST = 10_000
#: All numbers that lead a message, and those of ours.
NUMBERS = {
    number
    for one in catalogue()
    for number in one.numbers
    if number >= LEAST and (number in one.leading or is_own(number))
}


@functools.cache
def read_in(path: Path) -> tuple[frozenset[str], frozenset[int]]:
    """The names that a module reads, and the numbers of messages in it."""
    nodes = [*ast.walk(ast.parse(path.read_text("utf-8")))]
    constants = (node.value for node in nodes if isinstance(node, ast.Constant))
    return (
        frozenset(node.id for node in nodes if isinstance(node, ast.Name)),
        frozenset(value for value in constants if type(value) is int and value in NUMBERS),
    )


def numbers_of_libraries() -> set[int]:
    """The numbers in the libraries of Structured Text, which the realtime part runs."""
    texts = [path.read_text("utf-8") for path in (SOURCES / "st" / "libraries").glob("*.st")]
    return {int(one) for text in texts for one in re.findall(r"(?<![\w#.])\d+(?![\w.])", text)}


def test_each_message_is_in_use() -> None:
    """Each message is reported somewhere by its name, or by the realtime part as a number."""
    names = set().union(*(read_in(path)[0] for path in MODULES))
    numbers = numbers_of_libraries().union(*(read_in(path)[1] for path in MODULES))
    unused = [
        name for name, one in NAMES.items() if name not in names and numbers.isdisjoint(one.leading)
    ]
    assert unused == []


def test_what_is_declared_as_unreached_is_reported_nowhere() -> None:
    """errors.md: the numbers that the checker makes impossible are reported nowhere."""
    silent = {message.id for message in UNREACHED}
    assert silent.isdisjoint(set().union(*(read_in(path)[1] for path in MODULES)))


def test_no_bare_number_stands_for_a_message() -> None:
    """Outside of the realtime part a message has its name."""
    bare = {
        path: numbers
        for path in MODULES
        if KERNEL not in path.parents and (numbers := read_in(path)[1])
    }
    assert bare == {}
