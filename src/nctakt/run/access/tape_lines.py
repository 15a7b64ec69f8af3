# SPDX-License-Identifier: MIT
"""Inputs -> lines of a tape, and back.

In: inputs one by one, or the JSON object of a line. Out: a line for each tick with inputs. If the
same variables get numbers tick after tick, as from a PLC, one line has many ticks:

    {"tick":7,"each":[["plc","write","V.E.A"],["plc","write","V.E.B"]],"values":[0.0,5.5,1.0,5.5]}

has the values given to ``V.E.A`` and ``V.E.B`` in tick 7, then those of tick 8.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from math import isfinite
from typing import Any

from nctakt.run.access.input_words import WRITE
from nctakt.run.access.inputs import (
    ACKNOWLEDGE,
    ACKNOWLEDGE_SPINDLE,
    AXIS,
    DECODED,
    IMAGE,
    INPUT_WIDTH,
    LOST,
    OVERFLOWED,
    SELECT,
    Cells,
    Input,
    unpack,
)

#: Maximum count of numbers in one line, and of numbers whose texts are cached.
_MAX_NUMBERS = 4096

#: The types of the values of each kind of input.
_SHAPES: Mapping[str, tuple[tuple[type, ...], ...]] = {
    WRITE: ((str,), (float, int, str)),
    ACKNOWLEDGE: ((int,), (bool,), (int,), (int,), (str,)),
    ACKNOWLEDGE_SPINDLE: ((int,), (int,), (int,), (str,)),
    AXIS: ((int,), (int,), (float, int), (float, int), (int,), (int,)),
    IMAGE: ((str,), (str,)),
    SELECT: ((int,), (str,)),
    DECODED: ((int,), (int,)),
    OVERFLOWED: ((int,),),
    LOST: (),
}


def to_json(value: object) -> str:
    """Return a value as JSON in one line, without spaces."""
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


class InputLines:
    """Writes inputs as lines; ``flush`` writes those that wait.

    The pending part is a stretch of ticks before ``_next_tick`` in which the same variables,
    ``_names``, got numbers from the same ``_sources``.
    """

    def __init__(self, write: Callable[[str], Any]) -> None:
        self._write = write
        self._first_tick = 0
        self._next_tick = -1
        self._sources: list[str] = []
        self._names: list[str] = []
        self._numbers: list[str] = []
        self._texts: dict[float, str] = {}

    def note(self, cells: Cells) -> None:
        """Take inputs in the order of their arrival."""
        at = 0
        count = len(cells)
        while at < count:
            tick = cells[at]
            end = at
            width = 0
            are_numbers = True
            goes_on = tick == self._next_tick and len(self._numbers) < _MAX_NUMBERS
            while end < count and cells[end] == tick:
                value = cells[end + 4]
                if cells[end + 2] != WRITE or type(value) is not float or value - value != 0.0:
                    are_numbers = False
                elif goes_on:
                    goes_on = width < len(self._names) and (
                        cells[end + 3] == self._names[width]
                        and cells[end + 1] == self._sources[width]
                    )
                end += INPUT_WIDTH
                width += 1
            if not (are_numbers and goes_on and width == len(self._names)):
                self.flush()
                self._begin(cells, at, end)
            if are_numbers:
                for cell in range(at + 4, end, INPUT_WIDTH):
                    self._numbers.append(self._text_of(cells[cell]))
                self._next_tick = tick + 1
            else:
                self._write_tick(tick, unpack(cells[at:end]))
            at = end

    def _begin(self, cells: Cells, at: int, end: int) -> None:
        """Let a stretch begin with a tick."""
        self._first_tick = cells[at]
        self._sources = cells[at + 1 : end : INPUT_WIDTH]
        self._names = cells[at + 3 : end : INPUT_WIDTH]

    def flush(self) -> None:
        """Write the stretch that waits."""
        if not self._numbers:
            return
        heads = [
            [source, WRITE, name] for source, name in zip(self._sources, self._names, strict=True)
        ]
        if len(self._numbers) > len(heads):
            line = f'"each":{to_json(heads)},"values":[{",".join(self._numbers)}]'
        else:
            pairs = zip(heads, self._numbers, strict=True)
            found = [to_json(head).removesuffix("]") + f",{text}]" for head, text in pairs]
            line = f'"inputs":[{",".join(found)}]'
        self._write(f'{{"tick":{self._first_tick},{line}}}\n')
        self._numbers.clear()

    def _write_tick(self, tick: int, inputs: Sequence[Input]) -> None:
        found = [[one.source, one.kind, *one.values] for one in inputs]
        self._write(f'{{"tick":{tick},"inputs":{to_json(found)}}}\n')
        self._next_tick = -1

    def _text_of(self, number: float) -> str:
        """Return a number without loss; those of a PLC repeat themselves, so texts are kept."""
        text = self._texts.get(number) if number else None  # a dictionary takes -0.0 for 0.0
        if text is None:
            if len(self._texts) >= _MAX_NUMBERS:
                self._texts.clear()
            text = self._texts[number] = repr(number)
        return text


def inputs_of(entry: Mapping[str, Any]) -> list[Input] | str:
    """Return the inputs of a line, or the mistake in it."""
    tick = entry.get("tick")
    if not isinstance(tick, int) or isinstance(tick, bool) or tick < 0:
        return "no tick"
    if "each" in entry:
        return _stretch(tick, entry["each"], entry.get("values"))
    arrived = entry.get("inputs")
    if not isinstance(arrived, list):
        return "neither inputs nor events"
    found = []
    for one in arrived:
        if not _is_input(one):
            return f"no input: {one}"
        found.append(Input(tick, one[0], one[1], tuple(one[2:])))
    return found


def _stretch(tick: int, heads: Any, values: Any) -> list[Input] | str:
    """Return the inputs of a stretch of ticks, or the mistake in it."""
    if not isinstance(heads, list) or not heads or not isinstance(values, list):
        return "no stretch of inputs"
    if not values or len(values) % len(heads):
        return f"{len(values)} values for {len(heads)} variables"
    if not all(type(value) is float and isfinite(value) for value in values):
        return "values that are no numbers"
    for head in heads:
        if not isinstance(head, list) or len(head) != 3 or not _is_input([*head, 0.0]):
            return f"no input: {head}"
    found = []
    for index, value in enumerate(values):
        ticks, number = divmod(index, len(heads))
        source, kind, name = heads[number]
        found.append(Input(tick + ticks, source, kind, (name, value)))
    return found


def _is_input(value: Any) -> bool:
    """Return whether a list of JSON is source, kind and the values of that kind."""
    if not isinstance(value, list) or len(value) < 2 or not isinstance(value[0], str):
        return False
    shape = _SHAPES.get(value[1]) if isinstance(value[1], str) else None
    if shape is None or len(value) != 2 + len(shape):
        return False
    return all(
        isinstance(one, types) and (bool in types or not isinstance(one, bool))
        for one, types in zip(value[2:], shape, strict=True)
    )
