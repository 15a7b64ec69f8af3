# SPDX-License-Identifier: MIT
"""``python -m benchmarks.decoder``: how fast long programs are checked, decoded and run.

Programs are made, the same in each run: one of straight blocks as CAM systems write them (G01 and
three coordinates in each line); one of ordinary blocks (expressions, variables, branches, loops),
each of which is read once; one of varied blocks (three dozen shapes of lines at random, in
structures of any length, with calls of a subprogram, functions, comments); and the ordinary blocks
in a loop, which are read once and decoded again and again. Each stage has its own process, whose
greatest memory is reported:

* *check*: the text is read once, as before each run;
* *decode*: from the text to commands in the queue with their look-ahead; none is taken;
* *run*: check, decoding and all ticks up to the program's end, without a trace.

Where LinuxCNC's interpreter ``rs274`` is on the path it reads the same straight blocks, and writes
its commands as text. ``--lines N`` changes the length of the programs.
"""

from __future__ import annotations

import argparse
import math
import os
import platform
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from nctakt.base.mode import is_compiled
from nctakt.decoder.fast.handover import PlainRun
from nctakt.decoder.state.queued.commands import Segment, waits
from nctakt.decoder.state.queued.packing import pack
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.run import program_loader
from nctakt.run.controller import Controller
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.queue_feeder import QueueFeeder

LINES = 1_000_000
#: Ordinary programs are a fifth as long.
ORDINARY_SHARE = 5

#: No program takes longer, in virtual time.
LONGEST = "100000 s"

#: Commands that the queue holds while a program is only decoded.
QUEUE = 200

#: Ordinary blocks; each repetition has other numbers.
PIECE = """\
N{n}0 V.P.ANGLE = V.P.ANGLE + {step}
V.P.R = 40 + 5 * SIN[3 * V.P.ANGLE]
$IF V.P.R > 42
N{n}5 G01 X[V.P.R * COS[V.P.ANGLE]] Y[V.P.R * SIN[V.P.ANGLE]] F[3000 + P1]
$ELSE
G01 X=V.P.R Y{y} Z[0.1 * V.P.R]
$ENDIF
P1 = P1 + 1
V.P.COUNT = V.P.COUNT + 2 * {step}
$FOR P2 = 0, 1, 1
X[P2 + {y}] Y=V.P.COUNT/1000
$ENDFOR
"""

#: Varied lines: ``a``, ``b`` and ``c`` are other numbers in each of them, ``n`` counts.
VARIED = """\
N{n} G01 X{a} Y[{b} * COS[V.P.ANGLE]] F[{a} * 10 + 3000]
N{n} G01 X{a} Y{b} Z-{c}
N{n} G00 Z[5 + V.P.R / {c}]
G01 X=V.P.X Y{a} Z-{c} F{b}00
G01 X[V.P.X + {c}] M100
G91 X[{c} / 10]
G90 X{a}
N{n} X[{a} - V.L.STEP] Y[{b} + P1 / 1000] (to the next one)
Y[0.5 * V.P.R + {a}] ; {n}
X{a} Y{b}
X{a}
G02 X{a} Y{b} R900
G03 I{c} J0 F{b}00
G04 X0.0{n}
G54
M100 (on)
V.P.X = {a} + 0.5 * V.P.R
V.P.R = SQRT[V.P.X * V.P.X + {b} * {b}] / 10 ; the radius
V.P.ANGLE = V.P.ANGLE + {c}
V.P.ANGLE = ATAN2[{a}, {b} + 1] ( of {n} )
V.L.STEP = [{a} - V.P.X] / {c}
V.L.STEP = ABS[V.L.STEP] MOD {c}
V.P.COUNT += 1
N{n} P1 = P1 + 1
P5 = ROUND[{a} / 3] * {c}
V.P.F[2] = {a} * 2
X[V.P.F[2] / 100]
V.P.F[P4] = V.P.R
V.E.COUNT = {c}
(only a comment)
; {n}
LL POCKET
N{n} LL POCKET
V.P.X = V.L.STEP
V.P.DEPTH = -{c}
"""
VARIED_HEAD = """\
%L POCKET
G01 X[V.P.X / 2] Z=V.P.DEPTH
M17
%MAIN
#VAR
V.P.ANGLE = 0
V.P.R = 10
V.P.X = 1
V.P.COUNT = 0
V.P.DEPTH = 0
V.P.F[4] = [1, 2, 3, 4]
V.L.STEP = 0
#ENDVAR
P1 = 0
P4 = 1
G90 G01 F3000"""
#: Their structures, with other lines between these.
STRUCTURES = (
    ("$IF V.P.R > {a}", "$ENDIF"),
    ("N{n} $IF P1 < {a} && V.P.X < {b}", "$ELSE", "$ENDIF"),
    ("$IF V.P.X > {a}", "$ELSEIF V.P.X > {b}", "$ELSE", "$ENDIF"),
    ("$FOR P2 = 1, 2, 1", "$ENDFOR"),
    ("$SWITCH P1 MOD 3\n$CASE 1", "$BREAK\n$CASE 2", "$DEFAULT", "$ENDSWITCH"),
    ("P3 = 1\n$WHILE P3 < 2", "P3 = P3 + 1\n$ENDWHILE"),
)

