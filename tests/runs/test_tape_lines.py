# SPDX-License-Identifier: MIT
"""Inputs -> lines of a tape -> the same inputs."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nctakt.run.access.input_words import API, WRITE
from nctakt.run.access.inputs import ACKNOWLEDGE, AXIS, PLC, Cells, Input
from nctakt.run.access.tape_lines import InputLines, inputs_of


def cells_of(inputs: list[Input]) -> Cells:
    cells: Cells = []
    for tick, source, kind, values in inputs:
        cells += (tick, source, kind, *(values if kind == WRITE else (values, None)))
    return cells


def written(inputs: list[Input], parts: int = 1) -> list[str]:
    """Return the lines of inputs that come in this many parts."""
    lines: list[str] = []
    writer = InputLines(lines.append)
    size = -(-len(inputs) // parts) or 1
    for begin in range(0, len(inputs), size):
        writer.note(cells_of(inputs[begin : begin + size]))
    writer.flush()
    return lines


def read(lines: list[str]) -> list[Input]:
    found: list[Input] = []
    for line in lines:
        inputs = inputs_of(json.loads(line))
        assert not isinstance(inputs, str), inputs
        found += inputs
    return found


def test_tick_after_tick_of_the_same_variables_is_one_line() -> None:
    inputs = [
        Input(tick, PLC, WRITE, (name, value))
        for tick in range(3, 6)
        for name, value in (("V.E.A", float(tick)), ("V.E.B", -0.0))
    ]
    assert written(inputs) == [
        '{"tick":3,"each":[["plc","write","V.E.A"],["plc","write","V.E.B"]],'
        '"values":[3.0,-0.0,4.0,-0.0,5.0,-0.0]}\n'
    ]


def test_other_variables_another_source_and_a_gap_begin_a_line() -> None:
    inputs = [
        Input(1, PLC, WRITE, ("V.E.A", 1.0)),
        Input(2, API, WRITE, ("V.E.A", 1.0)),
        Input(3, API, WRITE, ("V.E.B", 1.0)),
        Input(5, API, WRITE, ("V.E.B", 1.0)),
        Input(6, API, WRITE, ("V.E.B", 1.0)),
        Input(6, PLC, ACKNOWLEDGE, (0, True, 3, 17, "M100")),
    ]
    assert [json.loads(line)["tick"] for line in written(inputs)] == [1, 2, 3, 5, 6]
    assert read(written(inputs)) == inputs


_NAMES = st.sampled_from(["V.E.A", "V.E.B", "V.E.T"])
_VALUES = st.one_of(
    st.floats(allow_nan=False), st.sampled_from([0.0, -0.0, 1.0]), st.text(max_size=3)
)
_WRITES = st.tuples(st.sampled_from([PLC, API]), st.tuples(_NAMES, _VALUES)).map(
    lambda one: Input(0, one[0], WRITE, one[1])
)
_OTHERS = st.sampled_from(
    [
        Input(0, PLC, ACKNOWLEDGE, (0, True, 3, 17, "M100")),
        Input(0, PLC, AXIS, (1, 2, 3.5, 100.0, 0, 1)),
    ]
)


@given(
    st.lists(st.tuples(st.integers(0, 1), st.one_of(_WRITES, _WRITES, _OTHERS)), max_size=60),
    st.integers(1, 5),
)
def test_what_is_written_is_read_again(steps: list[tuple[int, Input]], parts: int) -> None:
    inputs: list[Input] = []
    tick = 0
    for step, one in steps:
        tick += step
        inputs.append(one._replace(tick=tick))
    found = read(written(inputs, parts))
    assert [repr(one) for one in found] == [repr(one) for one in inputs]  # -0.0 is not 0.0


@pytest.mark.parametrize(
    "entry",
    [
        {"tick": 1, "each": [], "values": [1.0]},
        {"tick": 1, "each": [["plc", "write", "V.E.A"]], "values": []},
        {"tick": 1, "each": [["plc", "write", "V.E.A"]]},
        {"tick": 1, "each": [["plc", "write", "V.E.A"]], "values": ["x"]},
        {"tick": 1, "each": [["plc", "write", "V.E.A"]], "values": [True]},
        {"tick": 1, "each": [["plc", "write", "V.E.A"]], "values": [float("inf")]},
        {"tick": 1, "each": [["plc", "ack", 1]], "values": [1.0]},
        {"tick": 1, "each": [["plc", "write", "V.E.A"], "x"], "values": [1.0, 1.0]},
        {"tick": 1, "each": [["plc", "write", "V.E.A"]] * 2, "values": [1.0]},
        {"tick": -1, "inputs": []},
        {"tick": True, "inputs": []},
        {"tick": 1},
        {"tick": 1, "inputs": [["plc", "write", "V.E.A", None]]},
    ],
)
def test_what_no_tape_has_is_reported(entry: dict[str, Any]) -> None:
    assert isinstance(inputs_of(entry), str)
