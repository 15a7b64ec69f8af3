# SPDX-License-Identifier: MIT
"""Calls of subprograms and their returns: the called program, its arguments, the return point.

In: calls in the tree, M17 with its options, M6 and G80 … G839 with programs of the channel list.
Out: ``CallFrame`` and ``Return`` for ``program.py``, which runs them. A modal call belongs to its
program: it ends with that program, with ``#DISABLE MODAL CYCLE`` or with another modal call, and
does not apply to called programs. Its arguments are those at the time of decoding.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import replace

from nctakt.base.diagnostics import Span
from nctakt.decoder.flow.flow import Return
from nctakt.decoder.state.call_stack import CallFrame, CallStack, ModalCall
from nctakt.decoder.state.queued.commands import Answer, Command
from nctakt.decoder.values.variables import Values
from nctakt.lists.machine.channel_configuration import ImplicitPrograms, program_parameter
from nctakt.messages.programs.checked_blocks import NO_PROGRAM_FOR_G_FUNCTION
from nctakt.messages.programs.checked_cycles import INVALID_KEYWORD_VALUE
from nctakt.messages.programs.decoder import TOO_FEW_OPEN_CALLS
from nctakt.messages.programs.program_structure import UNKNOWN_LOCAL_SUBPROGRAM
from nctakt.nc import tree
from nctakt.nc.meaning.words import MODAL_BLOCK, MODAL_MOVE, parameter_number
from nctakt.nc.outline import ProgramText
from nctakt.nc.parse.block_head import number_label
from nctakt.nc.vocabulary.file_names import names_program, program_key
from nctakt.nc.vocabulary.functions import RETURN_COMMANDS, SUBPROGRAM_ENDS, TOOL_CHANGE


class Calls:
    """Makes call frames; ``DecoderEnvironment.subprogram`` provides the texts.

    ``has_implicit_programs``: some words of blocks may call programs.
    """

    def __init__(self, values: Values) -> None:
        self._values = values
        self._environment = values.environment
        programs = self._environment.parameters.implicit_programs
        self.has_implicit_programs = bool(programs.m6 or programs.g)

    def note_text(self, text: ProgramText) -> None:
        """Note a program that runs: it may name programs of M6, G80 …"""
        self.has_implicit_programs |= bool(text.named_programs)

    # --- called programs -------------------------------------------------------------------------

    def call(self, call: tree.SubprogramCall, number: int) -> Generator[Command, Answer, CallFrame]:
        """Return the frame of a call with its arguments."""
        name = yield from self._values.evaluate_any(call.name, number)
        assert isinstance(name, str)
        arguments: dict[int, float | str] | None = None
        if call.cycle:
            arguments = {}
            for keyword in call.keywords:
                assert isinstance(keyword, tree.Keyword)
                index = parameter_number(keyword)
                if index is None:
                    continue  # MODAL_MOVE, MODAL_BLOCK
                assert keyword.value is not None
                arguments[index] = yield from self._values.evaluate_any(keyword.value, number)
        text = self._values.state.call_stack.top.text
        if not call.local:
            called = self._file(name, call.span)
            return CallFrame(called, called.main, arguments)
        section = text.subprograms.get(name)
        if section is None:
            self._values.fail(UNKNOWN_LOCAL_SUBPROGRAM, call.span, name=name, nearest=_names(text))
        return CallFrame(text, section, arguments)

    def _file(self, name: str, span: Span) -> ProgramText:
        caller = self._values.state.call_stack.top.text.source.file
        text = self._environment.subprogram(name, caller, span)
        self.note_text(text)
        return text

    def implicit_frame(self, name: str, span: Span) -> CallFrame:
        """Return the frame of a program that the channel list or ``#FILE NAME`` names."""
        text = self._file(name, span)
        return CallFrame(text, text.main)

    def implicit_call(
        self, block: tree.Block, number: int
    ) -> Generator[Command, Answer, tuple[tree.Block, CallFrame | None]]:
        """Return the block without the M6 or G80 … that calls a program, and that program's
        frame.
        """
        programs = self._environment.parameters.implicit_programs
        for word in block.words:
            name = self._named_program(word) or implicit_program(word, programs)
            if not name:
                continue
            assert isinstance(word, tree.Word)
            frame = self.implicit_frame(name, word.span)
            if word.arguments:
                frame.arguments = {}
            for index, argument in enumerate(word.arguments, start=1):
                assert frame.arguments is not None
                frame.arguments[index] = yield from self._values.evaluate_any(argument, number)
            others = tuple(other for other in block.words if other is not word)
            return replace(block, words=others), frame
        return block, None

    def _named_program(self, word: tree.BlockWord) -> str:
        """Return the program that ``#FILE NAME`` gives a word; raises if there is none."""
        if not isinstance(word, tree.Word) or not isinstance(word.value, tree.Number):
            return ""
        key = program_key(word.name, word.value.value)
        name = self._values.state.named_programs.get(key, "")
        if name or word.name != "G" or not names_program(key):
            return name
        number = int(word.value.value)
        if number not in self._environment.parameters.implicit_programs.g:
            listed = program_parameter(number)
            self._values.fail(NO_PROGRAM_FOR_G_FUNCTION, word.span, word=key, key=listed)
        return ""

    # --- ends -----------------------------------------------------------------------------------

    def return_of(
        self, block: tree.Block, number: int
    ) -> Generator[Command, Answer, tuple[tree.Block, Return]]:
        """Return the block without its M17 or M29, and the return."""
        calls: int | None = 1
        label: str | None = None
        others: list[tree.BlockWord] = []
        for word in block.words:
            if isinstance(word, tree.BracketCommand) and _is_return(word):
                calls, label = yield from self._options(word, number)
            elif isinstance(word, tree.Word) and word.name == "N":
                assert isinstance(word.value, tree.Number)
                label = number_label(f"{word.value.value:.0f}")
            elif not _is_return(word) or self._is_output(word):
                others.append(word)
        rest = replace(block, words=tuple(others))
        return rest, Return(calls, label, block.span)

    def _is_output(self, word: tree.BlockWord) -> bool:
        """Return whether M17 or M29 is in the channel list and therefore output (P-CHAN-00041)."""
        assert isinstance(word, tree.Word)
        assert isinstance(word.value, tree.Number)
        return int(word.value.value) in self._environment.parameters.m_functions

    def _options(
        self, command: tree.BracketCommand, number: int
    ) -> Generator[Command, Answer, tuple[int | None, str | None]]:
        """Return the values of ``[MAIN]`` or ``[JUMPS=2]``, and of a label."""
        calls: int | None = 1
        label: str | None = None
        for item in command.items:
            if isinstance(item, tree.Keyword) and item.name == "MAIN":
                calls = None
            elif isinstance(item, tree.Keyword) and item.name == "JUMPS":
                assert item.value is not None
                value = yield from self._values.evaluate(item.value, number)
                calls = self._jumps(value, item.span)
            else:
                label = label_of(item)
        return calls, label

    def _jumps(self, value: float, span: Span) -> int | None:
        """Return the number of calls to return over, ``None`` for all where fewer are open."""
        maximum = len(self._values.state.call_stack.frames) - 1
        if value < 1 or value != int(value):
            self._values.fail(
                INVALID_KEYWORD_VALUE, span, word="JUMPS", value=value, names=f"1 … {maximum}"
            )
        if value > maximum:
            self._values.warn(TOO_FEW_OPEN_CALLS, span, count=int(value), maximum=maximum)
            return None
        return int(value)