#: Blocks that one pass through them takes: a loop is one, each of its passes another.
BLOCKS_OF_PIECE = 12


@dataclass(frozen=True, slots=True)
class Measured:
    """What a stage took: lines, seconds by the clock and of the processor, MB at most."""

    lines: int
    seconds: float
    cpu_s: float
    memory_mb: float

    def row(self, name: str, target: str = "") -> str:
        """A line of the table."""
        speed, cpu = self.lines / self.seconds, self.lines / self.cpu_s
        return f"{name:34} {speed:12,.0f} {cpu:14,.0f} {self.memory_mb:9.1f}  {target}"


def straight(count: int) -> Iterator[str]:
    """G01 and three coordinates in each line: steps of about 0.1 mm on a bowl."""
    yield "G90 G01 X100 Y0 Z0 F12000"
    for i in range(1, count - 1):
        angle = 0.001 * i
        radius = 100.0 - 0.05 * (i % 1000) / 1000.0
        x, y, z = radius * math.cos(angle), radius * math.sin(angle), 0.01 * (i % 1000)
        yield f"G01 X{x:.3f} Y{y:.3f} Z{z:.3f}"
    yield "M30"


def beside(count: int) -> Iterator[str]:
    """A spiral of straight blocks, with the tool outside of it (G42)."""
    yield "G90 G01 X100 Y0 Z0 F12000\nG42 D1 G26"
    for i in range(1, count - 2):
        angle = 0.001 * i
        radius = 100.0 + 0.0001 * i
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        yield f"G01 X{x:.3f} Y{y:.3f} Z{0.01 * (i % 1000):.3f}"
    yield "M30"


def ordinary(count: int) -> Iterator[str]:
    """Expressions, variables, branches and loops."""
    head = "#VAR\nV.P.ANGLE = 0\nV.P.R = 0\nV.P.COUNT = 0\n#ENDVAR\nP1 = 0\nG90 F3000"
    yield from head.splitlines()
    for i in range((count - 8) // len(PIECE.splitlines())):
        yield from PIECE.format(n=i + 1, step=0.5 + i % 7, y=i % 50).splitlines()
    yield "M30"


def varied(count: int) -> Iterator[str]:
    """Lines and structures of many shapes, in no order."""
    chance = random.Random(1)
    shapes = VARIED.splitlines()

    def filled(shape: str) -> str:
        a, b = (f"{chance.uniform(1, 60):.{chance.randrange(4)}f}" for _ in range(2))
        return shape.format(a=a, b=b, c=chance.randrange(1, 9), n=chance.randrange(1, 1000))

    lines = VARIED_HEAD.splitlines()
    while len(lines) < count:
        if chance.random() < 0.8:
            lines.append(filled(chance.choice(shapes)))
            continue
        first, *others = chance.choice(STRUCTURES)
        lines += filled(first).splitlines()
        for other in others:
            lines += (filled(chance.choice(shapes)) for _ in range(chance.randrange(1, 5)))
            lines += filled(other).splitlines()
    yield from lines
    yield "M30"


def loop(passes: int) -> Iterator[str]:
    """The ordinary blocks in a loop that is gone through so often."""
    *head, end = ordinary(8)
    yield from (*head, f"$WHILE P1 < {passes}")
    yield from PIECE.format(n=1, step=2.5, y=3).replace("3000 + P1", "3000").splitlines()
    yield from ("$ENDWHILE", end)


def write(lines: Iterator[str], path: Path) -> int:
    """Write a program; its lines."""
    count = 0
    with path.open("w", encoding="ascii") as file:
        for line in lines:
            file.write(line + "\n")
            count += 1
    return count


# --- stages, each in its own process -------------------------------------------------------


def check(path: Path) -> tuple[Controller, LoadedProgram]:
    """Read and check a program."""
    controller = Controller()
    loaded = program_loader.load(path, controller._machine, controller.diagnostics)
    return controller, loaded


def put_segment(queue: CommandQueue, command: Segment) -> None:
    """A block of the tree's way into the queue."""
    one = command
    queue.put_segment(
        *(one.source, one.number, one.start, one.target, one.motion, one.feed),
        *(one.exact_stop, one.deviation, one.limits_jerk, one.arc),
    )


def decode(controller: Controller, loaded: LoadedProgram) -> None:
    """Decode a program into a queue that is a new one whenever it is full."""
    machine = controller._machine
    feed = QueueFeeder(machine, loaded, controller.diagnostics.append)
    path, ahead = machine.channels[0].path, machine.channels[0].queue.look_ahead
    queue = CommandQueue(path, ahead)
    for command in feed._decoded:
        assert not waits(command), command
        if queue.timed_count >= QUEUE:
            queue = CommandQueue(path, ahead)
        if isinstance(command, PlainRun):
            command.blocks.fill(queue, QUEUE, 0)
        elif isinstance(command, Segment):
            put_segment(queue, command)
            feed._decoder.pass_time(command)
        else:
            queue.put(pack(command))


def run(path: Path) -> None:
    """Run a program to its end."""
    found = Controller().run(path, until=LONGEST, memory_trace=False)
    assert found.state == "ended", [one.headline() for one in found.diagnostics]


def stage(name: str, path: Path) -> None:
    """Measure a stage in this process and print what it took."""
    if name == "decode":
        controller, loaded = check(path)
    cpu_s, begin = time.process_time(), time.perf_counter()
    match name:
        case "check":
            check(path)
        case "decode":
            decode(controller, loaded)
        case "run":
            run(path)
    seconds, cpu_s = time.perf_counter() - begin, time.process_time() - cpu_s
    memory_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(seconds, cpu_s, memory_mb)


def measure(name: str, path: Path, lines: int) -> Measured:
    """A stage in its own process."""
    words = [sys.executable, "-m", "benchmarks.decoder", "--stage", name, str(path)]
    done = subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True)
    seconds, cpu_s, memory_mb = map(float, done.stdout.split())
    return Measured(lines, seconds, cpu_s, memory_mb)


