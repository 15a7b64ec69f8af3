# SPDX-License-Identifier: MIT
"""The call stack: the main program and the subprograms that it has called.

In: calls and ends. Out: the innermost program with its text, its local variables and its arguments.
The number of frames is bounded, so that endless recursion is reported (``MAX_CALL_DEPTH``, a
choice).
"""

from __future__ import annotations

from collections.abc import Callable

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.program_variables import Scopes
from nctakt.nc.outline import ProgramText, Section

#: Maximum number of nested programs, including the main program.
MAX_CALL_DEPTH = 20

#: Maximum nesting of structures and calls over all frames.
MAX_NESTING = 120


@dataclass(slots=True)
class ModalCall:
    """A call repeated after each block (``after_each_block``) or after each block with a motion.

    ``frame``: the called program, ``span``: the span of the call. ``is_due``: a block has ended, in
    ``line``.
    """

    frame: CallFrame
    span: Span
    after_each_block: bool
    is_due: bool = False
    line: int = 0


@dataclass(frozen=True, slots=True)
class OpenCall:
    """A program that is open: its name, and where it is; ``None`` for the innermost one."""

    name: str
    span: Span | None


@dataclass(slots=True)
class CallFrame:
    """A program being decoded; ``arguments``: @P1, @P2, … of its cycle, ``None`` without a cycle.

    A subprogram called by a cycle uses the arguments of the cycle. ``current``: the span of its
    latest statement.
    """

    text: ProgramText
    section: Section
    arguments: dict[int, float | str] | None = None
    modal: ModalCall | None = None
    current: Span | None = None

    @property
    def name(self) -> str:
        """The name of a section, else of the file without its folders."""
        return self.section.name or self.text.source.file.replace("\\", "/").rsplit("/", 1)[-1]


@dataclass(slots=True)
class CallStack:
    """The frames from the main program on; ``scopes``: their variables.

    ``modal_count``: the number of frames with a modal call. ``path_number``: a number for ``path``,
    ``None`` until it is given one.
    """

    frames: list[CallFrame] = field(default_factory=list)
    modal_count: int = 0
    scopes: Scopes = field(default_factory=lambda: Scopes({}))
    path_number: int | None = None

    def enter(self, frame: CallFrame) -> None:
        """Enter a program with its own variables, V.CYC included if it is a cycle."""
        self.scopes.enter(is_cycle=frame.arguments is not None or not self.frames)
        self.frames.append(frame)
        self.path_number = None

    def leave(self) -> None:
        """Leave the innermost program."""
        self.set_modal(None)
        frame = self.frames.pop()
        self.scopes.leave(is_cycle=frame.arguments is not None)
        self.path_number = None

    @property
    def path(self) -> tuple[OpenCall, ...]:
        """The open programs from the main program on, each with its call of the next one."""
        inner = self.frames[-1]
        outer = (OpenCall(frame.name, frame.current) for frame in self.frames[:-1])
        return (*outer, OpenCall(inner.name, None))

    def path_number_of(self, number_of: Callable[[tuple[OpenCall, ...]], int]) -> int:
        """Return the number of ``path``, assigned by ``number_of`` if it has none yet."""
        if self.path_number is None:
            self.path_number = number_of(self.path)
        return self.path_number

    def set_modal(self, call: ModalCall | None) -> None:
        """Set or clear the modal call of the innermost program."""
        self.modal_count += (call is not None) - (self.top.modal is not None)
        self.top.modal = call

    @property
    def top(self) -> CallFrame:
        """The innermost frame."""
        return self.frames[-1]

    @property
    def arguments(self) -> dict[int, float | str]:
        """The arguments of the innermost cycle."""
        for frame in reversed(self.frames):
            if frame.arguments is not None:
                return frame.arguments
        return {}
