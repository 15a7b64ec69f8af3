# SPDX-License-Identifier: MIT
"""The stack of open structures, and the destinations of statements and mistakes.

In: opened and closed structures, statements, mistakes. Out: finished statements in ``ready`` and
diagnostics in the collector. Rules of recovery: a closing word closes the nearest structure that it
fits; open structures above that are reported and closed as well; a closing word that fits nothing
is reported and has no effect.
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.diagnostics import Message, Span
from nctakt.messages import Collector
from nctakt.messages.path.backward import RT_WHILE_WITHOUT_END
from nctakt.messages.programs.nc_text import (
    CYCLE_BEGIN_END_MISMATCH,
    STATEMENT_BEFORE_CASE,
    STRUCTURE_NOT_CLOSED,
    STRUCTURES_NESTED_TOO_DEEP,
    TEXT_AFTER_PROGRAM_END,
)
from nctakt.nc.parse.lexer import BlockError, BlockText
from nctakt.nc.parse.open_structures import CycleFrame, Frame, LoopFrame, SwitchFrame
from nctakt.nc.tree import Head, Statement, Unreadable

#: State of a stack without open structures: whether the program has ended, whether that was
#: warned of, and the surplus ends of realtime cycles that are tolerated.
StackState = tuple[bool, bool, int]

#: Maximum nesting of structures. Functions that walk the tree may recurse that deep.
STRUCTURE_DEPTH = 100


class StructureStack:
    """The stack of open structures; ``ready``: finished statements outside of any structure."""

    def __init__(self, collector: Collector) -> None:
        self.ready: list[Statement] = []
        self._stack: list[Frame] = []
        self._collector = collector
        #: After a program end mistakes are tolerated: the rest may not be NC text.
        self._ended = False
        self._warned_of_rest = False
        #: Surplus ends of realtime cycles to be tolerated.
        self._forgiven_ends = 0

    @property
    def top(self) -> Frame | None:
        """The innermost open structure."""
        return self._stack[-1] if self._stack else None

    @property
    def state(self) -> StackState:
        """State that later statements depend on while no structure is open."""
        assert not self._stack
        return self._ended, self._warned_of_rest, self._forgiven_ends

    def resume(self, state: StackState) -> None:
        """Continue from a state."""
        self._ended, self._warned_of_rest, self._forgiven_ends = state

    # --- statements ------------------------------------------------------------------------------

    def add(self, statement: Statement) -> None:
        """Add a statement to the open branch, or to ``ready`` if nothing is open."""
        if not self._stack:
            self.ready.append(statement)
        else:
            self._stack[-1].body.append(statement)

    def add_block(self, statement: Statement, text: BlockText) -> None:
        """Add a statement that is not a structure; not allowed between ``$SWITCH`` and
        ``$CASE``.
        """
        self._check_case(statement.span, text.source_line(statement.span))
        self.add(statement)

    def _check_case(self, span: Span, line: str) -> None:
        """Report the first statement between ``$SWITCH`` and ``$CASE``."""
        top = self.top
        if isinstance(top, SwitchFrame) and not top.cases and not top.body:
            self.report(STATEMENT_BEFORE_CASE, span, line)

    def add_unreadable(self, text: BlockText, head: Head, error: BlockError) -> None:
        """Report why a block could not be read, and add it as ``Unreadable``."""
        self.block_error(text, error)
        content = text.text.strip()
        start = text.text.index(content) if content else 0
        span = text.span(start, start + len(content))
        self.add(Unreadable(span, head, content))

    def end_program(self) -> None:
        """Note a program end; later blocks run only if a jump leads there."""
        self._ended = not self._stack

    def begin_program(self) -> None:
        """Close all structures at a ``%`` line; mistakes are reported again."""
        self.close_all()
        self._ended = self._warned_of_rest = False

    # --- mistakes --------------------------------------------------------------------------------

    def block_error(self, text: BlockText, error: BlockError) -> None:
        """Report why a block could not be read, unless it can never run."""
        if self._stack and (self._stack[-1].is_unreachable or self._stack[-1].inside_unreachable):
            return
        span = error.span or text.span(error.start, error.end)
        self.report(error.message, span, text.source_line(span), **error.values)

    def report(self, message: Message, span: Span, line: str, **values: object) -> None:
        """Report a mistake; after a program end one warning replaces all reports."""
        if not self._ended:
            self._collector.report(message, span, line, **values)
        elif not self._warned_of_rest:
            self._warned_of_rest = True
            self._collector.report(TEXT_AFTER_PROGRAM_END, span, line)

    # --- structures ------------------------------------------------------------------------------

    def open(self, frame: Frame) -> None:
        """Open a structure; report it if the nesting is too deep."""
        if self._stack:
            frame.inside_unreachable = (
                self._stack[-1].is_unreachable or self._stack[-1].inside_unreachable
            )
        self._stack.append(frame)
        if len(self._stack) == STRUCTURE_DEPTH + 1:
            opening = frame.opening
            self.report(
                STRUCTURES_NESTED_TOO_DEEP,
                opening.span,
                opening.line,
                limit=STRUCTURE_DEPTH,
                begin=opening.begin,
            )

    def find(self, fits: Callable[[Frame], bool]) -> Frame | None:
        """Return the innermost structure that fits; report and close those inside it."""
        index = self._index(fits)
        if index is None:
            return None
        while len(self._stack) > index + 1:
            self.give_up()
        return self._stack[index]

    def _index(self, fits: Callable[[Frame], bool]) -> int | None:
        """Return the index of the innermost structure that fits, within the allowed depth."""
        last = len(self._stack) - 1
        for index in range(last, max(-1, last - 2 * STRUCTURE_DEPTH), -1):
            if fits(self._stack[index]):
                return index
        return None

    def close(self, frame: Frame) -> None:
        """Close the innermost structure; one nested too deep leaves no node."""
        assert frame is self._stack[-1]
        self._stack.pop()
        if len(self._stack) < STRUCTURE_DEPTH:
            self._check_case(frame.opening.span, frame.opening.line)
            self.add(frame.finish())
            if isinstance(frame, SwitchFrame):
                for statement in frame.before_cases:
                    self.add(statement)

    def give_up(self) -> None:
        """Report that the innermost structure lacks its end, and close it.

        Statements after a realtime cycle whose end is missing, too, are not part of it.
        """
        frame = self._stack[-1]
        opening = frame.opening
        outside: list[Statement] = []
        if isinstance(frame, CycleFrame):
            outside = frame.take_foreign()
            if not frame.reported:
                self.report(
                    CYCLE_BEGIN_END_MISMATCH, opening.span, opening.line, found=opening.begin
                )
                self.expect_stray_cycle_end()
        elif isinstance(frame, LoopFrame):
            outside, frame.body = frame.body, []
            self.report(RT_WHILE_WITHOUT_END, opening.span, opening.line)
        else:
            if self._index(_is_cycle) is not None:
                outside = frame.take_foreign()
            self.report(
                STRUCTURE_NOT_CLOSED,
                opening.span,
                opening.line,
                begin=opening.begin,
                end=opening.end,
            )
        self.close(frame)
        for statement in outside:
            self.add(statement)

    def close_all(self) -> None:
        """Close all structures at the end of a program, reporting each."""
        while self._stack:
            self.give_up()

    def forgive_cycle_end(self) -> bool:
        """Return whether a surplus ``#RT CYCLE END`` belongs to a cycle reported before."""
        if not self._forgiven_ends:
            return False
        self._forgiven_ends -= 1
        return True

    def expect_stray_cycle_end(self) -> None:
        """Expect one surplus ``#RT CYCLE END``, whose cycle has been reported."""
        self._forgiven_ends += 1

    def close_cycle_before(self, span: Span, line: str) -> None:
        """Report an open cycle when a definition begins (22005): its own start, if it ends there.

        Inside an open ``$IF`` of the cycle it is the definition that is wrong.
        """
        index = self._index(_is_cycle)
        if index is None:
            return
        cycle = self._stack[index]
        assert isinstance(cycle, CycleFrame)
        if cycle is self.top:
            # Most likely its end was forgotten; if not, the surplus end is tolerated.
            self.give_up()
            return
        self.report(CYCLE_BEGIN_END_MISMATCH, span, line, found="#RT CYCLE")
        cycle.reported = True


def _is_cycle(frame: Frame) -> bool:
    return isinstance(frame, CycleFrame)
