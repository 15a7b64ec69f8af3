# SPDX-License-Identifier: MIT
"""Modal calls: cycles that run again behind each block, or each block with a motion.

In: ``L CYCLE [NAME=… MODAL_MOVE …]``, and the statements of the program that has called. Out: the
calls that are due. A modal call belongs to the program in which it stands: it ends with that
program, with ``#DISABLE MODAL CYCLE`` or with another modal call, and has no effect in programs
that are called. The values that it hands over are those of the moment in which it was decoded.
"""

from __future__ import annotations

from nctakt.decoder.state.call_stack import CallFrame, CallStack, ModalCall
from nctakt.nc import tree
from nctakt.nc.check.calls import MODAL_BLOCK, MODAL_MOVE

#: What is followed by no call: calls themselves, and what only leads the way.
_WITHOUT_CALL = (
    tree.SubprogramCall,
    tree.If,
    tree.For,
    tree.While,
    tree.Do,
    tree.Repeat,
    tree.Switch,
    tree.Break,
    tree.Continue,
    tree.Goto,
    tree.RealtimeLoop,
)


def modal_word(call: tree.SubprogramCall) -> str:
    """``MODAL_MOVE`` or ``MODAL_BLOCK`` of a call, empty without."""
    for item in call.keywords:
        if isinstance(item, tree.Keyword):
            if item.name in MODAL_MOVE:
                return "MODAL_MOVE"
            if item.name == MODAL_BLOCK:
                return item.name
    return ""


class ModalCalls:
    """The modal calls of one run of a program."""

    def __init__(self, call_stack: CallStack) -> None:
        self._call_stack = call_stack

    def begin(self, call: tree.SubprogramCall, frame: CallFrame) -> None:
        """A call has begun; where it is modal, further ones follow."""
        word = modal_word(call)
        if word:
            self._call_stack.set_modal(ModalCall(_copy(frame), call.span, word == MODAL_BLOCK))
        elif self._call_stack.top.modal is not None:
            self._call_stack.top.modal.is_due = False

    def end(self) -> None:
        """``#DISABLE MODAL CYCLE``."""
        self._call_stack.set_modal(None)

    def after_block(self, line: int, has_motion: bool) -> None:
        """The words of a block that calls nothing and ends nothing are decoded."""
        modal = self._call_stack.top.modal
        if modal is not None and (modal.after_each_block or has_motion):
            modal.is_due = True
            modal.line = line

    def after_statement(self, statement: tree.Statement) -> None:
        """A statement that is no block of words is decoded."""
        modal = self._call_stack.top.modal
        if modal is None or not modal.after_each_block:
            return
        if not isinstance(statement, (tree.Block, *_WITHOUT_CALL)):
            modal.is_due = True
            modal.line = statement.span.line

    def take_due(self, line: int | None = None) -> tuple[CallFrame, ModalCall] | None:
        """The call that comes before the block in this line, or ``None`` for the next block."""
        modal = self._call_stack.top.modal
        if modal is None or not modal.is_due or modal.line == line:
            return None
        modal.is_due = False
        return _copy(modal.frame), modal


def _copy(frame: CallFrame) -> CallFrame:
    """The frame of another run: its own parameters may be changed."""
    arguments = None if frame.arguments is None else dict(frame.arguments)
    return CallFrame(frame.text, frame.section, arguments)
