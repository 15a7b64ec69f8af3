# SPDX-License-Identifier: MIT
"""Values of variables at times of a run, from Python or from the words of a command line.

In: ``("1.5 ms", "V.E.VALUE", 5)`` or the words ``1.5ms V.E.VALUE=5``. Out: ``Stimulus`` objects. A
stimulus is latched at the start of the first tick that begins at or after its time (RC-001,
RC-002). The controller checks the variable and its range.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic
from nctakt.base.failure import Failure
from nctakt.lists.format import arguments
from nctakt.lists.format.times import Time, TimeLike, read_time
from nctakt.messages import diagnostic
from nctakt.messages.commands.inputs import (
    NOT_A_STIMULUS,
    NOT_AN_ASSIGNMENT,
    STIMULUS_NOT_REACHED,
    UNREADABLE_VALUE,
)
from nctakt.run.access.input_words import WRITE
from nctakt.run.access.inputs import STIMULI, Input

_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
#: An item of a PLC's enumeration, such as E_Gate.Open, or a literal such as T#2s or 16#FF.
_ITEM = re.compile(r"[A-Za-z_]\w*\.[A-Za-z_]\w*|\w+#[\w.:#+-]+", re.ASCII)
_TRUTH = {"TRUE": 1.0, "FALSE": 0.0}

_WHOLE = re.compile(r"[+-]?\d{1,20}", re.ASCII)

#: Up to here a whole number is exact as a float; a PLC has larger ones (ULINT).
_LARGEST_EXACT = 1 << 53

#: The limit of the values of a 64-bit variable.
_LARGEST = 1.7976931348623157e308


@dataclass(frozen=True, slots=True, init=False)
class Stimulus:
    """A value for a variable at a time of the run, counted from the run's first tick.

    ``Stimulus("20 ms", "V.E.DOOR", 1)``: the time is a text with a unit (us, ms, s, min, h, ticks),
    a number of seconds or a ``datetime.timedelta``. Raises ``Failure`` for any
    other time, for a name that is no text and a value that no variable holds.

    >>> stimulus = Stimulus("20 ms", "V.E.VALUE", 5)
    >>> controller = Controller()
    >>> run = controller.run(NcText("move.nc", "G01 X10 F6000 M30"), at=[stimulus])
    >>> controller.read("V.E.VALUE")
    5.0
    """

    time: Time
    name: str
    value: float | str

    def __init__(self, time: TimeLike, name: str, value: float | str) -> None:
        arguments.text("name", name)
        object.__setattr__(self, "time", read_time(time))
        object.__setattr__(self, "name", name)
        object.__setattr__(self, "value", arguments.number_or_text(name, value))


#: A stimulus in the Python interface.
StimulusLike = Stimulus | tuple[TimeLike, str, float | str]


def read_stimulus(value: StimulusLike) -> Stimulus:
    """Return ``value`` itself, or the stimulus of its time, name and value.

    Raises ``Failure`` for anything else (900514) and for a wrong time (900510, 900513).
    """
    if isinstance(value, Stimulus):
        return value
    if not isinstance(value, tuple | list) or len(value) != 3 or not isinstance(value[1], str):
        raise Failure(diagnostic(NOT_A_STIMULUS, value=repr(value)))
    return Stimulus(*value)


def as_inputs(stimuli: Iterable[Stimulus], first_tick: int, cycle_time_us: int) -> list[Input]:
    """Return the stimuli of a run as inputs, in the order of their times."""
    return [
        Input(
            first_tick + stimulus.time.ticks(cycle_time_us),
            STIMULI,
            WRITE,
            (stimulus.name, stimulus.value),
        )
        for stimulus in sorted(stimuli, key=lambda stimulus: stimulus.time.us(cycle_time_us))
    ]


def not_reached(stimuli: Iterable[Stimulus], end_us: int, cycle_time_us: int) -> list[Diagnostic]:
    """Return a warning (901007) for each stimulus whose time a run has not reached."""
    return [
        diagnostic(
            STIMULUS_NOT_REACHED,
            name=stimulus.name,
            time=str(stimulus.time),
            end=str(Time(end_us)),
        )
        for stimulus in sorted(stimuli, key=lambda stimulus: stimulus.time.us(cycle_time_us))
        if stimulus.time.ticks(cycle_time_us) * cycle_time_us >= end_us
    ]


def parse_assignment(text: str) -> tuple[str, float | str]:
    """Return name and value of ``V.E.VALUE=5`` or ``V.E.TEXT="part"``; TRUE is 1, FALSE is 0.

    Raises ``Failure`` for another text (900511) and for an invalid value (900512).
    """
    name, equals, value = text.partition("=")
    name = name.strip()
    if not equals or not name:
        raise Failure(diagnostic(NOT_AN_ASSIGNMENT, text=text))
    return name, _parse_value(name, value.strip())


def assignment_text(name: str, value: float | str) -> str:
    """Return the text of an assignment, which ``parse_assignment`` reads."""
    if isinstance(value, str):
        return f'{name}="{value}"'
    return f"{name}={int(value) if value == int(value) else repr(value)}"


def parse_stimulus(time: str, assignment: str) -> Stimulus:
    """Return the stimulus of ``--at TIME NAME=VALUE``; raises ``Failure`` for mistakes."""
    return Stimulus(time, *parse_assignment(assignment))


def _parse_value(name: str, text: str) -> float | str:
    if len(text) > 1 and text[0] == text[-1] == '"':
        return text[1:-1]
    truth = _TRUTH.get(text.upper())
    if truth is not None:
        return truth
    if _ITEM.fullmatch(text):
        return text
    if _NUMBER.fullmatch(text) is None or abs(float(text)) > _LARGEST:
        raise Failure(diagnostic(UNREADABLE_VALUE, name=name, value=text))
    return int(text) if _WHOLE.fullmatch(text) and abs(int(text)) > _LARGEST_EXACT else float(text)