def rs274(path: Path, lines: int) -> Measured | None:
    """LinuxCNC's interpreter on the same program; ``None`` where it does not run."""
    program = shutil.which("rs274")
    if program is None:
        return None
    variables, tools = path.with_suffix(".var"), path.with_suffix(".tbl")
    variables.touch()
    tools.touch()
    words = [program, "-g", "-v", str(variables), "-t", str(tools), str(path), os.devnull]
    begin = time.perf_counter()
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - begin
    if status != 0:
        return None
    return Measured(lines, seconds, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)


# --- the table ----------------------------------------------------------------------------------


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--lines", type=int, default=LINES)
    parser.add_argument("--stage", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.stage:
        stage(options.stage[0], Path(options.stage[1]))
        return
    form = "compiled" if is_compiled() else "plain"
    print(f"Python {platform.python_version()}, {platform.machine()}, {form}\n")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "straight.nc")
        lines = write(straight(options.lines), path)
        name = f"{lines:,} straight blocks"
        print(f"{name:34} {'lines/s':>12} {'lines/CPU s':>14} {'MB':>9}  target")
        targets = {"check": "", "decode": "300,000 lines/s, 100 MB", "run": "100,000 lines/s"}
        for name, target in targets.items():
            print(measure(name, path, lines).row(name, target), flush=True)
        reference = rs274(path, lines)
        print(
            "rs274 is not on the path, or does not run"
            if reference is None
            else reference.row("rs274")
        )
        path = Path(folder, "beside.nc")
        lines = write(beside(options.lines), path)
        print(f"\n{lines:,} straight blocks, tool radius compensated")
        print(measure("decode", path, lines).row("decode", "100,000 lines/s"), flush=True)
        path = Path(folder, "ordinary.nc")
        lines = write(ordinary(options.lines // ORDINARY_SHARE), path)
        print(f"\n{lines:,} ordinary lines")
        for name, target in {"check": "", "decode": "80,000 lines/s"}.items():
            print(measure(name, path, lines).row(name, target), flush=True)
        path = Path(folder, "varied.nc")
        lines = write(varied(options.lines // ORDINARY_SHARE), path)
        print(f"\n{lines:,} varied lines")
        for name in ("check", "decode"):
            print(measure(name, path, lines).row(name), flush=True)
        passes = options.lines // ORDINARY_SHARE // BLOCKS_OF_PIECE
        write(loop(passes), path)
        print(f"\n{passes * BLOCKS_OF_PIECE:,} ordinary blocks in a loop")
        found = measure("decode", path, passes * BLOCKS_OF_PIECE)
        print(found.row("decode", "80,000 blocks/s"))


if __name__ == "__main__":
    main()
