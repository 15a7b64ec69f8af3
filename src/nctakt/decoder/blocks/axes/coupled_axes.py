# SPDX-License-Identifier: MIT
"""Checks of what a program may not do with axes that follow others (``#AX LINK``)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nctakt.base.diagnostics import Span
from nctakt.decoder.values.variables import Values
from nctakt.messages.axes.couplings import NOT_WHILE_COUPLED, SLAVE_OUTSIDE_LIMITS, SLAVE_PROGRAMMED
from nctakt.nc import tree


def check_words(values: Values, words: Iterable[tree.AxisWord | tree.BracketCommand]) -> None:
    """Raise ``DecodeError`` if a word programs a slave."""
    for word in words:
        slot = values.environment.axis_numbers[word.name]
        _fail_if_slave(values, slot, word.span)


def check_travel(
    values: Values, start: Sequence[float], target: Sequence[float], span: Span
) -> None:
    """Raise ``DecodeError`` if a block moves a slave, however it got into the block."""
    for pair in values.state.couplings.of_axes:
        if start[pair.slave] != target[pair.slave]:
            _fail_if_slave(values, pair.slave, span)


def _fail_if_slave(values: Values, slot: int, span: Span) -> None:
    master = values.state.couplings.master_of(slot)
    if master >= 0:
        names = values.environment.places.names
        values.fail(SLAVE_PROGRAMMED, span, axis=names[slot], master=names[master])


def check_slaves(values: Values, master: int, position: float, span: Span) -> None:
    """Raise ``DecodeError`` if a slave leaves its software limits with its master at a position."""
    environment, state = values.environment, values.state
    for pair in state.couplings.of_axes:
        axis = environment.axes[pair.slave]
        if pair.master != master or axis.is_modulo:
            continue
        low, high = state.software_limits.of(axis, pair.slave)
        follows = pair.position(position)
        if not low <= follows <= high:
            names = environment.places.names
            values.fail(
                SLAVE_OUTSIDE_LIMITS,
                span,
                slave=names[pair.slave],
                master=names[master],
                position=follows,
                low=low,
                high=high,
            )


def check_uncoupled(values: Values, command: str, span: Span) -> None:
    """Raise ``DecodeError`` while axes are coupled."""
    if values.state.couplings.of_axes:
        values.fail(NOT_WHILE_COUPLED, span, command=command, other="#AX LINK")
