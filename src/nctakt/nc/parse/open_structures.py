# SPDX-License-Identifier: MIT
"""Open structures of the parser.

A frame represents one open structure: it collects the statements inside it and becomes a node when
it is closed. A stack of frames replaces recursion, so that nothing overflows. A frame without its
end becomes a node as well, so that its content is checked, too.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.nc.parse.expressions import Item
from nctakt.nc.tree import (
    Assignment,
    AxisWord,
    Block,
    Case,
    Constant,
    Declaration,
    Do,
    ElseIf,
    Expression,
    For,
    Frequency,
    HashCommand,
    Head,
    If,
    Number,
    Parameter,
    RealtimeCycle,
    RealtimeLoop,
    Repeat,
    Statement,
    Switch,
    Timer,
    Unreadable,
    UserError,
    Variable,
    VariableBlock,
    VariableDeclarations,
    While,
    Word,
)
from nctakt.nc.vocabulary.functions import ENDS

#: Words of blocks and commands that distinguish the program from the body of a realtime cycle.
_PATH_WORDS = ("G", "F", "T", "D", "S")
_CYCLE_COMMANDS = ("TIMER", "ERROR")


@dataclass(slots=True)
class Opening:
    """The block that opens a structure: begin and end words for messages, span, whole line."""

    begin: str
    end: str
    span: Span
    line: str
    head: Head


@dataclass(slots=True)
class Frame:
    """An open structure; ``body`` collects the statements of the open branch.

    ``inside_unreachable``: the enclosing branch can never run.
    """

    opening: Opening
    body: list[Statement] = field(default_factory=list)
    inside_unreachable: bool = False

    @property
    def is_unreachable(self) -> bool:
        """Whether the open branch can never run, so that it need not be NC text."""
        return False

    def take_foreign(self) -> list[Statement]:
        """Remove and return the statements after a realtime cycle whose end was forgotten.

        That begins with the first statement that no realtime cycle can have.
        """
        count = next(
            (index for index, one in enumerate(self.body) if _is_foreign(one)), len(self.body)
        )
        foreign = self.body[count:]
        del self.body[count:]
        return foreign

    def finish(self) -> Statement:
        """Return the node of the structure."""
        raise AssertionError(self.opening.begin)


def is_false(condition: Expression) -> bool:
    """Return whether a condition is constant and false."""
    if isinstance(condition, Number):
        return abs(condition.value) < 0.5
    return isinstance(condition, Constant) and condition.name == "FALSE"


@dataclass(slots=True)
class _Branch:
    span: Span
    head: Head
    frequency: Frequency | None
    condition: Expression
    body: list[Statement]


class IfFrame(Frame):
    """``$IF`` and ``#IF`` with their branches."""

    __slots__ = ("branches", "else_body", "else_span", "preprocessor")

    def __init__(
        self,
        opening: Opening,
        frequency: Frequency | None,
        condition: Expression,
        *,
        preprocessor: bool,
    ) -> None:
        super().__init__(opening)
        self.preprocessor = preprocessor
        self.else_body: list[Statement] | None = None
        self.else_span: Span | None = None
        self.branches = [_Branch(opening.span, opening.head, frequency, condition, self.body)]

    @property
    def is_unreachable(self) -> bool:
        return self.else_body is None and is_false(self.branches[-1].condition)

    def add_branch(
        self, span: Span, head: Head, frequency: Frequency | None, condition: Expression
    ) -> None:
        """Begin an ``$ELSEIF``."""
        self.body = []
        self.branches.append(_Branch(span, head, frequency, condition, self.body))

    def add_else(self, span: Span) -> None:
        """Begin the ``$ELSE``."""
        self.body = self.else_body = []
        self.else_span = span

    def finish(self) -> If:
        first = self.branches[0]
        return If(
            first.span,
            first.head,
            first.frequency,
            first.condition,
            tuple(first.body),
            tuple(
                ElseIf(b.span, b.head, b.frequency, b.condition, tuple(b.body))
                for b in self.branches[1:]
            ),
            None if self.else_body is None else tuple(self.else_body),
            self.preprocessor,
            self.else_span,
        )


