# SPDX-License-Identifier: MIT
"""A second interpreter of programs and realtime cycles, written from the rules alone.

It shares nothing with the product and is as short as the rules are: a tick is one pass of
``_tick`` (RC-002). In: programs as lists of commands, stimuli. Out: the events as
``<tick> <kind> <text>`` and the position of X after each tick. Moves are 0.1 mm in ten ticks
(MO-14), values whole numbers but those of V.E.LIST, which expressions compute; what those are worth
says ``slow_expressions.py``. Not modelled: waiting for the PLC, override.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field

from support import slow_expressions
from support.slow_expressions import Tree

#: The way of a move of 0.1 mm after each of its ten ticks: 0.002·t², then 0.1 − 0.002·(10 − t)².
WAY_MM = tuple(0.002 * t * t if t <= 5 else 0.1 - 0.002 * (10 - t) * (10 - t) for t in range(1, 11))


@dataclass(eq=False, slots=True)
class Branch:
    """A body with its condition ``(variable, operator, number)``, ``None`` for ``$ELSE``.

    A condition may also be the tree of an expression.
    """

    condition: tuple[str, str, int] | Tree | TextCondition | None
    body: list[Statement]
    frequency: str = ""
    line: int = 0


@dataclass(eq=False, slots=True)
class If:
    """The branches of an ``$IF``; one with a frequency has only the first."""

    branches: list[Branch]


@dataclass(eq=False, slots=True)
class Assign:
    """``target = source + number``, or ``target += number`` without a source."""

    target: str
    source: str
    number: int


@dataclass(eq=False, slots=True)
class Function:
    """An M function."""

    number: int


@dataclass(eq=False, slots=True)
class Divide:
    """``VALUE1 = 6 / [source - 2]``, a fault where the source is 2."""

    source: str


@dataclass(eq=False, slots=True)
class Compute:
    """``V.E.LIST[element] operator tree``: ``=``, ``+=``, ``-=``, ``*=``, ``/=`` (RC-205)."""

    element: int
    operator: str
    tree: Tree


@dataclass(eq=False, slots=True)
class AssignText:
    """``V.E.TEXT = "text"``; ``TextCondition`` compares it."""

    text: str


@dataclass(eq=False, slots=True)
class TextCondition:
    """``V.E.TEXT operator "text"``: ``==`` or ``!=``."""

    operator: str
    text: str


Statement = If | Assign | AssignText | Function | Divide | Compute


class FaultError(Exception):
    """A statement that cannot be computed (RC-207)."""


@dataclass(eq=False, slots=True)
class Command:
    """A command of the main program; what a kind needs of the other fields."""

    kind: str
    identifier: int = 0
    scope: str = ""
    body: list[Statement] = field(default_factory=list)
    ticks: int = 0
    variable: str = ""
    number: int = 0


@dataclass(eq=False, slots=True)
class Cycle:
    """A realtime cycle; ``state``: sleeping, running, held, over (after its block), gone."""

    identifier: int
    scope: str
    lasting: bool
    body: list[Statement]
    state: str = "sleeping"
    armed: bool = False
    started_in: int = -1
    runs: int = 0
    last: dict[Branch, int] = field(default_factory=dict)
    memory: dict[Branch, bool] = field(default_factory=dict)


class Reference:
    """Runs programs one after another."""

    def __init__(self, programs: list[list[Command]], stimuli: list[tuple[int, str, int]]) -> None:
        self._programs = programs
        self._stimuli = stimuli
        self._cycles: list[Cycle] = []
        self._values: dict[str, int] = {}
        self._text = ""
        self._list = [0.0] * slow_expressions.NUMBERS
        self._read = 0
        self._left = 0
        self._moving = False
        self._attached: list[Cycle] = []
        self._rest_mm = 0.0
        self._braking = -1
        self._fault_tick = -1
        self._sequence = 0
        self.tick = 0
        self.events: list[str] = []
        self.way_mm: list[float] = []

    def run(self) -> None:
        """All programs to their ends, or to where the path stops after a fault.

        After the fault there is a tick in any case: the other cycles run on (RC-505).
        """
        for number, program in enumerate(self._programs, 1):
            commands = iter(program)
            waiting: Command | None = next(commands)
            while waiting is not None or self._fault_tick >= 0:
                waiting = self._tick(waiting, commands, f"program{number}.nc")
                self.tick += 1
                if self._braking == 0 and self.tick > self._fault_tick + 1:
                    return

    def _tell(self, kind: str, text: object) -> None:
        self.events.append(f"{self.tick} {kind} {text}")

    def _tick(self, command: Command | None, rest: Iterator[Command], name: str) -> Command | None:
        """One tick; the command that waits for the next one, ``None`` after the program's end."""
        for tick, variable, number in self._stimuli:
            if tick == self.tick:
                self._values[variable] = number
        waiting = command
        answers = reads = False
        if self._has_ended_braking():
            self._leave_block()
        if not self._left and self._braking < 0:
            self._leave_block()
            while waiting is not None and not self._left and not answers:
                if self._waits(waiting):
                    break
                answers = self._take(waiting)
                reads = waiting.kind == "read"
                if waiting.kind == "end":
                    self._tell("end", name)
                    waiting = None
                else:
                    waiting = next(rest)
        self._run_cycles()
        self._interpolate()
        self._cycles = [cycle for cycle in self._cycles if cycle.state != "gone"]
        if reads:
            self._read = self._values.get("COUNT", 0)
        return waiting

    def _run_cycles(self) -> None:
        """RC-112; after a fault no further cycle runs in the tick (RC-505)."""
        self._sequence = 0
        for cycle in self._cycles:
            if cycle.state != "running" or (cycle.scope == "BLOCK" and cycle not in self._attached):
                continue
            try:
                self._body(cycle, cycle.body)
            except (FaultError, slow_expressions.FaultError):
                self._tell("error", 50879)
                self._tell("ended", f"{cycle.identifier} error")
                cycle.state = "gone"
                self._brake()
                break
            cycle.runs += 1

    def _brake(self) -> None:
        """In its first half a move takes as long to stop as it has moved, else it ends as ever."""
        if self._braking < 0:
            self._fault_tick = self.tick
            moved = 10 - self._left if self._left and self._moving else 0
            self._braking = min(moved, self._left)

    def _has_ended_braking(self) -> bool:
        """RC-105, RC-505: a move whose second half is its braking is over when it is at rest."""
        return self._braking == 0 and self._moving and 0 < self._left <= 5

    def _enter_block(self) -> None:
        """RC-105: BLOCK cycles run with the next block that takes time, by a motion or a wait."""
        self._attached = [cycle for cycle in self._cycles if cycle.armed]
        for cycle in self._attached:
            cycle.armed = False

    def _leave_block(self) -> None:
        """RC-105: the tick after the last increment."""
        for cycle in self._attached:
            if cycle.state == "gone":  # by its own fault
                continue
            self._tell("ended", f"{cycle.identifier} scope")
            cycle.state = "over" if cycle.lasting else "gone"
        self._attached = []
        self._cycles = [cycle for cycle in self._cycles if cycle.state != "gone"]

    def _waits(self, command: Command) -> bool:
        """RC-004."""
        if command.kind == "end":
            return any(c.started_in == self.tick and c.scope != "GLOBAL" for c in self._cycles)
        return command.kind in ("hold", "delete") and any(
            c.started_in == self.tick and c.identifier == command.identifier for c in self._cycles
        )

    def _take(self, command: Command) -> bool:
        """Take a command; whether it is answered at the end of this tick (RC-005)."""
        named = [c for c in self._cycles if c.identifier == command.identifier]
        match command.kind:
            case "dwell" | "move":
                self._moving = command.kind == "move"
                self._left = 10 if self._moving else command.ticks
                self._enter_block()
            case "flush" | "read":
                self._enter_block()
                return True
            case "function":
                self._tell("output", f"M {command.number}")
            case "waiting function":
                self._tell("output", f"M {command.number}")
                self._enter_block()
                return True
            case "set":
                self._values[command.variable] = command.number
            case "set read":
                self._values[command.variable] = self._read + 1
            case "message":
                self._tell("message", command.number)
            case "define" | "define only":
                self._define(command)
            case "start":
                self._start(named[0])
            case "hold" if named[0].state == "running":
                named[0].state = "held"
                self._tell("held", command.identifier)
            case "continue" if named[0].state == "held":
                named[0].state = "running"
                self._tell("continued", command.identifier)
            case "abort":
                self._tell("aborted", command.identifier)
            case "delete":
                for cycle in named:
                    self._delete(cycle)
                return True
            case "end":
                self._end()
        return False

    def _define(self, command: Command) -> None:
        cycle = Cycle(
            command.identifier, command.scope, command.kind == "define only", command.body
        )
        self._cycles.append(cycle)
        self._tell("created", f"{cycle.identifier} {cycle.scope}")
        if not cycle.lasting:
            self._start(cycle)

    def _start(self, cycle: Cycle) -> None:
        """RC-111: new states; a BLOCK cycle is armed for the next block."""
        cycle.state, cycle.started_in = "running", self.tick
        cycle.armed = cycle.scope == "BLOCK"
        cycle.last.clear()
        cycle.memory.clear()
        self._tell("started", cycle.identifier)

    def _delete(self, cycle: Cycle) -> None:
        self._cycles.remove(cycle)
        self._tell("ended", f"{cycle.identifier} delete")

    def _end(self) -> None:
        """RC-106: all but GLOBAL cycles go, in order of creation."""
        for cycle in self._cycles:
            if cycle.scope != "GLOBAL" and cycle.state not in ("sleeping", "over"):
                self._tell("ended", f"{cycle.identifier} scope")
        self._cycles = [cycle for cycle in self._cycles if cycle.scope == "GLOBAL"]

    def _body(self, cycle: Cycle, body: list[Statement]) -> None:
        for statement in body:
            match statement:
                case Assign(target, source, number):
                    value = self._values.get(source or target, 0) + number
                    if self._values.get(target, 0) != value:
                        self._values[target] = value
                        self._tell("written", f"V.E.{target} {value}")
                case AssignText(text):
                    if self._text != text:
                        self._text = text
                        self._tell("written", f'V.E.TEXT "{text}"')
                case Divide(source):
                    divisor = self._values.get(source, 0) - 2
                    if divisor == 0:
                        raise FaultError
                    if self._values.get("VALUE1", 0) != 6 // divisor:
                        self._values["VALUE1"] = 6 // divisor
                        self._tell("written", f"V.E.VALUE1 {6 // divisor}")
                case Compute(element, operator, tree):
                    self._compute(element, operator, tree)
                case Function(number):
                    self._sequence += 1
                    self._tell("M", f"{number} {self._sequence} {self.tick * 1000}")
                case If(branches):
                    chosen = next((b for b in branches if self._holds(cycle, b)), None)
                    if chosen is not None:
                        if cycle.last.get(chosen) != cycle.runs - 1:
                            self._tell("fired", f"{cycle.identifier} line {chosen.line}")
                        cycle.last[chosen] = cycle.runs
                        self._body(cycle, chosen.body)

    def _compute(self, element: int, operator: str, tree: Tree) -> None:
        """RC-205, RC-207: what is not finite is not stored."""
        if operator != "=":
            tree = ("binary", operator[0], ("list", ("number", str(element))), tree)
        value = slow_expressions.result_of(tree, self._list)
        if self._list[element] != value:
            self._list[element] = value
            self._tell("written", f"V.E.LIST[{element}] {repr(value + 0.0).removesuffix('.0')}")

    def _is_true(self, condition: tuple[str, str, int] | Tree | TextCondition) -> bool:
        if isinstance(condition, TextCondition):
            return (self._text == condition.text) == (condition.operator == "==")
        if condition[0] not in ("binary", "unary", "call", "list", "number"):
            variable, operator, number = condition
            value = self._values.get(variable, 0)
            return {"<": value < number, ">": value > number, "==": value == number}[operator]
        worth = slow_expressions.value_of(condition, self._list)
        if not math.isfinite(worth):  # where it is only compared it is no fault (RC-207)
            raise FaultError
        return abs(worth) >= 0.5

    def _holds(self, cycle: Cycle, branch: Branch) -> bool:
        """RC-203: whether the body runs, and what a frequency remembers of it."""
        if branch.condition is None:
            return True
        before = cycle.memory.get(branch, False)
        if before and branch.frequency in ("ONCE", "ALWAYS"):
            return branch.frequency == "ALWAYS"
        now = self._is_true(branch.condition)
        cycle.memory[branch] = now
        return now and not (branch.frequency == "EDGE" and before)

    def _interpolate(self) -> None:
        place = self._rest_mm
        if self._braking >= 0:
            place = self._stopping()
        elif self._left:
            if self._moving:
                place += WAY_MM[10 - self._left]
            self._left -= 1
            if not self._left:
                self._rest_mm = place
        self.way_mm.append(place)

    def _stopping(self) -> float:
        """RC-505: the next place on the way to rest, where it stays."""
        moved = 10 - self._left if self._moving and self._left else 0
        if not self._braking:
            return self.way_mm[-1] if self.way_mm else 0.0
        self._braking -= 1
        if moved < 5:
            done = moved - self._braking
            return (
                self._rest_mm + 0.002 * moved * moved + 0.004 * moved * done - 0.002 * done * done
            )
        return self._rest_mm + WAY_MM[9 - self._braking]
