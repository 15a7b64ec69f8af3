# SPDX-License-Identifier: MIT
"""Random NC programs that the demo machine runs: moves, dwells, cycles, messages, overrides.

The same seed gives the same program, on every platform. Programs are valid; about one in six ends
with a fault of a realtime cycle or of the decoder, which is a way to end as well.
"""

from __future__ import annotations

from random import Random

VARIABLES = ("V.E.VALUE", "V.E.VALUE1", "V.E.VALUE2", "V.E.SYNC", "V.CH.Total")
COUNTERS = ("V.E.COUNT", "V.E.COUNT_POS", "V.E.COUNT_NEG", "V.E.TRIGGER")
POSITIONS = ("V.RTA.ACS.ACT_POS.X", "V.RTA.MCS.CMD_POS.Y", "V.RTA.PCS.DIST_TO_GO.Z")


class Generator:
    """One program from one seed."""

    def __init__(self, seed: int) -> None:
        self.chance = Random(seed)
        self.lines: list[str] = []
        self.living: list[int] = []
        self.next_id = 1
        self.number = 10

    def program(self) -> str:
        """The program's text."""
        chance = self.chance
        if chance.random() < 0.2:
            self.lines.append("G70")
        for _ in range(chance.randint(8, 30)):
            chance.choice(self.steps)(self)
        if chance.random() < 0.08:
            self.lines.append(f"N{self.number} G01 X[1 / [V.E.ASYNC * 0]]")
        self.lines.append("M30")
        return "\n".join(self.lines) + "\n"

    # --- expressions -----------------------------------------------------------------------------

    def value(self, depth: int = 2) -> str:
        """An expression without faults."""
        chance = self.chance
        if depth == 0 or chance.random() < 0.3:
            leaf = chance.choice((*VARIABLES, *COUNTERS, *POSITIONS, "P1", "V.E.ASYNC", "#"))
            return f"{chance.uniform(0, 40):.3f}" if leaf == "#" else leaf
        left, right = self.value(depth - 1), self.value(depth - 1)
        form = chance.choice(
            ("{} + {}", "{} - {}", "[{}] * 0.5 + SIN[{}]", "[{}] / [ABS[{}] + 1]", "INT[{}] + [{}]")
        )
        return form.format(left, right)

    def condition(self) -> str:
        """A condition."""
        operator = self.chance.choice(("<", "<=", ">", ">=", "==", "!="))
        text = f"{self.value(1)} {operator} {self.value(1)}"
        if self.chance.random() < 0.2:
            text = f"[{text}] && [{self.value(0)} XOR {self.value(0)}]"
        return text

    # --- realtime cycles -------------------------------------------------------------------------

    def statement(self, depth: int) -> list[str]:
        """A statement of a cycle."""
        chance = self.chance
        kind = chance.random()
        if depth and kind < 0.4:
            frequency = chance.choice(("", "", "ONCE ", "EDGE ", "ALWAYS "))
            lines = [f"$IF {frequency}{self.condition()}", *self.statements(depth - 1)]
            if not frequency and chance.random() < 0.5:
                lines += ["$ELSE", *self.statements(depth - 1)]
            return [*lines, "$ENDIF"]
        if kind < 0.5:
            return [f"V.RTG.OVERRIDE.VEL.CYCLE = {chance.randint(10, 110)}"]
        if kind < 0.6:
            return [f"$IF EDGE {self.condition()}", f"M{chance.randint(100, 110)}", "$ENDIF"]
        if kind < 0.62:
            return [f"V.E.VALUE = 1 / [V.E.COUNT - {chance.randint(5, 90)}]"]
        if kind < 0.8:
            return [f"{chance.choice(COUNTERS)} = [V.E.COUNT + {chance.randint(1, 9)}] MOD 1000"]
        return [f"{chance.choice(VARIABLES)} = {self.value()}"]

    def statements(self, depth: int) -> list[str]:
        """Some of them."""
        return [line for _ in range(self.chance.randint(1, 3)) for line in self.statement(depth)]

    def cycle(self) -> None:
        """A definition, with or without ID, of any scope."""
        chance = self.chance
        scope = chance.choice(("BLOCK", "PROG", "PROG", "GLOBAL"))
        keywords = [f"SCOPE={scope}"]
        definition = ""
        if scope == "GLOBAL" or chance.random() < 0.5:
            keywords.insert(0, f"ID={self.next_id}")
            if scope != "BLOCK":
                self.living.append(self.next_id)
                definition = " DEF" if chance.random() < 0.3 else ""
            self.next_id += 1
        self.lines += [f"#RT CYCLE{definition} [{' '.join(keywords)}]", *self.statements(2)]
        self.lines.append("#RT CYCLE END")

    def manage(self) -> None:
        """A management command for a cycle that lives, or that DELETE does not find."""
        if not self.living:
            self.cycle()
            return
        action = self.chance.choice(("START", "HOLD", "CONTINUE", "ABORT ACTION", "DELETE"))
        identity = self.chance.choice(self.living)
        if action == "DELETE":
            self.living.remove(identity)
        self.lines.append(f"#RT CYCLE {action} [ID={identity}]")
        if action == "HOLD":
            self.dwell()
            self.lines.append(f"#RT CYCLE CONTINUE [ID={identity}]")

    # --- the main program ------------------------------------------------------------------------

    def move(self) -> None:
        """A straight motion."""
        chance = self.chance
        axes = chance.sample(("X", "Y", "Z", "A"), chance.randint(1, 3))
        words = " ".join(f"{axis}{chance.uniform(0, 30):.3f}" for axis in axes)
        motion = chance.choice(("G00", f"G01 F{chance.randint(6000, 30000)}", "G90", "G91 G00"))
        self.lines.append(f"N{self.number} {motion} {words}")
        self.number += 10
        if motion.startswith("G91"):
            self.lines.append("G90")

    def dwell(self) -> None:
        """Standing still for some ticks."""
        self.lines.append(f"N{self.number} G04 X{self.chance.randint(1, 40) / 1000:.3f}")
        self.number += 10

    def function(self) -> None:
        """An M or H function of any synchronisation that is simulated."""
        letter = self.chance.choice("MH")
        self.lines.append(f"{letter}{self.chance.choice((100, 105, 111, 112, 113))}")

    def write(self) -> None:
        """A variable written by the main program, or a parameter."""
        target = self.chance.choice((*VARIABLES, "P1", "V.E.ASYNC"))
        value = self.chance.choice((self.value(1), f"{self.chance.uniform(0, 50):.4f}"))
        self.lines.append(f"{target} = {value}")

    def flush(self) -> None:
        """An emptied channel."""
        self.lines.append(self.chance.choice(("#FLUSH", "#FLUSH WAIT", "#FLUSH CONTINUE")))

    def message(self) -> None:
        """A message with a value of the decoder's time."""
        self.lines.append('#MSG ["at %f of %d", P1, V.E.COUNT]')

    def loop(self) -> None:
        """A loop of moves, each with a cycle of its block."""
        count = self.chance.randint(2, 12)
        self.lines += [f"$FOR P2 = 1, {count}, 1", "#RT CYCLE [SCOPE=BLOCK]", *self.statements(1)]
        self.lines += ["#RT CYCLE END", "G00 X[P2 * 0.7] Y[P2 MOD 3]", "$ENDFOR"]

    steps = (
        move,
        move,
        move,
        move,
        dwell,
        cycle,
        cycle,
        manage,
        function,
        write,
        flush,
        message,
        loop,
    )


def program(seed: int) -> str:
    """The program of a seed."""
    return Generator(seed).program()
