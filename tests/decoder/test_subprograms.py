# SPDX-License-Identifier: MIT
"""Subprograms as files: their search, the mistakes and when they are reported, bounds."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.decoder.state.call_stack import MAX_CALL_DEPTH
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

DEMO = Path(nctakt.__file__).parent / "machines" / "demo"


def write(folder: Path, **texts: str) -> None:
    """Files ``name.nc`` with their texts."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (folder / f"{name}.nc").write_text(text, "utf-8")


def machine(folder: Path, *lines: str) -> Path:
    """The demo machine with further lines in its channel list."""
    shutil.copytree(DEMO, folder)
    channel = folder / "sda_mds1.lis"
    channel.write_text("\n".join([*lines, channel.read_text("utf-8")]), "utf-8")
    return folder


def said(run: Run) -> list[str]:
    """The texts of all messages."""
    return [event.text for event in run.events if event.kind == "message"]


def test_mistakes_of_all_files_are_reported_before_the_first_tick(tmp_path: Path) -> None:
    """Whatever a program calls, and what that calls, is checked before anything moves."""
    write(tmp_path, main="L one.nc\nL nowhere.nc\nQ1\nM30\n", one="Q2\nL two.nc\nM17\n", two="Q3\n")
    run = Controller().run(tmp_path / "main.nc")
    assert run.ticks == 0
    places = [(Path(e.span.file).name, e.span.line, e.id) for e in run.errors if e.span]
    assert sorted(places) == [
        ("main.nc", 2, 20369),
        ("main.nc", 3, 20797),
        ("one.nc", 1, 20797),
        ("two.nc", 1, 20797),
    ]


def test_a_missing_file_is_reported_with_the_folders_that_were_searched(tmp_path: Path) -> None:
    """P-CHAN-00401: the caller's folder, then those of the list for subprograms, by priority."""
    work, lists = tmp_path / "work", tmp_path / "lists"
    write(work, main="L nowhere.nc\nM30\n")
    machine(
        lists,
        "path[0].dir far",
        "path[0].type 2",
        "path[0].priority 2",
        "path[1].dir near",
        "path[1].type 3",
        "path[1].priority 1",
        "path[2].dir mains",
        "path[2].type 1",
    )
    run = Controller(lists).run(work / "main.nc")
    (error,) = run.errors
    assert error.id == 20369
    folders = f"{work.as_posix()}/, {lists.as_posix()}/near/, {lists.as_posix()}/far/"
    assert folders in error.remedy("en")


def test_the_first_folder_that_has_a_file_counts(tmp_path: Path) -> None:
    """Own folder before those of the list, these by priority; the file below a folder is named."""
    work, lists = (
        tmp_path / "work",
        machine(
            tmp_path / "lists",
            "path[0].dir far",
            "path[0].type 2",
            "path[0].priority 2",
            "path[1].dir near",
            "path[1].type 2",
            "path[1].priority 1",
        ),
    )
    write(lists / "near", a='#MSG ["near a"]', b='#MSG ["near b"]')
    write(lists / "far", a='#MSG ["far a"]', b='#MSG ["far b"]', c='#MSG ["far c"]')
    write(lists / "far" / "deep", d='#MSG ["far d"]')
    write(work, a='#MSG ["own a"]', main="L a.nc\nL b.nc\nL c.nc\nL DEEP\\D.NC\nM30\n")
    run = Controller(lists).run(work / "main.nc")
    assert run.errors == ()
    assert said(run) == ["own a", "near b", "far c", "far d"]


def test_a_recursion_without_end_is_reported(tmp_path: Path) -> None:
    """This many programs inside each other, the main program included, and no more."""
    write(tmp_path, main="P1 = 1\nL again.nc\nM30\n", again="P1 += 1\nV.E.COUNT = P1\nL again.nc\n")
    controller = Controller()
    run = controller.run(tmp_path / "main.nc")
    (error,) = run.errors
    assert error.id == 20365
    assert error.span is not None
    assert (Path(error.span.file).name, error.span.line) == ("again.nc", 3)
    assert controller.read("V.E.COUNT") == MAX_CALL_DEPTH


