# SPDX-License-Identifier: MIT
"""The programs at work: the main program and the subprograms that it has called.

In: calls and ends. Out: the innermost program with its text, its local variables and what its call
has handed over. Each call is a frame; how many there may be is bounded, so that a program that
calls itself without end is told (``MAX_CALL_DEPTH``, a choice).
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Span
from nctakt.decoder.state.program_variables import Scopes
from nctakt.nc.outline import ProgramText, Section

#: Programs inside each other, the main program included.
MAX_CALL_DEPTH = 20

#: Structures and calls inside each other, over all call_stack.
MAX_NESTING = 120


@dataclass(slots=True)
class ModalCall:
    """A call that is repeated behind blocks: ``after_each_block``, or behind those with a motion.

    ``frame`` is what it calls, ``span`` where it stands. ``is_due``: a block has come, in ``line``.
    """

    frame: CallFrame
    span: Span
    after_each_block: bool
    is_due: bool = False
    line: int = 0


@dataclass(slots=True)
class CallFrame:
    """One program at work; ``arguments``: @P1, @P2, … of its cycle, ``None`` without a cycle.

    A subprogram that a cycle calls sees the cycle's own.
    """

    text: ProgramText
    section: Section
    arguments: dict[int, float | str] | None = None
    modal: ModalCall | None = None


@dataclass(slots=True)
class CallStack:
    """The call_stack from the main program on; ``scopes``: their variables.

    ``modal_count``: how many of them have a modal call.
    """

    frames: list[CallFrame] = field(default_factory=list)
    modal_count: int = 0
    scopes: Scopes = field(default_factory=lambda: Scopes({}))

    def enter(self, frame: CallFrame) -> None:
        """A program begins: variables of its own, as a cycle also V.CYC."""
        self.scopes.enter(is_cycle=frame.arguments is not None or not self.frames)
        self.frames.append(frame)

    def leave(self) -> None:
        """The innermost program has ended."""
        self.set_modal(None)
        frame = self.frames.pop()
        self.scopes.leave(is_cycle=frame.arguments is not None)

    def set_modal(self, call: ModalCall | None) -> None:
        """The modal call of the program that decodes is this one from now on."""
        self.modal_count += (call is not None) - (self.top.modal is not None)
        self.top.modal = call

    @property
    def top(self) -> CallFrame:
        """The program that decodes."""
        return self.frames[-1]

    @property
    def arguments(self) -> dict[int, float | str]:
        """What the call of the innermost cycle has handed over."""
        for frame in reversed(self.frames):
            if frame.arguments is not None:
                return frame.arguments
        return {}
