# SPDX-License-Identifier: MIT
"""The names for the numbers in events: cycles, variables, axes, texts, programs."""

from __future__ import annotations

import copy
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Sequence
from typing import Protocol

from nctakt.base.diagnostics import Span
from nctakt.base.source_ids import SourceFiles, begins_at
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.decoder.cycles.keywords import keyword_of
from nctakt.decoder.state.call_stack import OpenCall
from nctakt.decoder.state.queued.commands import UserMessage
from nctakt.decoder.state.queued.in_force import InForce
from nctakt.decoder.state.uncertain_axes import LivingCycle
from nctakt.kernel import codes
from nctakt.kernel.cycles.cycles import CycleManager, RealtimeCycle
from nctakt.results.run import FrozenValue, Reaction
from nctakt.results.run_statistics import BranchKey, branch_key


class PlcSources(Protocol):
    """The texts of a PLC in the tick, with a number for each position in them, from 1 on."""

    @property
    def end(self) -> int:
        """The number after those of all texts."""

    def span(self, start: int, end: int) -> Span | None:
        """Return where a part of the texts is, by the numbers of its positions."""


class EventRegistry:
    """The names for the numbers in events, valid for the life of the controller.

    ``on_cycle`` is called with the name and the definition of each realtime cycle.
    """

    def __init__(
        self,
        files: SourceFiles,
        variable: Callable[[int], str],
        axes: Sequence[str],
        spindles: Sequence[str],
    ) -> None:
        self._files = files
        self._axes = axes
        self._variable = variable
        self._cycle_names: list[str] = [""]
        self._anonymous: dict[int, int] = {}
        self._probes = 0
        self._messages: list[UserMessage] = []
        self._text_numbers: dict[str, int] = {}
        self._programs: list[str] = []
        self._threads: Sequence[str] = ()
        self._variable_texts: list[str] = []
        self._user_texts: list[str] = []
        self._paths: list[tuple[OpenCall, ...]] = [()]
        self._modal: list[InForce | None] = [None]
        self._modal_numbers: dict[InForce, int] = {}
        self._path_numbers: dict[tuple[OpenCall, ...], int] = {}
        self._spindles = spindles
        self._variable_numbers: dict[str, int] = {}
        self._latest: dict[str, CycleDefinition] = {}
        self._living: dict[int, CycleDefinition] = {}
        self._past_runs: dict[str, int] = {}
        self._past_bodies: Counter[BranchKey] = Counter()
        self._meant_aborts: set[int] = set()
        self.on_cycle: Callable[[str, CycleDefinition], None] | None = None
        self._plcs: list[PlcSources] = []
        self._plc_bases: list[int] = []

    def add_plc(self, sources: PlcSources) -> int:
        """Keep the texts of a PLC in the tick; return the offset of its positions in events."""
        for known, base in zip(self._plcs, self._plc_bases, strict=True):
            if known is sources:
                return base
        base = self._plc_bases[-1] + self._plcs[-1].end if self._plcs else 0
        self._plcs.append(sources)
        self._plc_bases.append(base)
        return base

    def with_own_files(self) -> EventRegistry:
        """Return the same names in another object, for use when this one changes."""
        other = copy.copy(self)
        other._files = self._files.copy()
        return other

    # --- names of events ------------------------------------------------------------------------

    def cycle(self, serial: int) -> str:
        """Return the programmed ID of a cycle; ``#1``, ``#2`` … without one."""
        return self._cycle_names[serial]

    def variable(self, cell: int) -> str:
        """Return the name of the variable in a memory cell."""
        return self._variable(cell)

    def axis(self, index: int) -> str:
        """Return the name of an axis of the machine."""
        return self._axes[index]

    def message(self, number: int) -> str:
        """Return the text of a message."""
        return self._messages[number].text

    def message_style(self, number: int) -> tuple[bool, bool, str]:
        """Return whether a message is exclusive, whether it is unbroken, and its message file."""
        message = self._messages[number]
        return message.exclusive, message.unbroken, message.file

    def variable_text(self, number: int) -> str:
        """Return the text of a variable whose value was frozen."""
        return self._variable_texts[number]

    def user_text(self, number: int) -> str:
        """Return a user's text that belongs to an error."""
        return self._user_texts[number]

    def path(self, number: int) -> tuple[OpenCall, ...]:
        """Return the programs that were open at a block, the main program first."""
        return self._paths[number]

    def modal(self, number: int) -> InForce | None:
        """Return the functions in force in a channel, ``None`` before its first block."""
        return self._modal[number]

    def program(self, number: int) -> str:
        """Return the file name of a program."""
        return self._programs[number]

    def thread(self, number: int) -> str:
        """Return the name of a thread of the schedule."""
        return self._threads[number]

    def span(self, source: int) -> Span | None:
        """Return the span of a source id; a negative id belongs to a statement of the PLC."""
        if source >= 0:
            return self._files.span(source)
        index = bisect_left(self._plc_bases, -source) - 1
        if index < 0:
            return None
        start = -source - self._plc_bases[index]
        return self._plcs[index].span(start, start + 1)

    def line_at(self, span: Span) -> str:
        """Return the source line of a span."""
        return self._files.line_at(span)

    def definition(self, serial: int) -> CycleDefinition:
        """Return the definition of a living cycle."""
        return self._living[serial]

    def left_in(self, manager: CycleManager) -> tuple[LivingCycle, ...]:
        """Return the cycles that earlier programs have left in a channel, with their axes."""
        cycles = []
        for cycle in manager.loaded:
            state = manager.state_of(cycle.slot)
            if codes.DEFINED <= state <= codes.HELD:
                definition = self._living[cycle.serial]
                cycles.append(
                    LivingCycle(definition.identity, definition.axes, state != codes.DEFINED)
                )
        return tuple(cycles)

    def is_abort_meant(self, serial: int) -> bool:
        """Return whether a cycle's definition decides about its motions (END_ACTION)."""
        return serial in self._meant_aborts

    # --- registration ---------------------------------------------------------------------------

    def next_cycle(self) -> tuple[int, int]:
        """Return serial number and first probe of the next definition."""
        return len(self._cycle_names), self._probes

    def keep(self, definition: CycleDefinition, channel: int = 0) -> None:
        """Register a definition; ``channel``: its number on a machine with several, else 0."""
        if definition.serial != len(self._cycle_names):
            raise ValueError(f"serial {definition.serial} is not the next one")
        name = str(definition.identity)
        if definition.identity == 0:
            self._anonymous[channel] = self._anonymous.get(channel, 0) + 1
            name = f"#{self._anonymous[channel]}"
        if channel:
            name = f"{channel}:{name}"
        self._cycle_names.append(name)
        self._probes += definition.cycle.probes
        self._latest[name] = definition
        self._living[definition.serial] = definition
        if keyword_of(definition.statement.keywords, "END_ACTION") is not None:
            self._meant_aborts.add(definition.serial)
        if self.on_cycle is not None:
            self.on_cycle(name, definition)

    def forget(self, cycles: Sequence[RealtimeCycle]) -> None:
        """Remove cycles that have ended; only their run-throughs are kept."""
        for cycle in cycles:
            definition = self._living.pop(cycle.serial)
            name = self._cycle_names[cycle.serial]
            self._past_bodies.update(_bodies(name, definition))
            self._past_runs[name] = self._past_runs.get(name, 0) + cycle.runs
            if "#" in name:
                del self._latest[name]

    def add_message(self, message: UserMessage) -> int:
        """Register a message and return its number."""
        self._messages.append(message)
        return len(self._messages) - 1

    def add_text(self, text: str) -> int:
        """Register a text of the PLC as a message and return its number, the same each time."""
        if text not in self._text_numbers:
            self._text_numbers[text] = self.add_message(UserMessage(0, 0, text))
        return self._text_numbers[text]

    def add_variable(self, text: str) -> int:
        """Register a variable's text and return its number, the same each time."""
        if text not in self._variable_numbers:
            self._variable_numbers[text] = len(self._variable_texts)
            self._variable_texts.append(text)
        return self._variable_numbers[text]

    def spindle(self, number: int) -> str:
        """Return the name of a spindle."""
        return self._spindles[number]

    def name_threads(self, names: Sequence[str]) -> None:
        """Set the names of the threads of a schedule."""
        self._threads = names

    def add_user_text(self, text: str) -> int:
        """Register a text that belongs to a user error and return its number."""
        self._user_texts.append(text)
        return len(self._user_texts) - 1

    def add_path(self, path: tuple[OpenCall, ...]) -> int:
        """Register open programs and return their number, the same each time."""
        if path not in self._path_numbers:
            self._path_numbers[path] = len(self._paths)
            self._paths.append(path)
        return self._path_numbers[path]

    def add_modal(self, in_force: InForce) -> int:
        """Register functions in force and return their number, the same each time."""
        if in_force not in self._modal_numbers:
            self._modal_numbers[in_force] = len(self._modal)
            self._modal.append(in_force)
        return self._modal_numbers[in_force]

    def add_program(self, name: str) -> int:
        """Register a program and return its number."""
        self._programs.append(name.replace("\\", "/").rsplit("/", 1)[-1])
        return len(self._programs) - 1

    # --- for results ----------------------------------------------------------------------------

    def reactions_of(self, name: str) -> Sequence[Reaction]:
        """Return the branches of the latest cycle with this name."""
        reactions = self._latest[name].reactions
        return [Reaction(reaction.span, reaction.frequency) for reaction in reactions]

    def frozen_in(self, name: str, span: Span | None) -> Sequence[FrozenValue]:
        """Return the frozen values of the latest living cycle of this name and span (RC-302)."""
        for serial, definition in reversed(self._living.items()):
            if self._cycle_names[serial] == name and begins_at(definition.span, span):
                values = definition.frozen
                return [FrozenValue(value.name, value.value, value.span) for value in values]
        return ()

    def bodies(self) -> Counter[BranchKey]:
        """Return how often the bodies of all branches have run since the start-up."""
        bodies = self._past_bodies.copy()
        for definition in self._living.values():
            bodies.update(_bodies(self._cycle_names[definition.serial], definition))
        return bodies

    def runs(self) -> Counter[str]:
        """Return the run-throughs of all cycles by name since the start-up."""
        runs = Counter(self._past_runs)
        for definition in self._living.values():
            name = self._cycle_names[definition.serial]
            runs[name] += definition.cycle.runs
        return runs


def _bodies(name: str, definition: CycleDefinition) -> Counter[BranchKey]:
    """Return how often the bodies of a cycle's branches have run."""
    return Counter({branch_key(name, one.span): one.node.count for one in definition.reactions})