def test_structures_and_calls_inside_each_other_are_bounded() -> None:
    """No depth of both together is a fault of nctakt's own."""
    structures = ["$IF 1"] * 90 + ["LL DEEP"] + ["$ENDIF"] * 90
    program = ["%L DEEP", *structures, "%MAIN", "LL DEEP", "M30"]
    run = Controller().run(NcText("deep.nc", "\n".join(program)))
    assert [error.id for error in run.errors] == [20211]


@pytest.mark.slow
def test_a_loop_of_jumps_that_never_moves_is_reported() -> None:
    """Blocks in a row that take no time are bounded, jumps or not."""
    run = Controller().run(NcText("loop.nc", "N10: P1 += 1\n$GOTO N10\nM30\n"))
    assert [error.id for error in run.errors] == [900303]


def test_a_file_with_a_computed_name_is_read_when_it_is_called(tmp_path: Path) -> None:
    """Its mistakes end the program there, after what was prepared."""
    write(tmp_path, main='V.E.TEXT = "bad" + ".nc"\n#TIME 0.002\nL V.E.TEXT\nM30\n', bad="\nQ1\n")
    run = Controller().run(tmp_path / "main.nc")
    (error,) = run.errors
    assert error.span is not None
    assert (Path(error.span.file).name, error.span.line, error.id) == ("bad.nc", 2, 20797)
    assert run.ticks >= 2


def test_events_lead_to_the_file_that_they_come_from(tmp_path: Path) -> None:
    """A message of a subprogram and an error of its realtime cycle name that file."""
    write(
        tmp_path,
        main="L sub.nc\nM30\n",
        sub='#MSG ["here"]\n#RT CYCLE\nV.E.VALUE = 1 / V.E.VALUE\n#RT CYCLE END\n#TIME 1\n',
    )
    run = Controller().run(tmp_path / "main.nc")
    message = next(event for event in run.events if event.kind == "message")
    (error,) = run.errors
    assert message.span is not None
    assert error.span is not None
    assert (Path(message.span.file).name, message.span.line) == ("sub.nc", 1)
    assert (Path(error.span.file).name, error.span.line, error.id) == ("sub.nc", 3, 50879)


def test_a_file_may_be_main_program_and_subprogram(tmp_path: Path) -> None:
    """It is checked in both roles: M17 has no place in the main program."""
    write(tmp_path, both='P1 += 1\n$IF P1 < 3\n  L both.nc\n$ENDIF\n#MSG ["%d", P1]\n')
    assert said(Controller().run(tmp_path / "both.nc")) == ["3", "3", "3"]
    write(tmp_path, both="L both.nc\nM17\n")
    assert [error.id for error in Controller().run(tmp_path / "both.nc").errors] == [20376]


def test_a_return_over_more_calls_than_are_open_leads_to_the_main_program() -> None:
    """22268 is a warning of the controller."""
    program = '%L SUB\nM17 [JUMPS=3]\n%MAIN\nLL SUB\n#MSG ["back"]\nM30\n'
    run = Controller().run(NcText("p.nc", program))
    assert (run.state, said(run)) == ("ended", ["back"])
    assert [one.id for one in run.diagnostics] == [22268]


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("P1 = @P2", 20925),
        ("M17 [JUMPS=0]", 900225),
        ("M17 [JUMPS=1.5]", 900225),
        ("M17 [NOWHERE]", 20836),
        ("P1 = @P1", 21461),
    ],
)
def test_what_only_the_call_shows_is_reported_when_it_is_decoded(line: str, error: int) -> None:
    """Values that a call did not hand over, returns that lead nowhere."""
    program = f'%L SUB\n{line}\nM17\n%MAIN\nLL CYCLE [NAME=SUB @P1="text"]\nM30\n'
    assert [one.id for one in Controller().run(NcText("p.nc", program)).errors] == [error]
