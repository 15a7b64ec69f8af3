# SPDX-License-Identifier: MIT
"""The call hierarchy: what a program calls, and who calls it; texts that have no file yet."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import CallHierarchyItem, Position

from nctakt.editor.calls import CallHierarchy
from nctakt.editor.document import Document, name_of, uri_of
from nctakt.editor.workspace import Workspace

MAIN = """\
%L PART
L drill.nc
M17
%MAIN
#FILE NAME [G80="drill.nc"]
LL PART
G80
LL PART (again)
LL NONE
M30
"""


def opened(work: Workspace, folder: Path, name: str, text: str) -> Document:
    path = folder / name
    path.write_text(text)
    document = Document(uri_of(path), path, path.as_posix(), "nctakt", 0, text.split("\n"))
    work.open(document)
    return document


def test_calls_lead_in_both_directions(tmp_path: Path) -> None:
    """LL, L and the program that #FILE NAME gives a G function; each section on its own."""
    work = Workspace()
    main = opened(work, tmp_path, "main.nc", MAIN)
    (tmp_path / "drill.nc").write_text("M17\n")
    loaded = work.machine_of(main)
    calls = CallHierarchy(work, loaded, lambda: work.programs([tmp_path]))

    def outgoing(item: CallHierarchyItem) -> list[tuple[str, list[int]]]:
        return [
            (call.to.name, [area.start.line for area in call.from_ranges])
            for call in calls.outgoing(item)
        ]

    (item,) = calls.prepare(main, Position(9, 0))
    assert item.name == "MAIN"
    assert outgoing(item) == [("PART", [5, 7]), ("drill.nc", [6])]
    (part,) = calls.prepare(main, Position(5, 4))
    assert outgoing(part) == [("drill.nc", [1])]
    assert [(call.from_.name, len(call.from_ranges)) for call in calls.incoming(part)] == [
        ("MAIN", 2)
    ]
    drill = calls.outgoing(part)[0].to
    assert [call.from_.name for call in calls.incoming(drill)] == ["PART", "MAIN"]
    assert calls.prepare(main, Position(8, 4)) == []


def test_texts_without_a_file_belong_to_the_folder_of_the_editor(tmp_path: Path) -> None:
    """Its programs can be called; a list is checked by its kind."""
    (tmp_path / "sub.nc").write_text("M17\n")
    work = Workspace()
    name = name_of("untitled:Untitled-1", [tmp_path])
    assert name == (tmp_path / "Untitled-1").as_posix()
    program = Document("untitled:Untitled-1", None, name, "nctakt", 0, ["L sub.nc", "M30", ""])
    work.open(program)
    assert work.check(program) == []
    lines = ["rt_cycles.enable 7", ""]
    listed = Document("untitled:Untitled-2", None, name, "nctakt-list", 0, lines)
    work.open(listed)
    assert 1023 in [item.id for item in work.check(listed)]
