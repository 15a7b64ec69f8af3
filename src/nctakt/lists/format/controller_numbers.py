# SPDX-License-Identifier: MIT
"""Numbers under which the controller reports the values of single parameters.

In: ``numbers.tsv``, a line for each number and parameter, read when it is asked for. Out: the
numbers of a parameter, the parameters of a number, and the number of a value outside its range.
The columns: ``number``; ``id`` of the parameter; ``case``, a word of ``CASES``; ``found``: ``list``
when lists are read, ``run`` while the controller works.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Text
from nctakt.lists.format.parameter import Parameter

#: Numbers for any parameter: above its range, below it.
ABOVE, BELOW = 1023, 1024

#: Meaning of a number for the value.
CASES: dict[str, Text] = {
    "zero": Text("it is 0, which is not allowed", "er ist 0, was nicht erlaubt ist"),
    "negative": Text("it is negative", "er ist negativ"),
    "low": Text("it is too small", "er ist zu klein"),
    "high": Text("it is too large", "er ist zu groß"),
    "invalid": Text("it is not an allowed value", "er ist kein erlaubter Wert"),
    "missing": Text(
        "what it names or needs does not exist", "was er nennt oder braucht, gibt es nicht"
    ),
    "count": Text(
        "the number of entries does not fit it", "die Anzahl der Einträge passt nicht dazu"
    ),
    "twice": Text("it is used twice", "er kommt doppelt vor"),
    "order": Text(
        "it does not fit a related value",
        "er passt nicht zu einem zugehörigen Wert",
    ),
    "differs": Text(
        "it differs between axes that must agree",
        "er ist bei Achsen verschieden, die übereinstimmen müssen",
    ),
    "file": Text("its file cannot be used", "seine Datei ist nicht verwendbar"),
    "position": Text(
        "an axis is or would be beyond this limit",
        "eine Achse steht jenseits dieser Grenze oder käme dorthin",
    ),
    "drive": Text("this drive does not allow it", "dieser Antrieb lässt ihn nicht zu"),
    "corrected": Text("it was corrected", "er wurde berichtigt"),
    "restart": Text(
        "a change takes effect at the next start", "eine Änderung gilt ab dem nächsten Start"
    ),
    "other": Text("a fault that involves it", "ein Fehler, an dem er beteiligt ist"),
}


@dataclass(frozen=True, slots=True)
class ParameterNumber:
    """A number for a parameter; see the head of this file."""

    number: int
    id: str
    case: str
    found: str


@cache
def all_numbers() -> tuple[ParameterNumber, ...]:
    """Return the table."""
    text = (Path(__file__).parent.parent / "declared" / "numbers.tsv").read_text("utf-8")
    lines = [line.split("\t") for line in text.splitlines() if not line.startswith("#")]
    return tuple(ParameterNumber(int(number), *rest) for number, *rest in lines[1:])


@cache
def _by_id() -> dict[str, list[ParameterNumber]]:
    numbers: dict[str, list[ParameterNumber]] = {}
    for one in all_numbers():
        numbers.setdefault(one.id, []).append(one)
    return numbers


def numbers_of(parameter_id: str) -> tuple[ParameterNumber, ...]:
    """Return the numbers for a parameter."""
    return tuple(_by_id().get(parameter_id, ()))


def parameters_of(number: int) -> tuple[ParameterNumber, ...]:
    """Return the meaning of a number, for each of its parameters."""
    return tuple(one for one in all_numbers() if one.number == number)


def range_number(parameter: Parameter, value: float) -> int:
    """Return the number of a value outside the range of its parameter."""
    return bound_number(parameter.id, value, is_above=value > parameter.bounds[1])


def bound_number(parameter_id: str, value: float, *, is_above: bool) -> int:
    """Return the number for a value above or below the allowed range."""
    numbers: dict[str, int] = {}
    for one in numbers_of(parameter_id):
        if one.found == "list":
            numbers.setdefault(one.case, one.number)
    cases = ["high"] if is_above else ["low"]
    if value < 0.0:
        cases.insert(0, "negative")
    elif value == 0.0:
        cases.insert(0, "zero")
    cases.append("invalid")
    general = ABOVE if is_above else BELOW
    return next((numbers[case] for case in cases if case in numbers), general)
