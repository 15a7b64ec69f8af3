# SPDX-License-Identifier: MIT
"""Renaming leaves a program that does the same: every place changes, no two names become one.

Labels: grammar.txt, ``label`` and ``jump``; a label belongs to its program or subprogram, and
``N020`` and ``N20`` are the same.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import Position

import nctakt
from nctakt.base.failure import Failure
from nctakt.editor.display.hover import hover
from nctakt.editor.display.outline import document_symbols
from nctakt.editor.document import Document, split_text
from nctakt.editor.navigation import definition, rename
from nctakt.editor.server import Server


@pytest.fixture(scope="module")
def server() -> Server:
    return Server("en")


class Folder:
    """Programs in a folder, as an editor has them."""

    def __init__(self, server: Server, folder: Path) -> None:
        self.server, self.folder = server, folder

    def document(self, text: str, name: str = "part.nc") -> Document:
        path = self.folder / name
        path.write_text(text, "utf-8")
        return Document(path.as_uri(), path, path.as_posix(), "nctakt", 0, split_text(text))

    def renamed(self, text: str, at: str, new: str, *others: Document) -> str:
        """The texts of a program and of the others after renaming what follows ``at``."""
        document = self.document(text)
        loaded = self.server.work.machine_of(document)
        edit = rename(document, place(text, at), new, loaded, lambda: [document, *others])
        assert edit is not None
        texts = []
        for one in (document, *others):
            lines = list(one.lines)
            for change in reversed(edit.changes.get(one.uri, [])):
                start, end = change.range.start, change.range.end
                line = lines[start.line]
                lines[start.line] = (
                    line[: start.character] + change.new_text + line[end.character :]
                )
            texts.append("\n".join(lines))
        return "\n---\n".join(texts)

    def refused(self, text: str, at: str, new: str, *others: Document) -> str:
        with pytest.raises(Failure) as caught:
            self.renamed(text, at, new, *others)
        return caught.value.diagnostics[0].text()

    def defined(self, text: str, at: str) -> list[int]:
        document = self.document(text)
        loaded = self.server.work.machine_of(document)
        found = definition(document, place(text, at), loaded)
        return [location.range.start.line for location in found]


def place(text: str, at: str) -> Position:
    """The position after ``at``, which is there once."""
    assert text.count(at) == 1
    before = text[: text.index(at) + len(at)]
    return Position(before.count("\n"), len(before) - before.rfind("\n") - 1)


@pytest.fixture
def folder(server: Server, tmp_path: Path) -> Folder:
    return Folder(server, tmp_path)


LABELS = """\
%MAIN
N10 [LOOP] G01 X1 F100
/2 N20 [ ende ] M00
$IF P1 > 3 $GOTO [Loop]
$IF P1 > 4 $GOTO N030
% a comment inside the main program
N40 G310 X1 $GOTO [ENDE]
N30: X2
#COMMENT BEGIN
[LOOP] $GOTO [LOOP]
#COMMENT END
$GOTO[LOOP]
M30
%L SUB
[LOOP] $GOTO [LOOP]
M17
"""


def test_a_label_is_found_wherever_a_block_can_have_it(folder: Folder) -> None:
    """After a block number, a skip level, with blanks, in any letter case; not in a comment, not in
    another section; a ``%`` line inside the main program begins none."""
    assert folder.defined(LABELS, "> 3 $GOTO [L") == [1]
    assert folder.defined(LABELS, "X1 $GOTO [E") == [2]
    assert folder.defined(LABELS, "> 4 $GOTO N0") == [7]
    assert folder.defined(LABELS, "%L SUB\n[L") == [14]
    names = [one.name for one in document_symbols(folder.document(LABELS))[0].children]
    assert names == ["LOOP", "ENDE"]


def test_a_label_changes_at_all_its_places(folder: Folder) -> None:
    new = folder.renamed(LABELS, "N10 [L", "again")
    assert new == (
        LABELS.replace("N10 [LOOP]", "N10 [AGAIN]")
        .replace("[Loop]", "[AGAIN]")
        .replace("$GOTO[LOOP]", "$GOTO[AGAIN]")
    )
    assert "[Z1]" in folder.renamed(LABELS, "N10 [L", "Z1")  # no block number
    assert folder.renamed(LABELS, "$GOTO N0", "N7") == (
        LABELS.replace("$GOTO N030", "$GOTO N7").replace("N30:", "N7:")
    )
    assert "N7:" in folder.renamed(LABELS, "N3", "7")


def test_two_names_do_not_become_one(folder: Folder) -> None:
    """Labels, parameters, variables, IDs of cycles and subprograms; a label of another section is
    another one."""
    assert "ENDE is already in use, line 3" in folder.refused(LABELS, "N10 [L", "Ende")
    assert folder.renamed(LABELS, "%L SUB\n[L", "ENDE").count("ENDE") == 3
    text = "V.P.A = 1\nV.P.B = 2\nP1 = V.P.A\nP2 = 3\nM30\n"
    assert folder.refused(text, "= V.P.", "B") == (
        "B is already in use, line 2: the two would become one"
    )
    assert "P2 is already in use" in folder.refused(text, "V.P.B = 2\nP", "P2")
    cycles = (
        "#RT CYCLE DEF [ID=1 SCOPE=PROG]\n#RT CYCLE END\n#RT CYCLE DEF [ID=2 SCOPE=PROG]\n"
        "#RT CYCLE END\n#RT CYCLE START [ID=1]\nM30\n"
    )
    assert "2 is already in use" in folder.refused(cycles, "START [ID=", "2")
    calls = "%L A\nM17\n%L B\nM17\n%M\nLL A\nLL B\nM30\n"
    assert "B is already in use" in folder.refused(calls, "%M\nLL ", "B")


def test_an_invalid_name_is_refused_with_its_reason(folder: Folder) -> None:
    cycle = "#RT CYCLE [ID=1 SCOPE=PROG]\n#RT CYCLE END\nP1 = 2\nV.P.A = 1\nX1\nM30\n"
    assert "a name has letters" in folder.refused(LABELS, "N10 [L", "1A")
    assert "this label is a block number" in folder.refused(LABELS, "N3", "END")
    assert "the ID of a cycle is 1 … 2147483647" in folder.refused(cycle, "[ID=", "2147483648")
    assert "a parameter is P and a number" in folder.refused(cycle, "END\nP", "SIZE")
    assert "a name has letters" in folder.refused(cycle, "V.P.", "A-B")
    assert "cannot be the new name" in folder.refused(cycle, "V.P.", "")
    assert "it belongs to the demo machine" in folder.refused(cycle, "V.P.A = 1\n", "W")
    assert "it is the name of a file" in folder.refused("L sub.nc\nM30\n", "L s", "other")
    assert "the controller gives it" in folder.refused("P1 = V.RTG.TIMER[1]\n", "V.RTG.T", "A")


def test_what_a_computed_number_may_mean_is_not_renamed(folder: Folder) -> None:
    text = "P1 = 2\nP3 = P[P1]\nM30\n"
    assert "P[P1] in line 2 may mean P3" in folder.refused(text, "2\nP", "4")
    text = "#RT CYCLE [ID=1 SCOPE=PROG]\n#RT CYCLE END\n#RT CYCLE DELETE [ID=P1]\nM30\n"
    assert "in line 3 may mean 1" in folder.refused(text, "CYCLE [ID=", "4")


def test_a_name_of_a_program_changes_in_the_programs_that_it_calls(folder: Folder) -> None:
    """V.P and P parameters are those of the main program and of all that it calls (facts 2.4)."""
    sub = folder.document("P1 = V.P.A\nL deep.nc\nM17\n", "sub.nc")
    deep = folder.document("V.P.A = 3\nM17\n", "deep.nc")
    other = folder.document("V.P.A = 4\nM30\n", "other.nc")
    new = folder.renamed("V.P.A = 1\nL sub.nc\nM30\n", "V.P.", "SIZE", sub, deep, other)
    assert new.count("V.P.SIZE") == 3
    assert "V.P.A = 4" in new
    taken = folder.document("V.P.A = V.P.SIZE\nL sub.nc\nM30\n", "main.nc")
    text = "V.P.A = 1\nL sub.nc\nM30\n"
    assert "main.nc, line 1" in folder.refused(text, "V.P.", "SIZE", sub, deep, taken)


@pytest.mark.parametrize("word", ["G999", "M999", "H999", "G0999"])
def test_a_function_that_does_not_exist_is_not_explained(word: str, folder: Folder) -> None:
    """The channel list of the demo machine has no M999 and no H999."""
    document = folder.document(f"{word}\nM30\n")
    machine = folder.server.work.machine_of(document).machine
    assert hover(document, Position(0, 1), machine, [], "en") is None


def test_each_function_of_the_channel_list_is_explained(folder: Folder) -> None:
    document = folder.document("M100\n")
    machine = folder.server.work.machine_of(document).machine
    found = hover(document, Position(0, 1), machine, [], "en")
    assert found is not None
    assert "M function of the channel list" in found.contents.value


def test_a_variable_of_the_machine_changes_in_comments_that_are_read(folder: Folder) -> None:
    """``; expect:`` and ``; given:`` name it, too, and so it is renamed from there."""
    lists = Path(nctakt.__file__).parent / "machines" / "demo"
    shutil.copytree(lists, folder.folder / "lists", dirs_exist_ok=True)
    (folder.folder / "nctakt.toml").write_text('machine = "lists"\n', "utf-8")
    text = "; given: V.E.VALUE = 1\nV.E.VALUE = 3 ; a VALUE\nM30 ; expect: CH2.V.E.VALUE = 3\n"
    new = text.replace("V.E.VALUE", "V.E.SPEED")
    assert folder.renamed(text, "\nV.E.", "SPEED") == new
    assert folder.renamed(text, "given: V.E.", "SPEED") == new
