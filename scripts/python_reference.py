# SPDX-License-Identifier: MIT
"""The reference of the Python interface, from the docstrings of its classes and functions.

In: the public names of ``nctakt`` and the types of their results. Out: the lines of
``docs/reference/python.md``, which ``scripts/docs`` writes. ``tests/test_face.py`` runs the
examples.
"""

import inspect
import re
from collections.abc import Callable, Iterator

import nctakt
from nctakt.hli.connection import PlcConnection
from nctakt.hli.operator_panel import OperatorPanel
from nctakt.hli.plc_entries import SpindleEntry, TechnologyEntry
from nctakt.hli.plc_side import PlcSide
from nctakt.results.run import CycleResult, ProgramMessage, ReactionResult, TechnologyOutput
from nctakt.results.trace.events import Event
from nctakt.results.trace.recorded import Trace
from nctakt.run.plcs.plc_view import PlcView

HEAD = """\
# The Python interface

Written by `scripts/docs` from the docstrings; `help(nctakt.Controller)` shows the same.

The names of the first four sections are those of `import nctakt`. The examples work with the \
built-in machine; they assume `from nctakt import Controller, NcText` and so on; tests run \
them. The last section has the types of results and arguments, which programs do not create.

A time is a text with a unit (`"1.5 s"`, `"20 ms"`, `"1500us"`, `"2 min"`, `"300 ticks"`), a \
number of seconds or a `datetime.timedelta`; a name that ends in `_us` holds microseconds. \
Failures are exceptions of the class `Failure`; the numbers of their messages are in \
[messages.md](messages.md).
"""

SECTIONS: dict[str, tuple[str, ...]] = {
    "Programs and results": ("Controller", "NcText", "Stimulus", "Run", "Diagnostic", "Failure"),
    "Machines": ("load_machine", "Machine"),
    "PLC": ("Plc", "at", "on", "when", "after"),
    "Scheduling lists": ("open_schedule", "simulate_schedule"),
}
RESULTS = (
    PlcView,
    OperatorPanel,
    PlcConnection,
    PlcSide,
    TechnologyEntry,
    SpindleEntry,
    Trace,
    Event,
    TechnologyOutput,
    ProgramMessage,
    CycleResult,
    ReactionResult,
)
#: The classes of which programs create objects.
CREATED = ("Controller", "NcText", "Stimulus")
DOCUMENTED = {name for names in SECTIONS.values() for name in names}
DOCUMENTED |= {kind.__name__ for kind in RESULTS}
#: The longest default value in a signature, in characters.
MAX_DEFAULT = 60
#: Names without a link, since parameters have them as well.
DOCUMENTED -= {"at", "on", "when", "after"}


def python_reference() -> Iterator[str]:
    """Yield the lines of the document."""
    yield HEAD.rstrip()
    for title, names in SECTIONS.items():
        yield from ("", f"## {title}")
        for name in names:
            yield from article(getattr(nctakt, name))
    yield from ("", "## Types of results and arguments")
    for kind in RESULTS:
        yield from article(kind)


def article(subject: type | Callable[..., object]) -> Iterator[str]:
    """Yield a class with its members, or a function."""
    name = subject.__name__
    yield from ("", f"### {name}", "")
    if not inspect.isclass(subject) or name in CREATED:
        yield from signature(name, subject)
    elif fields(subject):
        yield f"Fields: {fields(subject)}"
        yield ""
    yield from text_of(inspect.getdoc(subject) or "")
    if inspect.isclass(subject):
        for member, value in vars(subject).items():
            if not member.startswith("_"):
                yield from member_article(name, member, value)


def fields(kind: type) -> str:
    """Return the fields of a class with their types."""
    shown = [
        f"`{name}: {type_}`"
        for name, type_ in vars(kind).get("__annotations__", {}).items()
        if not name.startswith("_")
    ]
    return ", ".join(shown)


def member_article(owner: str, name: str, value: object) -> Iterator[str]:
    """Yield a property or a method of a class."""
    if isinstance(value, property):
        result = value.fget.__annotations__.get("return", "") if value.fget else ""
        settable = ", may be set" if value.fset else ""
        yield from ("", f"**`{owner}.{name}: {result}`**{settable}", "")
    elif inspect.isfunction(value):
        yield from ("", f"**`{owner}.{name}`**", "")
        yield from signature(name, value)
    else:
        return
    yield from text_of(inspect.getdoc(value) or "")


def signature(name: str, subject: Callable[..., object]) -> Iterator[str]:
    """Yield the signature of a class or function as a block of code."""
    call = inspect.signature(subject)
    shown = [
        parameter.replace(default=...) if len(repr(parameter.default)) > MAX_DEFAULT else parameter
        for parameter in call.parameters.values()
        if parameter.name != "self"
    ]
    call = call.replace(parameters=shown)
    is_decorator = "_Method" in str(call.return_annotation)
    if inspect.isclass(subject) or is_decorator:
        call = call.replace(return_annotation=inspect.Signature.empty)
    text = f"{'@' if is_decorator else ''}{name}{call}".replace("Ellipsis", "...")
    text = re.sub(r"(: |-> )'([^']*)'", r"\1\2", text)
    yield "```python"
    if len(text) <= 90:
        yield text
    else:
        head, _, result = text.rpartition(")")
        yield f"{name}("
        parameters = re.split(r", (?=\*|\w+:)", head[len(name) + 1 :])
        yield from (f"    {parameter}," for parameter in parameters)
        yield f"){result}"
    yield from ("```", "")


def text_of(docstring: str) -> Iterator[str]:
    """Yield a docstring as Markdown: its paragraphs, its examples and other code as blocks."""
    for paragraph in docstring.split("\n\n"):
        lines = paragraph.splitlines()
        if lines[0].startswith((">>>", "    ")):
            yield from ("```pycon" if lines[0].startswith(">>>") else "```text", *lines, "```")
        else:
            yield prose(" ".join(lines))
        yield ""


def prose(text: str) -> str:
    """Return a paragraph with its code marked and its names linked."""
    parts = re.split(r"``(.+?)``", text)
    for index, part in enumerate(parts):
        if index % 2 == 0:
            parts[index] = part.replace("<", "\\<").replace("*", "\\*")
        elif part in DOCUMENTED:
            parts[index] = f"[`{part}`](#{part.lower()})"
        else:
            parts[index] = f"`{part}`"
    return "".join(parts)


def document() -> str:
    """Return the document, without two empty lines in sequence."""
    return re.sub(r"\n{3,}", "\n\n", "\n".join(python_reference())).rstrip() + "\n"
