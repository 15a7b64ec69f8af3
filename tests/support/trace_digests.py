# SPDX-License-Identifier: MIT
"""Traces as digests: of random programs and of the programs in ``runs``, byte for byte.

As a script it prints the digests of all of them and how the realtime part was loaded, so that
another process, with another hash seed or without compiled modules, can be compared with this one.
"""

from __future__ import annotations

import hashlib
import json
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

HERE = Path(__file__).parent.parent
sys.path.insert(0, str(HERE))

from nctakt.base import mode  # noqa: E402
from nctakt.lists.machine.machine import load_machine  # noqa: E402
from nctakt.plc import load_plc  # noqa: E402
from nctakt.results.trace.sinks import CsvSink  # noqa: E402
from nctakt.run.controller import Controller, NcText  # noqa: E402
from support import run_folders  # noqa: E402
from support.program_generator import program  # noqa: E402
from support.single_axis_programs import Generator, RandomPlc  # noqa: E402

SEEDS = range(20)
SINGLE_AXIS_SEEDS = range(3)
DEMO = load_machine(None)

#: Most ticks of a random program: GLOBAL cycles with low overrides can make one long.
MAX_TICKS = 4000


def random_trace(seed: int, file: Path) -> bytes:
    """The CSV trace of a random program."""
    text = NcText(f"p{seed}.nc", program(seed))
    Controller(DEMO).run(text, ticks=MAX_TICKS, sinks=[CsvSink(file)], memory_trace=False)
    return file.read_bytes()


def single_axis_trace(seed: int, file: Path) -> bytes:
    """The CSV trace of a random program whose axes the program, cycles and a PLC move at once."""
    text = NcText(f"a{seed}.nc", Generator(seed, is_alone=True).program())
    Controller(DEMO).run(
        text, ticks=800, plc=RandomPlc(seed), sinks=[CsvSink(file)], memory_trace=False
    )
    return file.read_bytes()


def folder_trace(name: str, work: Path) -> bytes:
    """The CSV trace of a folder of ``runs``."""
    folder = HERE / "runs" / name
    given = run_folders.settings(folder)
    machine, plc = given.get("machine"), given.get("plc")
    lists = None if machine is None else run_folders.changed_machine(machine, work / name)
    file = work / f"{name}.csv"
    Controller(lists or DEMO).run(
        *sorted(folder.glob("*.nc")),
        plc=None if plc is None else load_plc(folder / plc),
        set=given.get("set", {}),
        at=[tuple(stimulus) for stimulus in given.get("at", ())],
        after=given.get("after", 0),
        ticks=given.get("ticks"),
        sinks=[CsvSink(file)],
        memory_trace=False,
    )
    return file.read_bytes()


def digests(work: Path) -> Iterator[tuple[str, str]]:
    """Name and digest of every trace."""
    for seed in SEEDS:
        yield f"seed {seed}", hashlib.sha256(random_trace(seed, work / "t.csv")).hexdigest()
    for seed in SINGLE_AXIS_SEEDS:
        trace = single_axis_trace(seed, work / "t.csv")
        yield f"axes {seed}", hashlib.sha256(trace).hexdigest()
    for name in run_folders.FOLDERS:
        yield name, hashlib.sha256(folder_trace(name, work)).hexdigest()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        print(json.dumps({"compiled": mode.is_compiled(), "digests": dict(digests(Path(folder)))}))