def has_return(block: tree.Block) -> bool:
    """Return whether a block contains M17 or M29."""
    for word in block.words:  # no generator, because it is called for each block
        if _is_return(word):
            return True
    return False


def label_of(item: tree.Keyword | tree.Expression) -> str | None:
    """Return the label in the brackets of M17."""
    if isinstance(item, tree.Name):
        return item.name
    if isinstance(item, tree.Keyword):
        if item.name == "N" and isinstance(item.value, tree.Number):
            return number_label(f"{item.value.value:.0f}")
        if item.value is None:
            return item.name
    return None


def _is_return(word: tree.BlockWord) -> bool:
    if isinstance(word, tree.AxisWord):
        return False
    if isinstance(word, tree.BracketCommand):
        return word.name in RETURN_COMMANDS
    return (
        isinstance(word, tree.Word)
        and word.name == "M"
        and isinstance(word.value, tree.Number)
        and word.value.value in SUBPROGRAM_ENDS
    )


def implicit_program(word: tree.BlockWord, programs: ImplicitPrograms) -> str:
    """Return the program of the channel list that a word calls; empty if there is none."""
    if not isinstance(word, tree.Word) or not isinstance(word.value, tree.Number):
        return ""
    number = word.value.value
    if word.name == "M" and number == TOOL_CHANGE:
        return programs.m6
    return programs.g.get(int(number), "") if word.name == "G" else ""


def _names(text: ProgramText) -> str:
    return ", ".join(text.subprograms) or "–"


# --- modal calls ----------------------------------------------------------------------------------


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
