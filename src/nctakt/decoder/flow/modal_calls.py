# SPDX-License-Identifier: MIT
"""Modal calls: cycles repeated after each block, or after each block with a motion.

In: ``L CYCLE [NAME=… MODAL_MOVE …]``, and the statements of the calling program. Out: the calls
that are due. A modal call belongs to its program: it ends with that program, with ``#DISABLE MODAL
CYCLE`` or with another modal call, and does not apply to called programs. Its arguments are those
at the time of decoding.
"""

from __future__ import annotations

from nctakt.decoder.state.call_stack import CallFrame, CallStack, ModalCall
from nctakt.nc import tree
from nctakt.nc.meaning.words import MODAL_BLOCK, MODAL_MOVE

#: Statements without a call after them: calls themselves, and control flow.
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
    """Return ``MODAL_MOVE`` or ``MODAL_BLOCK`` of a call, empty without."""
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
        """Note a call; a modal one will be repeated."""
        word = modal_word(call)
        if word:
            self._call_stack.set_modal(ModalCall(_copy(frame), call.span, word == MODAL_BLOCK))
        elif self._call_stack.top.modal is not None:
            self._call_stack.top.modal.is_due = False

    def end(self) -> None:
        """End the modal call (``#DISABLE MODAL CYCLE``)."""
        self._call_stack.set_modal(None)

    def after_block(self, line: int, has_motion: bool) -> None:
        """Note a decoded block of words that calls nothing and ends nothing."""
        modal = self._call_stack.top.modal
        if modal is not None and (modal.after_each_block or has_motion):
            modal.is_due = True
            modal.line = line

    def after_statement(self, statement: tree.Statement) -> None:
        """Note a decoded statement other than a block of words."""
        modal = self._call_stack.top.modal
        if modal is None or not modal.after_each_block:
            return
        if not isinstance(statement, (tree.Block, *_WITHOUT_CALL)):
            modal.is_due = True
            modal.line = statement.span.line

    def take_due(self, line: int | None = None) -> tuple[CallFrame, ModalCall] | None:
        """Return the call due before the block in this line, or before the next block for
        ``None``.
        """
        modal = self._call_stack.top.modal
        if modal is None or not modal.is_due or modal.line == line:
            return None
        modal.is_due = False
        return _copy(modal.frame), modal


def _copy(frame: CallFrame) -> CallFrame:
    """Return a copy of the frame for another run, whose parameters may change."""
    arguments = None if frame.arguments is None else dict(frame.arguments)
    return CallFrame(frame.text, frame.section, arguments)
