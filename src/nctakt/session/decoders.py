# SPDX-License-Identifier: MIT
"""The decoder of a channel at a tick: its open programs, their variables, the parameters.

In: the decoder's modal state. Out: a ``DecoderState`` that can travel between processes. The
decoder works ahead of the path: its state is later in the program than the current block.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NoReturn

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Message, Span
from nctakt.decoder.state.environment import DecoderEnvironment
from nctakt.decoder.state.modal_state import ModalState
from nctakt.decoder.state.program_variables import ProgramVariable, Scopes, Variables
from nctakt.decoder.values.system_values import SystemValues
from nctakt.nc.tree import PARAMETER_ARRAYS, Expression
from nctakt.nc.vocabulary.variables.resolution import name_of

#: Elements of an array that are shown.
MAX_ELEMENTS = 1000


@dataclass(frozen=True, slots=True)
class DecoderVariable:
    """A variable of a program: the first of its ``count`` elements, 1 without dimensions."""

    name: str
    type: str
    dimensions: tuple[int, ...]
    count: int
    values: tuple[float | str, ...]


@dataclass(frozen=True, slots=True)
class DecoderFrame:
    """A program that is open: its latest block, its V.L, its arguments @P1, @P2, … of a cycle."""

    name: str
    span: Span | None
    variables: tuple[DecoderVariable, ...]
    arguments: Mapping[int, float | str]


@dataclass(frozen=True, slots=True)
class DecoderState:
    """The decoder of a channel; ``frames`` from the main program on.

    ``program``: V.P and arrays of P parameters, ``kept``: V.S, ``cycle``: V.CYC of the innermost
    cycle, ``parameters``: P1 …,
    ``system``: V.G and V.A as the decoder would read them now.
    """

    channel: int
    frames: tuple[DecoderFrame, ...]
    program: tuple[DecoderVariable, ...]
    kept: tuple[DecoderVariable, ...]
    cycle: tuple[DecoderVariable, ...]
    parameters: Mapping[int, float]
    system: tuple[DecoderVariable, ...]


def decoder_state(channel: int, state: ModalState, environment: DecoderEnvironment) -> DecoderState:
    """Return the visible state of a decoder."""
    stack = state.call_stack
    scopes = stack.scopes
    local = scopes.scopes_of("L")[::-1]
    frames = tuple(
        DecoderFrame(frame.name, frame.current, _shown("L", variables), dict(frame.arguments or {}))
        for frame, variables in zip(stack.frames, local, strict=True)
    )
    return DecoderState(
        channel,
        frames,
        _innermost("P", scopes) + _innermost(PARAMETER_ARRAYS, scopes),
        _innermost("S", scopes),
        _innermost("CYC", scopes),
        dict(sorted(state.parameters.items())),
        tuple(_system(state, environment)),
    )


def _system(state: ModalState, environment: DecoderEnvironment) -> Iterator[DecoderVariable]:
    """Yield V.G and V.A."""
    for row, axis, value in SystemValues(environment, state, _fail, _no_index).present():
        name = f"V.{row.family}.{row.path}"
        yield DecoderVariable(f"{name}.{axis}" if axis else name, row.type, (), 1, (value,))


def _fail(message: Message, span: Span | None, **values: object) -> NoReturn:
    """Raise: a value that is only looked at has no mistakes."""
    raise AssertionError(message)


def _no_index(index: Expression) -> float:
    """Raise: a variable that is only inspected has no index."""
    raise AssertionError(index)


def _innermost(family: str, scopes: Scopes) -> tuple[DecoderVariable, ...]:
    """Return the variables of the innermost scope of a family."""
    own = scopes.scopes_of(family)
    return _shown(family, own[0]) if own else ()


def _shown(family: str, variables: Variables) -> tuple[DecoderVariable, ...]:
    return tuple(_one(name_of(family, path), variable) for path, variable in variables.items())


def _one(name: str, variable: ProgramVariable) -> DecoderVariable:
    count = len(variable.values)
    values = tuple(variable.values[:MAX_ELEMENTS])
    return DecoderVariable(name, variable.type, variable.dimensions, count, values)
