# SPDX-License-Identifier: MIT
"""The call stack: the main program and the subprograms that it has called.

In: calls and ends. Out: the innermost program with its text, its local variables and its arguments.
The number of frames is bounded, so that endless recursion is reported (``MAX_CALL_DEPTH``, a
choice).
"""

from __future__ import annotations

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


@dataclass(slots=True)
class CallFrame:
    """A program being decoded; ``arguments``: @P1, @P2, … of its cycle, ``None`` without a cycle.

    A subprogram called by a cycle uses the arguments of the cycle.
    """

    text: ProgramText
    section: Section
    arguments: dict[int, float | str] | None = None
    modal: ModalCall | None = None


@dataclass(slots=True)
class CallStack:
    """The frames from the main program on; ``scopes``: their variables.

    ``modal_count``: the number of frames with a modal call.
    """

    frames: list[CallFrame] = field(default_factory=list)
    modal_count: int = 0
    scopes: Scopes = field(default_factory=lambda: Scopes({}))

    def enter(self, frame: CallFrame) -> None:
        """Enter a program with its own variables, V.CYC included if it is a cycle."""
        self.scopes.enter(is_cycle=frame.arguments is not None or not self.frames)
        self.frames.append(frame)

    def leave(self) -> None:
        """Leave the innermost program."""
        self.set_modal(None)
        frame = self.frames.pop()
        self.scopes.leave(is_cycle=frame.arguments is not None)

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
