# SPDX-License-Identifier: MIT
"""Exception breakpoints: errors by their class, #ERROR, messages; and those that occurred.

In: the filters that a client has chosen, the events of a tick. Out: the stops to watch, and the
event that a filter wants, with its cause and its remedy.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Message, Text
from nctakt.debugger.arguments import Arguments
from nctakt.messages.catalogue import messages_of
from nctakt.messages.classes import CLEARINGS, REACTIONS
from nctakt.messages.plcs.plc_code import (
    CONVERSION_OUTSIDE,
    DIVISION_BY_ZERO,
    EXCEPTION_RAISED,
    INVALID_OPERATION,
    PLC_INDEX_OUTSIDE,
    POINTER_OUTSIDE,
    STACK_FULL,
    STEP_ZERO,
    TOO_MANY_INSTRUCTIONS,
)
from nctakt.results.trace.events import Event
from nctakt.session.stops import StopAt

_LABELS = {
    "error": Text("Errors", "Fehler"),
    "user_error": Text("#ERROR of programs", "#ERROR der Programme"),
    "warning": Text("Warnings and notes of the realtime part", "Warnungen und Hinweise im Takt"),
    "message": Text("#MSG of programs", "#MSG der Programme"),
}

_OTHERS = (INVALID_OPERATION, STACK_FULL, TOO_MANY_INSTRUCTIONS, STEP_ZERO, EXCEPTION_RAISED)
#: Faults of a PLC in Structured Text: filter -> its label, and the numbers of their messages.
_FAULTS = {
    "plc_pointer": (
        Text("PLC: null or foreign pointer", "SPS: Zeiger null oder fremd"),
        (POINTER_OUTSIDE.id,),
    ),
    "plc_index": (Text("PLC: index outside", "SPS: Index außerhalb"), (PLC_INDEX_OUTSIDE.id,)),
    "plc_division": (
        Text("PLC: division by zero", "SPS: Division durch null"),
        (DIVISION_BY_ZERO.id,),
    ),
    "plc_conversion": (
        Text("PLC: conversion outside of the type", "SPS: Konvertierung außerhalb des Typs"),
        (CONVERSION_OUTSIDE.id,),
    ),
    "plc_other": (
        Text("PLC: other faults", "SPS: andere Fehler"),
        tuple(one.id for one in _OTHERS),
    ),
}

_CLASS = Text("Class", "Klasse")
_WORDS = {
    "cause": Text("cause", "Ursache"),
    "effect": Text("effect", "Wirkung"),
    "clearing": Text("cleared by", "Löschen"),
}

#: The filter that is on unless the client chooses.
_DEFAULT = "error"

#: The kinds of events that a class of errors may have.
_ERRORS = ("error", "warning", "notice", "note")


@dataclass(frozen=True, slots=True)
class Raised:
    """An exception in a tick: the event, and its message if it has a number."""

    event: Event
    message: Message | None

    @property
    def title(self) -> str:
        """The event as a short text."""
        return f"{self.event.kind} {self.event.text}"


def filters(language: Language) -> list[dict[str, Any]]:
    """Return the filters that a client may offer."""
    found = [_filter(name, label.get(language)) for name, label in _LABELS.items()]
    for number, effect in REACTIONS.items():
        label = f"{_CLASS.get(language)} {number}: {effect.get(language)}"
        found.append(_filter(f"class{number}", label))
    for name, (fault, _) in _FAULTS.items():
        found.append({"filter": name, "label": fault.get(language), "default": True})
    return found


def _filter(name: str, label: str) -> dict[str, Any]:
    return {
        "filter": name,
        "label": label,
        "default": name == _DEFAULT,
        "supportsCondition": True,
        "conditionDescription": "900243, 22009",
    }


class ExceptionFilters:
    """The active filters, each with its numbers; none: all."""

    def __init__(self) -> None:
        self._selected: dict[str, tuple[int, ...]] = dict.fromkeys((_DEFAULT, *_FAULTS), ())

    def set(self, arguments: Arguments) -> None:
        """Choose filters; their conditions are numbers of messages."""
        selected: dict[str, tuple[int, ...]] = dict.fromkeys(arguments.texts("filters"), ())
        for option in arguments.parts("filterOptions"):
            numbers = option.text("condition", "").replace(",", " ").split()
            known = tuple(int(number) for number in numbers if number.isdecimal())
            selected[option.text("filterId")] = known
        self._selected = selected

    def stops(self) -> list[StopAt]:
        """Return the stops to watch."""
        own = [name for name in self._selected if name not in _FAULTS]
        has_errors = any(name not in ("warning", "message") for name in own)
        has_notices = any(name not in ("user_error", "message", "error") for name in own)
        kinds = [] if len(own) == len(self._selected) else [StopAt("fault")]
        if has_errors or has_notices:
            kinds.append(StopAt("error"))
        if has_notices:
            kinds.append(StopAt("notice"))
        if "message" in self._selected:
            kinds.append(StopAt("message"))
        return kinds

    def takes(self, fault: Diagnostic) -> bool:
        """Return whether a filter wants a fault of the PLC."""
        return any(fault.id in _FAULTS[name][1] for name in self._selected if name in _FAULTS)

    def selected(self, events: Iterable[Event], tick: int) -> Raised | None:
        """Return the first event of a tick that a filter wants."""
        for event in events:
            if event.tick == tick:
                raised = Raised(event, _message_of(event))
                for name, numbers in self._selected.items():
                    if _is_of(raised, name) and (not numbers or _number(event) in numbers):
                        return raised
        return None


def _is_of(raised: Raised, name: str) -> bool:
    """Return whether an event belongs to a filter."""
    kind = raised.event.kind
    if name == "warning":
        return kind in ("warning", "notice", "note")
    if name in ("user_error", "message", "error"):
        return kind == name
    reaction = 0 if raised.message is None else raised.message.reaction
    return kind in _ERRORS and name == f"class{reaction}"


def _number(event: Event) -> int:
    first = event.text.partition(" ")[0]
    return int(first) if first.isdecimal() else 0


def _message_of(event: Event) -> Message | None:
    if event.kind not in _ERRORS:
        return None
    return next(iter(messages_of(_number(event))), None)


def info(raised: Raised, diagnostics: Sequence[Diagnostic], language: Language) -> dict[str, Any]:
    """Return the details of an event for a client: text, cause, effect, remedy."""
    number = _number(raised.event)
    known = next((one for one in reversed(diagnostics) if one.id == number), None)
    if raised.event.kind == "user_error":
        known = diagnostics[-1] if diagnostics else None
    lines = [known.render(language)] if known is not None else [raised.title]
    message = raised.message
    if message is not None and message.cause.get(language):
        lines.append(f"  {_WORDS['cause'].get(language)}: {message.cause.get(language)}")
    if message is not None and message.reaction in REACTIONS:
        effect = REACTIONS[message.reaction].get(language)
        lines.append(f"  {_WORDS['effect'].get(language)}: {effect}")
    if message is not None and message.clearing in CLEARINGS:
        clearing = CLEARINGS[message.clearing].get(language)
        lines.append(f"  {_WORDS['clearing'].get(language)}: {clearing}")
    kind = _LABELS.get(raised.event.kind)
    name = f"{_CLASS.get(language)} {message.reaction}" if message is not None else ""
    details: dict[str, Any] = {"message": lines[0], "stackTrace": "\n".join(lines)}
    if name or kind is not None:
        details["typeName"] = name or (kind.get(language) if kind is not None else "")
    return {
        "exceptionId": raised.title,
        "description": "\n".join(lines),
        "breakMode": "always",
        "details": details,
    }


def fault_info(fault: Diagnostic, language: Language) -> dict[str, Any]:
    """Return the details of a fault that has stopped the PLC, for a client."""
    return {
        "exceptionId": str(fault.id),
        "description": fault.text(language),
        "breakMode": "always",
        "details": {"message": fault.render(language)},
    }
