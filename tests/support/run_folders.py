# SPDX-License-Identifier: MIT
"""The folders of ``tests/runs``: what each of them runs, and what it expects."""

from __future__ import annotations

import shutil
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import nctakt
from nctakt.plc import load_plc
from nctakt.results.run import Run
from nctakt.results.trace.sinks import Sink
from nctakt.run.access.inputs import InputListener
from nctakt.run.access.tape import Tape
from nctakt.run.controller import Controller
from nctakt.schedule.open_schedule import RunSchedule, open_schedule

HERE = Path(__file__).parent.parent / "runs"


FOLDERS = sorted(folder.parent.name for folder in HERE.glob("*/expected.trace"))


DEMO = Path(nctakt.__file__).parent / "machines" / "demo"


def settings(folder: Path) -> dict[str, Any]:
    """What ``run.toml`` says."""
    file = folder / "run.toml"
    return tomllib.loads(file.read_text("utf-8")) if file.exists() else {}


def changed_machine(changes: Mapping[str, Sequence[str]], target: Path, base: Path = DEMO) -> Path:
    """A machine with other lines for the same entries of its lists, or further ones."""
    shutil.copytree(base, target)
    for name, lines in changes.items():
        entries = {line.split()[0]: line for line in lines}
        kept = [
            line
            for line in (target / name).read_text("utf-8").splitlines()
            if not line.split() or line.split()[0] not in entries
        ]
        (target / name).write_text("\n".join([*entries.values(), *kept, ""]), "utf-8")
    return target


def perform(
    folder: Path,
    names: set[str],
    work: Path,
    programs: str = "*.nc",
    *,
    replay: Tape | None = None,
    record: InputListener | None = None,
    sinks: Sequence[Sink] = (),
) -> Run:
    """Run the programs of a folder and record the signals ``names``; with ``replay`` no PLC."""
    given = settings(folder)
    machine = given.get("machine_folder")
    changes = given.get("machine")
    if machine is not None:
        machine = folder / machine
    elif changes is not None:
        machine = changed_machine(changes, work / "machine")
    plc = given.get("plc") if replay is None else None
    others = {
        int(number): [folder / name for name in names]
        for number, names in given.get("channels", {}).items()
    }
    taken = [program for own in others.values() for program in own]
    return Controller(machine, schedule_of(folder, given)).run(
        *(program for program in sorted(folder.glob(programs)) if program not in taken),
        channels=others,
        plc=None if plc is None else load_plc(folder / plc),
        set=given.get("set", {}),
        at=[tuple(stimulus) for stimulus in given.get("at", ())],
        after=given.get("after", 0),
        ticks=given.get("ticks"),
        wait_for_start=given.get("wait_for_start", False),
        record_writes=given.get("record_writes", True),
        signals=sorted(names),
        replay=replay,
        record=record,
        sinks=sinks,
        skip=given.get("skip", ()),
        blocks=given.get("blocks", False),
    )


def schedule_of(folder: Path, given: Mapping[str, Any]) -> RunSchedule | None:
    """The schedule that the run goes by, if it names one."""
    if "rtconf" not in given:
        return None
    return open_schedule(folder / given["rtconf"], folder / given["load"])


def expectations(folder: Path) -> tuple[list[tuple[int, str, float]], list[str], list[str]]:
    """The expected values, the expected events as ``<tick> <kind> <text>``, the diagnostics."""
    values: list[tuple[int, str, float]] = []
    events: list[str] = []
    diagnostics: list[str] = []
    for line in (folder / "expected.trace").read_text("utf-8").splitlines():
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        if words[0] == "value":
            values.append((int(words[1]), words[2], float(words[3])))
        elif words[0] == "diagnostic":
            diagnostics.append(line.removeprefix("diagnostic ").strip())
        else:
            assert words[0] == "event", line
            events.append(line.removeprefix("event ").strip())
    return values, events, diagnostics


def settled(event: str) -> str:
    """An event whose value, where it has one, is rounded to a millionth of a thousandth."""
    head, written, rest = event.partition(" written ")
    if not written:
        return event
    name, value = rest.rsplit(" ", 1)
    return f"{head} written {name} {round(float(value), 9) + 0.0:g}"
