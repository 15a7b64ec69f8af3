# SPDX-License-Identifier: MIT
"""Random programs with independent axes, beside a realtime cycle and a PLC, against a slow model.

The channel also gives axes and takes them again, while the PLC may move them.

The model knows the rules only: which command is taken in which tick (RC-003, RC-005, RC-409, SA-1 …
SA-6), and that an axis takes the shortest time from its present speed to a target (MO-11): speed up
or down to one speed, keep it, brake. It finds that speed by bisection, and compares the place of
each axis in each tick.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field

import pytest
from support.axis_plans import FASTEST, Plan
from support.random_seeds import each_seed

from nctakt.plc import MC_MoveAbsolute, Plc
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

AXES = "XYZ"


@dataclass(frozen=True)
class Order:
    """A command for one axis: POS absolute or not, feed in mm/min."""

    axis: str
    position: float
    absolute: bool
    feed: float
    waits: bool = False

    def text(self) -> str:
        form = "INDP_SYN" if self.waits else "INDP_ASYN"
        how = "G90" if self.absolute else "G91"
        return f"{self.axis}[{form} {how} G01 FEED={self.feed:g} POS={self.position:g}]"


@dataclass(frozen=True)
class Line:
    """Orders, and the target of one axis of the path, of a block; or axes to wait for; or an axis
    that the channel gives and takes again.
    """

    orders: tuple[Order, ...] = ()
    path: tuple[str, float, float] | None = None
    awaited: str = ""
    exchanged: str = ""

    def text(self) -> str:
        if self.exchanged:
            place = AXES.index(self.exchanged)
            taken = f"#CALL AX [{self.exchanged}, {place + 1}, {place}]"
            return f"#PUT AX [{self.exchanged}]\n{taken}"
        if self.awaited:
            return f"#WAIT INDP [{self.awaited}]"
        words = [order.text() for order in self.orders]
        if self.path:
            axis, target, feed = self.path
            words.append(f"G01 G60 {axis}{target:g} F{feed:g}")
        return " ".join(words)


@dataclass
class Model:
    """The axes of the machine, tick by tick."""

    plans: dict[str, Plan] = field(default_factory=dict)
    places: dict[str, float] = field(default_factory=dict)
    standing: set[str] = field(default_factory=set)

    def state(self, axis: str, tick: int) -> tuple[float, float]:
        """Place and speed at the beginning of a tick."""
        plan = self.plans.get(axis)
        return (0.0, 0.0) if plan is None else plan.after(tick - 1)

    def order(self, tick: int, order: Order) -> None:
        """The last command has the axis."""
        place, speed = self.state(order.axis, tick)
        target = order.position if order.absolute else place + order.position
        self.plans[order.axis] = Plan(tick, place, speed, target, min(order.feed / 60, FASTEST))

    def close(self, tick: int) -> None:
        """Note what is at the end of a tick."""
        self.places = {axis: self.state(axis, tick + 1)[0] for axis in AXES}
        self.standing = {axis for axis in AXES if self.stands(axis, tick)}

    def stands(self, axis: str, tick: int) -> bool:
        """Whether the axis is at rest at the end of a tick."""
        plan = self.plans.get(axis)
        return plan is None or tick >= plan.first + plan.ticks() - 1


def interpreted(lines: list[Line], model: Model):
    """Yield each time a tick has to pass; takes what the program commands, with the present tick.

    ``independent``: axes commanded since their places were read; Z is moved by a cycle, too, so
    that its place is read once time has passed (RC-409).
    """
    tick = yield
    independent: set[str] = set()
    uncertain = {"Z"}
    known = dict.fromkeys(AXES, 0.0)
    for line in lines:
        if line.exchanged:
            tick = yield from exchanged(line.exchanged, model, known)
            uncertain.add("Z")
        if line.awaited:
            needed = [axis for axis in line.awaited if axis in independent | uncertain]
        else:
            needed = []
        for order in line.orders:
            # Each command reads the place of its own axis, in the order of the words.
            if order.axis in independent | uncertain:
                tick = yield from read([order.axis], model, independent, uncertain, known)
            known[order.axis] = order.position + (0.0 if order.absolute else known[order.axis])
        if needed:
            tick = yield from read(needed, model, independent, uncertain, known)
        for order in line.orders:
            independent.add(order.axis)
            model.order(tick, order)
        if line.path:
            axis, target, feed = line.path
            if axis in independent and target != known[axis]:
                tick = yield from read([axis], model, independent, uncertain, known)
            if target != known[axis]:
                model.order(tick, Order(axis, target, True, feed))
                known[axis] = target
                for _ in range(model.plans[axis].ticks()):
                    tick = yield
                uncertain.add("Z")
        awaited = [order.axis for order in line.orders if order.waits]
        if awaited:
            tick = yield from read(awaited, model, independent, uncertain, known)


def exchanged(axis, model, known):
    """Answer when the channel has given the axis and has it again.

    Both commands wait for all axes that the channel has, the second one for the axis as well. The
    next block still asks for axes that moved beside the path.
    """
    yield from stand(AXES, model)
    tick = yield from stand(AXES.replace(axis, ""), model)
    while axis not in model.standing:
        tick = yield
    known.update(model.places)
    return tick


def stand(axes, model):
    """Answer at the end of the first tick in which all of them are at rest."""
    tick = yield
    while not model.standing.issuperset(axes):
        tick = yield
    return tick


def read(axes, model, independent, uncertain, known):
    """Answer when all of them are at rest, with their places."""
    tick = yield from stand(axes, model)
    uncertain.add("Z")
    for axis in axes:
        known[axis] = model.places[axis]
    independent.difference_update(axes)
    uncertain.difference_update(axes)
    return tick


def random_lines(source: random.Random) -> list[Line]:
    """Some blocks; X moves with the path, too."""
    lines = []
    places = [float(place) for place in range(-8, 9)]
    known = [0.0]
    for _ in range(source.randrange(2, 7)):
        kind = source.randrange(5)
        if kind == 4:
            lines.append(Line(exchanged=source.choice("XY")))
            continue
        if kind == 0:
            lines.append(Line(awaited=source.choice(AXES)))
            continue
        axes = source.sample(AXES, source.randrange(1, 3))
        path = None
        if kind == 1:
            axes = [axis for axis in axes if axis != "X"]
            target = source.choice([*known, source.choice(places)])
            path = ("X", target, source.choice([3000.0, 9000.0]))
        orders = tuple(
            Order(
                axis,
                source.choice(places),
                source.random() < 0.5,
                source.choice([2400.0, 6000.0, 60000.0]),
                source.random() < 0.4,
            )
            for axis in axes
        )
        known = [order.position for order in orders if order.axis == "X"] or known
        if orders or path:
            lines.append(Line(orders, path))
    return lines


class Mover(Plc):
    """Sends Y to a position in a tick."""

    def __init__(self, tick: int, position: float) -> None:
        self.tick, self.position = tick, position
        self.block = MC_MoveAbsolute("Y")

    def each_tick(self, hli: PlcView) -> None:
        self.block(hli, execute=hli.tick + 1 >= self.tick, position=self.position, velocity=100)


@each_seed(compiled=12, plain=4)
def test_programs_cycles_and_the_plc_move_axes_as_the_rules_say(seed: int) -> None:
    """SA-1 … SA-6, exchanges: each place in each tick, from which also follows that limits hold."""
    source = random.Random(seed)
    lines = random_lines(source)
    of_cycle, of_plc = source.randrange(1, 300), source.randrange(1, 300)
    targets = source.randrange(-8, 9), source.randrange(-8, 9)
    cycle = (
        "#RT CYCLE [ID=1 SCOPE=PROG END_ACTION=MOVE_CONT]\n$IF ONCE V.E.TRIGGER\n"
        f"Z[INDP G90 G01 FEED=6000 POS={targets[0]}]\n$ENDIF\n#RT CYCLE END\n"
    )
    text = cycle + "\n".join(line.text() for line in lines) + "\nG04 0.4\nM30"
    run = Controller().run(
        NcText("p.nc", text),
        plc=Mover(of_plc, targets[1]),
        at=[Stimulus(f"{of_cycle} ms", "V.E.TRIGGER", 1.0)],
        signals=[f"{axis}.ACS.ACT_POS" for axis in AXES],
    )
    assert run.state == "ended", (text, run.diagnostics)
    assert run.trace is not None
    traces = {axis: run.trace[f"{axis}.ACS.ACT_POS"] for axis in AXES}
    model = Model()
    program = interpreted(lines, model)
    next(program)
    is_over = False
    end_tick = next(event.tick for event in run.events if event.kind == "end")
    for tick in range(end_tick):
        if tick == of_plc:
            model.order(tick, Order("Y", targets[1], True, 6000.0))
        if not is_over:
            try:
                program.send(tick)
            except StopIteration:
                is_over = True
        if tick == of_cycle:
            model.order(tick, Order("Z", targets[0], True, 6000.0))
        model.close(tick)
        for axis, place in model.places.items():
            assert traces[axis][tick] == pytest.approx(place, abs=1e-6), (axis, tick, text)
    assert is_over
