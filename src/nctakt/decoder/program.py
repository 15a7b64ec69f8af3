# SPDX-License-Identifier: MIT
"""Walks a checked program: blocks, flow control, ``#`` commands -> commands (RC-109).

A generator of commands that waits by yielding: a command that ``waits`` gets its answer back from
``yield``. Mistakes that only values show are a ``DecodeError``.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import Literal

from nctakt.decoder.commands import (
    CONTROL_ACTIONS,
    Answer,
    Command,
    CycleControl,
    Flush,
    Freeze,
    LoadCycle,
    PositionRequest,
    ProgramEnd,
    UserMessage,
)
from nctakt.decoder.cycles import SCOPES, CycleBuilder, CycleDefinition
from nctakt.decoder.state import ModalState
from nctakt.decoder.surroundings import Surroundings
from nctakt.decoder.texts import FormatError, format_text
from nctakt.decoder.values import Values
from nctakt.decoder.words import Words
from nctakt.kernel import arithmetic
from nctakt.kernel.cycles import BLOCK, GLOBAL, PROG
from nctakt.messages import diagnostic
from nctakt.nc import syntax

#: What a statement list says to the structure around it.
Signal = Literal["", "break", "continue", "end"]
Decoded = Generator[Command, Answer, Signal]

#: Blocks that may be decoded in a row without one that takes time (a loop that never moves).
MOST_BLOCKS_WITHOUT_TIME = 100_000

#: The words of the command that waits for functions of the type MVS_SLP.
EXPLICIT = ["EXPL", "SYN"]

_SCOPE_NAMES = {BLOCK: "BLOCK", PROG: "PROG", GLOBAL: "GLOBAL"}


class ProgramDecoder:
    """Decodes one main program.

    ``number_cycle`` gives each cycle definition its serial number and its first probe, and keeps
    what was built.
    """

    def __init__(
        self,
        surroundings: Surroundings,
        state: ModalState,
        next_cycle: Callable[[], tuple[int, int]],
        keep_cycle: Callable[[CycleDefinition], None],
    ) -> None:
        self._surroundings = surroundings
        self._state = state
        self._values = Values(surroundings, state)
        self._words = Words(self._values)
        self._next_cycle = next_cycle
        self._keep_cycle = keep_cycle
        self._blocks = 0

    def decode(self, program: syntax.Program) -> Generator[Command, Answer]:
        """The commands of the main program, the last one its end."""
        yield from self._statements(program.statements)
        yield ProgramEnd(0, 0)

    def took_time(self) -> None:
        """The one who takes the commands has seen one that takes time."""
        self._blocks = 0

    # --- statements -----------------------------------------------------------------------------

    def _statements(self, statements: Sequence[syntax.Statement]) -> Decoded:
        for statement in statements:
            signal = yield from self._statement(statement)
            if signal:
                return signal
        return ""

    def _statement(self, statement: syntax.Statement) -> Decoded:
        self._blocks += 1
        if self._blocks > MOST_BLOCKS_WITHOUT_TIME:
            self._values.fail(900303, statement.span, count=MOST_BLOCKS_WITHOUT_TIME)
        number = yield from self._number(statement.head)
        match statement:
            case syntax.Block():
                ends = yield from self._words.block(statement, number)
                return "end" if ends else ""
            case syntax.Assignment():
                yield from self._values.assign(statement, number)
            case syntax.VariableBlock():
                yield from self._values.evaluate_any(statement.variable, number)
            case syntax.Break():
                return "break"
            case syntax.Continue():
                return "continue"
            case syntax.If() | syntax.For() | syntax.While() | syntax.Do() | syntax.Repeat():
                return (yield from self._structure(statement, number))
            case syntax.Switch():
                return (yield from self._switch(statement, number))
            case _:
                yield from self._command(statement, number)
        return ""

    def _number(self, head: syntax.Head) -> Generator[Command, Answer, int]:
        if head.number is None:
            return 0
        value = yield from self._values.evaluate(head.number, 0)
        return int(arithmetic.round_half_even(value))

    # --- flow control ---------------------------------------------------------------------------

    def _truth(self, condition: syntax.Expression, number: int) -> Generator[Command, Answer, bool]:
        value = yield from self._values.evaluate(condition, number)
        return arithmetic.is_true(value)

    def _structure(self, statement: syntax.Statement, number: int) -> Decoded:
        match statement:
            case syntax.If():
                return (yield from self._if(statement, number))
            case syntax.For():
                return (yield from self._for(statement, number))
            case syntax.While():
                while (yield from self._truth(statement.condition, number)):
                    signal = yield from self._round(statement)
                    if signal == "break":
                        break
                    if signal == "end":
                        return signal
            case syntax.Do() | syntax.Repeat():
                return (yield from self._do(statement, number))
        return ""

    def _round(self, loop: syntax.While | syntax.Do | syntax.Repeat | syntax.For) -> Decoded:
        """One run through a loop's body; counts, so that a loop without blocks ends, too."""
        self._blocks += 1
        if self._blocks > MOST_BLOCKS_WITHOUT_TIME:
            self._values.fail(900303, loop.span, count=MOST_BLOCKS_WITHOUT_TIME)
        return (yield from self._statements(loop.body))

    def _do(self, loop: syntax.Do | syntax.Repeat, number: int) -> Decoded:
        """``$DO`` goes on while its condition holds, ``$REPEAT`` until it does."""
        while True:
            signal = yield from self._round(loop)
            if signal == "end":
                return signal
            if signal == "break":
                return ""
            holds = yield from self._truth(loop.condition, number)
            if holds == isinstance(loop, syntax.Repeat):
                return ""

    def _if(self, statement: syntax.If, number: int) -> Decoded:
        if (yield from self._truth(statement.condition, number)):
            return (yield from self._statements(statement.body))
        for elseif in statement.elseifs:
            if (yield from self._truth(elseif.condition, number)):
                return (yield from self._statements(elseif.body))
        if statement.else_body is not None:
            return (yield from self._statements(statement.else_body))
        return ""

    def _for(self, loop: syntax.For, number: int) -> Decoded:
        """``$FOR``: the end value included; a negative step counts down."""
        values = self._values
        value = yield from values.evaluate(loop.start, number)
        yield from values.store(loop.variable, value, number)
        end = yield from values.evaluate(loop.end, number)
        step = yield from values.evaluate(loop.step, number)
        if step == 0.0:
            line = self._surroundings.line(loop.step.span)
            self._surroundings.notice(diagnostic(900302, loop.step.span, line))
        while True:
            value = yield from values.evaluate(loop.variable, number)
            if (value > end) if step >= 0.0 else (value < end):
                return ""
            signal = yield from self._round(loop)
            if signal == "end":
                return signal
            if signal == "break":
                return ""
            value = yield from values.evaluate(loop.variable, number)
            yield from values.store(loop.variable, value + step, number)

    def _switch(self, switch: syntax.Switch, number: int) -> Decoded:
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
        for case in switch.cases[chosen:]:
            signal = yield from self._statements(case.body)
            if signal == "break":
                return ""
            if signal:
                return signal
        return ""

    # --- commands -------------------------------------------------------------------------------

    def _command(self, statement: syntax.Statement, number: int) -> Generator[Command, Answer]:
        source = self._surroundings.place(statement.span)
        match statement:
            case syntax.RealtimeCycle():
                yield from self._define(statement, source, number)
            case syntax.CycleControl():
                yield from self._control(statement, source, number)
            case syntax.Flush():
                if statement.mode != "CONTINUE":
                    yield Flush(source, number, statement.mode == "WAIT")
            case syntax.Time():
                seconds = yield from self._values.evaluate(statement.seconds, number)
                yield from self._words.dwell(seconds, statement.span, number)
            case syntax.UserMessage():
                yield from self._message(statement, source, number)
            case syntax.HashCommand() if [word.name for word in statement.words] == EXPLICIT:
                yield from self._words.technology.explicit(number)
            case syntax.ProgramStart() | syntax.HashCommand():
                pass  # the checker lets only those pass that have no effect
            case _:
                raise AssertionError(statement)

    def _define(
        self, statement: syntax.RealtimeCycle, source: int, number: int
    ) -> Generator[Command, Answer]:
        identity = yield from self._identity(statement, number)
        scope_word = _keyword(statement.keywords, "SCOPE")
        scope = PROG if scope_word is None else SCOPES[_word(scope_word)]
        if scope == GLOBAL and identity is not None and identity < 1:
            self._values.fail(21983, statement.span, id=identity)
        if identity is not None and identity < 1:
            self._values.fail(50875, statement.span, id=identity)
        serial, first_probe = self._next_cycle()
        builder = CycleBuilder(self._values, first_probe)
        built = builder.build(statement, serial, identity or 0, _SCOPE_NAMES[scope])
        self._keep_cycle(built)
        yield LoadCycle(
            source, number, built.cycle, built.identity, scope, statement.definition_only
        )
        for one in built.frozen:
            place = self._surroundings.place(one.span)
            yield Freeze(place, number, serial, one.name, one.value)

    def _control(
        self, statement: syntax.CycleControl, source: int, number: int
    ) -> Generator[Command, Answer]:
        identity = yield from self._identity(statement, number)
        assert identity is not None
        if identity < 1:
            self._values.fail(50875, statement.span, id=identity)
        yield CycleControl(source, number, CONTROL_ACTIONS[statement.action], identity)
        if statement.action == "DELETE":
            answer = yield PositionRequest(source, number)
            assert isinstance(answer, tuple)
            self._state.positions = list(answer)

    def _identity(
        self, statement: syntax.RealtimeCycle | syntax.CycleControl, number: int
    ) -> Generator[Command, Answer, int | None]:
        keyword = _keyword(statement.keywords, "ID")
        if keyword is None or keyword.value is None:
            return None
        value = yield from self._values.evaluate(keyword.value, number)
        if arithmetic.floor(value) != value:
            self._values.fail(50875, keyword.value.span, id=value)
        return int(value)

    def _message(
        self, statement: syntax.UserMessage, source: int, number: int
    ) -> Generator[Command, Answer]:
        assert isinstance(statement.format, syntax.StringLiteral)
        values: list[float | str] = []
        for argument in statement.arguments:
            values.append((yield from self._values.evaluate_any(argument, number)))
        try:
            text = format_text(statement.format.value, values)
        except FormatError as error:
            self._values.fail(900304, statement.format.span, found=str(error))
        options = [option.name for option in statement.options]
        yield UserMessage(source, number, text, "EXCLUSIVE" in options, "CONTINUE" in options)


def _keyword(
    keywords: Sequence[syntax.Keyword | syntax.Expression], name: str
) -> syntax.Keyword | None:
    for keyword in keywords:
        if isinstance(keyword, syntax.Keyword) and keyword.name == name:
            return keyword
    return None


def _word(keyword: syntax.Keyword) -> str:
    assert isinstance(keyword.value, syntax.Name)
    return keyword.value.name
