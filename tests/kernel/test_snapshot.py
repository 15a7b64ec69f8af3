# SPDX-License-Identifier: MIT
"""A realtime part that was put back to a snapshot runs as a new one does, byte for byte."""

from __future__ import annotations

import random
from collections.abc import Hashable
from pathlib import Path
from typing import Any

import pytest
from support import run_folders
from support.insides import machine_of
from support.program_generator import program
from support.random_seeds import all_seeds

from nctakt.base.mode import is_compiled
from nctakt.decoder.state.kept_trees import KeptTrees
from nctakt.kernel.cycles.cycles import CycleManager
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.plc import load_plc
from nctakt.run.access.machine_names import names_of_machine
from nctakt.run.controller import Controller, NcText
from nctakt.run.program_loader import LoadedProgram
from nctakt.run.realtime.realtime_part import RealtimePart
from nctakt.run.realtime.snapshot import Snapshot
from nctakt.studies.runs.study_runner import Digest

RUNS = Path(__file__).parent.parent / "runs"

DEMO = load_machine(None)
MAX_TICKS = 3000


def part_of(machine: Machine) -> RealtimePart:
    """A new realtime part."""
    return RealtimePart(machine, names_of_machine(machine).layout)


def digest(
    source: NcText | Path | LoadedProgram, part: RealtimePart | None, seed: int = 0
) -> tuple[str, ...]:
    """What a run on this part does: its events, all default signals, the memory at its end."""
    chance = random.Random(seed)
    trace = Digest()
    controller = Controller(DEMO, realtime=part)
    run = controller.run(
        source,
        at=[(chance.randint(1, 900) / 1000, "V.E.VALUE", chance.random()) for _ in range(3)],
        set={"HLI.OVERRIDE": chance.choice((100, 100, 60))},
        ticks=MAX_TICKS,
        plc=plc_of(source),
        sinks=[trace],
        memory_trace=False,
        why=True,
        blocks=True,
    )
    memory = machine_of(controller).memory
    findings = [one.headline() for one in run.diagnostics]
    return run.state, str(run.ticks), trace.text(), bytes(memory).hex(), *findings


def plc_of(source: NcText | Path | LoadedProgram) -> Any:
    """The PLC of a folder of ``runs``."""
    if not isinstance(source, Path):
        return None
    plc = run_folders.settings(source.parent).get("plc")
    return None if plc is None else load_plc(source.parent / plc)


def sources() -> list[NcText | Path]:
    """Random programs, and those of ``runs`` that need no lists of their own."""
    found: list[NcText | Path] = [
        NcText(f"p{seed}.nc", program(seed)) for seed in all_seeds(compiled=10, plain=2)
    ]
    folders = run_folders.FOLDERS[:: 2 if is_compiled() else 12]
    for name in folders:
        files = sorted((RUNS / name).glob("*.nc"))
        if "machine" not in run_folders.settings(RUNS / name):
            found.append(files[0])
    return found


@pytest.mark.nightly
def test_a_part_put_back_runs_as_a_new_one() -> None:
    """One part serves all programs, in any order, each as a new one would."""
    part = part_of(DEMO)
    start_up = Snapshot(part)
    programs = sources()
    random.Random(5).shuffle(programs)
    for number, source in enumerate(programs):
        alone = digest(source, None, number)
        start_up.put_back()
        assert digest(source, part, number) == alone, source


def test_kept_cycles_run_as_new_ones() -> None:
    """Trees of cycles that an earlier run has built and run are as if rebuilt."""
    part = part_of(DEMO)
    start_up = Snapshot(part)
    found = []

    class Counting(KeptTrees):
        def find(self, key: Hashable) -> object | None:
            found.append(super().find(key))
            return found[-1]

    for seed in all_seeds(compiled=10, plain=2):
        part.kept_cycles = Counting()
        loaded = Controller(DEMO).load(NcText(f"p{seed}.nc", program(seed)))
        alone = digest(loaded, None, seed)
        for _ in range(2):
            start_up.put_back()
            assert digest(loaded, part, seed) == alone, seed
    assert any(one is not None for one in found)
    assert any(one is None for one in found)


@pytest.mark.parametrize("seed", range(3))
def test_a_part_put_back_in_the_middle_goes_on_as_it_did(seed: int) -> None:
    """Ticks that need nothing of the decoder are the same again, with all their events."""
    controller = Controller(DEMO)
    part = machine_of(controller).realtime
    controller.start(NcText("p.nc", program(seed)))
    controller.step(random.Random(seed).randint(50, 400))
    snapshot = Snapshot(part)

    def stretch() -> tuple[int, int, bytes, bytes, int]:
        part.kernel.reserve()
        reason = part.kernel.run(200)
        events = part.record.take_events()
        part.record.take_rows()
        part.record.take_probes()
        managers: list[CycleManager] = [channel.manager for channel in part.channels]
        runs = sum(cycle.runs for manager in managers for cycle in manager.loaded)
        return reason, part.kernel.tick, events, bytes(part.memory), runs

    first = stretch()
    for _ in range(2):
        snapshot.put_back()
        assert stretch() == first


def test_a_snapshot_is_taken_of_an_emptied_record() -> None:
    """What has been recorded and not taken would be lost."""
    part = part_of(DEMO)
    part.record.select([0])
    part.kernel.run(1)
    with pytest.raises(ValueError, match="emptied"):
        Snapshot(part)
