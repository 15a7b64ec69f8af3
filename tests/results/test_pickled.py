# SPDX-License-Identifier: MIT
"""Results and machines outlive their process: pickled, compared, drawn."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import pytest

from nctakt import Controller, NcText, Study, load_machine, open_schedule

EXAMPLES = Path(__file__).parents[2] / "examples"


def again(value: object) -> object:
    """The value from its pickle."""
    return pickle.loads(pickle.dumps(value))


@pytest.mark.parametrize("with_schedule", [False, True])
def test_runs_with_the_same_inputs_are_equal_and_so_are_their_copies(with_schedule: bool) -> None:
    """With histories, coverage, blocks and the effects of a schedule; another run differs."""
    rtconf = EXAMPLES / "schedule" / "rtconf.lis"
    runs = [
        Controller(schedule=open_schedule(rtconf) if with_schedule else None).run(
            EXAMPLES / "crossing.nc", why=True, blocks=True, signals=signals
        )
        for signals in (None, None, ["PATH.SPEED"])
    ]
    assert runs[0] == runs[1] == again(runs[0]) == copy.deepcopy(runs[0])
    assert runs[0].trace == again(runs[1].trace)
    assert runs[0].trace != runs[2].trace
    assert runs[0] != runs[2]


def test_a_copy_can_be_drawn_as_the_run_can(tmp_path: Path) -> None:
    """The source lines come along: its controller, machine and programs need not be there."""
    program = tmp_path / "part.nc"
    program.write_text((EXAMPLES / "crossing.nc").read_text())
    run = Controller().run(program, why=True, blocks=True)
    copied = again(run)
    program.unlink()
    pages = []
    for number, one in enumerate((run, copied, again(copied))):
        files = [tmp_path / f"{number}{suffix}" for suffix in (".html", ".vcd", ".json")]
        one.plot(files[0])
        one.write_vcd(files[1])
        one.write_perfetto(files[2])
        pages.append([file.read_text() for file in files])
    assert pages[0] == pages[1] == pages[2]
    assert "#MSG" in pages[0][0]


def test_a_machine_from_its_pickle_makes_the_same_runs() -> None:
    """It needs its folder no more."""
    machine = again(load_machine())
    assert machine == load_machine()
    program = NcText("part.nc", "G01 X1 F6000 M30")
    assert Controller(machine).run(program) == Controller().run(program)


def test_results_of_studies_are_equal_and_so_are_their_copies() -> None:
    """Plan, rows and units; other values differ."""
    results = [
        Study(
            program=NcText("move.nc", "G01 X10 F6000 M30"),
            vary=[{"variable": "HLI.OVERRIDE", "values": [50, high]}],
            measure={"time": "duration", "way": "max X - 1", "most": "ticks * 2"},
        ).run()
        for high in (100, 100, 90)
    ]
    assert results[0] == results[1] == again(results[0])
    assert results[0] != results[2]


def test_columns_of_studies_have_units() -> None:
    """Those of times and signals; a product of two lengths has none that anybody has named."""
    pytest.importorskip("pyarrow")
    result = Study(
        program=NcText("move.nc", "M100 G01 X10 F6000 M30"),
        vary=[{"time_of": "V.E.VALUE = 1", "values": ["1 ms", "2 ms"]}],
        measure={
            "time": "duration", "most": "max X - 1", "twice": "2 * most", "late": "time of M100",
            "area": "most * most", "number": "count of M100", "left": "20 ms - late",
        },
        expect=["X > 1 within 1 s"],
    ).run()  # fmt: skip
    units = {
        "V.E.VALUE": "s", "time": "s", "most": "mm", "twice": "mm", "late": "s",
        "left": "s", "reaction_time": "s", "ticks": "ticks",
    }  # fmt: skip
    assert result.units == units
    schema = result.to_arrow().schema
    assert {one.name: one.metadata[b"unit"].decode() for one in schema if one.metadata} == units
    assert result.to_pandas().attrs["units"] == units
