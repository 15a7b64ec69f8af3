# SPDX-License-Identifier: MIT
"""Control structures of the main program: conditions, loops, branches, and their exits.

In: structures of the tree. Out: the commands of the branches taken, and a ``Signal`` for the
enclosing structure. A jump leads up to its program, which restarts at the statement that holds the
label; that statement is entered here regardless of its conditions.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable
from typing import Literal

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.kernel.base import arithmetic
from nctakt.messages.programs.decoder import FOR_STEP_ZERO
from nctakt.nc import tree
from nctakt.nc.outline import bodies_of, leads_to


@dataclass(frozen=True, slots=True)
class Jump:
    """A jump to a label of the same program."""

    label: str
    span: Span


@dataclass(frozen=True, slots=True)
class Return:
    """A return over ``calls`` calls, ``None`` for all of them, continuing at a label if given."""

    calls: int | None
    label: str | None
    span: Span


#: Results of statements for the enclosing structure; empty: continue.
Signal = Literal["", "break", "continue", "end"] | Jump | Return
Decoding = Generator[Command, Answer, Signal]

Structure = tree.If | tree.For | tree.While | tree.Do | tree.Repeat | tree.Switch


class Flow:
    """Decodes structures; ``run`` decodes statements, ``count`` counts a pass of a loop."""

    def __init__(
        self,
        values: Values,
        run: Callable[[Iterable[tree.Statement], str | None], Decoding],
        count: Callable[[Span], None],
    ) -> None:
        self._values = values
        self._run = run
        self._count = count

    def structure(self, statement: Structure, number: int) -> Decoding:
        """Decode a structure; ``number``: the N word of its first line."""
        match statement:
            case tree.If():
                return (yield from self._if(statement, number))
            case tree.For():
                return (yield from self._for(statement, number))
            case tree.While():
                return (yield from self._while(statement, number))
            case tree.Do() | tree.Repeat():
                return (yield from self._do(statement, number))
            case tree.Switch():
                return (yield from self._switch(statement, number))

    def enter(self, statement: tree.Statement, label: str) -> Decoding:
        """Decode a structure from a label inside it on, regardless of its conditions."""
        bodies = list(bodies_of(statement))
        first = next(i for i, body in enumerate(bodies) if any(leads_to(s, label) for s in body))
        signal = yield from self._run(bodies[first], label)
        if isinstance(statement, tree.Switch):
            return (yield from self._fall_through(signal, bodies[first + 1 :]))
        return signal

    def _truth(self, condition: tree.Expression, number: int) -> Generator[Command, Answer, bool]:
        value = self._values.constant_value(condition)
        if value is None:
            value = yield from self._values.evaluate(condition, number)
        return arithmetic.is_true(value)

    def _if(self, statement: tree.If, number: int) -> Decoding:
        if (yield from self._truth(statement.condition, number)):
            return (yield from self._run(statement.body, None))
        for elseif in statement.elseifs:
            if (yield from self._truth(elseif.condition, number)):
                return (yield from self._run(elseif.body, None))
        if statement.else_body is not None:
            return (yield from self._run(statement.else_body, None))
        return ""

    # --- loops ----------------------------------------------------------------------------------

    def _run_pass(
        self, loop: tree.While | tree.Do | tree.Repeat | tree.For
    ) -> Generator[Command, Answer, tuple[bool, Signal]]:
        """One run through a loop's body: whether the loop continues, and its result if not."""
        self._count(loop.span)
        signal = yield from self._run(loop.body, None)
        if signal in ("", "continue"):
            return True, ""
        return False, "" if signal == "break" else signal

    def _while(self, loop: tree.While, number: int) -> Decoding:
        while (yield from self._truth(loop.condition, number)):
            continues, signal = yield from self._run_pass(loop)
            if not continues:
                return signal
        return ""

    def _do(self, loop: tree.Do | tree.Repeat, number: int) -> Decoding:
        """Run ``$DO`` while its condition holds, ``$REPEAT`` until it does."""
        while True:
            continues, signal = yield from self._run_pass(loop)
            if not continues:
                return signal
            holds = yield from self._truth(loop.condition, number)
            if holds == isinstance(loop, tree.Repeat):
                return ""

    def _for(self, loop: tree.For, number: int) -> Decoding:
        """``$FOR``: the end value included; a negative step counts down."""
        values = self._values
        value = yield from values.evaluate(loop.start, number)
        yield from values.store(loop.variable, value, number)
        end = yield from values.evaluate(loop.end, number)
        step = yield from values.evaluate(loop.step, number)
        if step == 0.0:
            values.fail(FOR_STEP_ZERO, loop.step.span)
        while True:
            value = yield from values.evaluate(loop.variable, number)
            if (value > end) if step > 0.0 else (value < end):
                return ""
            continues, signal = yield from self._run_pass(loop)
            if not continues:
                return signal
            value = yield from values.evaluate(loop.variable, number)
            yield from values.store(loop.variable, value + step, number)

    # --- branches by value ----------------------------------------------------------------------

    def _switch(self, switch: tree.Switch, number: int) -> Decoding:
        """``$SWITCH``: from the first ``$CASE`` with the value on, until ``$BREAK``."""
        subject = yield from self._values.evaluate(switch.subject, number)
        chosen = None
        for index, case in enumerate(switch.cases):
            if case.value is None:
                continue
            value = yield from self._values.evaluate(case.value, number)
            if value == subject:
                chosen = index
                break
        if chosen is None:
            chosen = next((i for i, case in enumerate(switch.cases) if case.value is None), None)
        if chosen is None:
            return ""
        return (yield from self._fall_through("", list(bodies_of(switch))[chosen:]))

    def _fall_through(self, signal: Signal, bodies: list[tuple[tree.Statement, ...]]) -> Decoding:
        """Branch after branch, until one is left."""
        for body in bodies:
            if signal:
                break
            signal = yield from self._run(body, None)
        return "" if signal == "break" else signal