class SwitchFrame(Frame):
    """``$SWITCH`` with its ``$CASE`` and ``$DEFAULT`` branches."""

    __slots__ = ("before_cases", "cases", "subject")

    def __init__(self, opening: Opening, subject: Expression) -> None:
        super().__init__(opening)
        self.subject = subject
        #: Statements between it and the first branch, which must not be there.
        self.before_cases = self.body
        self.cases: list[tuple[Span, Head, Expression | None, list[Statement]]] = []

    def add_case(self, span: Span, head: Head, value: Expression | None) -> None:
        """Begin a branch."""
        self.body = []
        self.cases.append((span, head, value, self.body))

    def finish(self) -> Switch:
        cases = tuple(
            Case(span, head, value, tuple(body)) for span, head, value, body in self.cases
        )
        return Switch(self.opening.span, self.opening.head, self.subject, cases)


class ForFrame(Frame):
    """``$FOR``."""

    __slots__ = ("bounds", "variable")

    def __init__(
        self,
        opening: Opening,
        variable: Variable | Parameter,
        bounds: tuple[Expression, Expression, Expression],
    ) -> None:
        super().__init__(opening)
        self.variable = variable
        self.bounds = bounds

    def finish(self) -> For:
        opening = self.opening
        return For(opening.span, opening.head, self.variable, *self.bounds, tuple(self.body))


class WhileFrame(Frame):
    """``$WHILE``."""

    __slots__ = ("condition",)

    def __init__(self, opening: Opening, condition: Expression) -> None:
        super().__init__(opening)
        self.condition = condition

    @property
    def is_unreachable(self) -> bool:
        return is_false(self.condition)

    def finish(self) -> While:
        return While(self.opening.span, self.opening.head, self.condition, tuple(self.body))


class LoopFrame(Frame):
    """``#RT WHILE``."""

    __slots__ = ("modulo",)

    def __init__(self, opening: Opening) -> None:
        super().__init__(opening)
        self.modulo = False

    def finish(self) -> RealtimeLoop:
        return RealtimeLoop(self.opening.span, self.opening.head, self.modulo, tuple(self.body))


class _EndConditionFrame(Frame):
    """A loop with its condition at the end; false if the end is missing."""

    __slots__ = ("condition",)

    def __init__(self, opening: Opening) -> None:
        super().__init__(opening)
        self.condition: Expression = Constant(opening.span, "FALSE")


class DoFrame(_EndConditionFrame):
    """``$DO``."""

    __slots__ = ()

    def finish(self) -> Do:
        return Do(self.opening.span, self.opening.head, tuple(self.body), self.condition)


class RepeatFrame(_EndConditionFrame):
    """``$REPEAT``."""

    __slots__ = ()

    def finish(self) -> Repeat:
        return Repeat(self.opening.span, self.opening.head, tuple(self.body), self.condition)


class CycleFrame(Frame):
    """``#RT CYCLE``."""

    __slots__ = ("definition_only", "end_span", "keywords", "reported")

    def __init__(self, opening: Opening, *, definition_only: bool) -> None:
        super().__init__(opening)
        self.definition_only = definition_only
        self.keywords: tuple[Item, ...] = ()
        #: The span of its end; of its start until the end is found.
        self.end_span = opening.span
        #: Whether mismatched ends have been reported.
        self.reported = False

    def finish(self) -> RealtimeCycle:
        return RealtimeCycle(
            self.opening.span,
            self.opening.head,
            self.definition_only,
            self.keywords,
            tuple(self.body),
            self.end_span,
        )


def _is_foreign(statement: Statement) -> bool:
    """Return whether a statement shows that a realtime cycle has ended before it."""
    match statement:
        case Block():
            return any(
                isinstance(word, AxisWord)
                or (isinstance(word, Word) and (word.name in _PATH_WORDS or _is_end(word)))
                for word in statement.words
            )
        case Assignment():
            return isinstance(statement.target, Parameter)
        case HashCommand():
            return not (statement.words and statement.words[0].name in _CYCLE_COMMANDS)
        case If() | VariableBlock() | Timer() | UserError() | Unreadable():
            return False
    return True


def _is_end(word: Word) -> bool:
    return word.name == "M" and isinstance(word.value, Number) and word.value.value in ENDS


class VariablesFrame(Frame):
    """``#VAR``; ``failed_lines`` counts consecutive blocks that declare nothing."""

    __slots__ = ("declarations", "failed_lines")

    def __init__(self, opening: Opening) -> None:
        super().__init__(opening)
        self.declarations: list[Declaration] = []
        self.failed_lines = 0

    def finish(self) -> VariableDeclarations:
        return VariableDeclarations(self.opening.span, self.opening.head, tuple(self.declarations))
