# SPDX-License-Identifier: MIT
"""Whatever is in a document, each request is answered, at each position."""

from __future__ import annotations

import contextlib
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support.random_seeds import each_seed

pytest.importorskip("pygls", reason="the language server needs pygls (extra editor)")

from lsprotocol.types import Position

from nctakt.base.failure import Failure
from nctakt.editor import formatting, list_lines, navigation
from nctakt.editor.completing import completion
from nctakt.editor.display import colours, hints, hover, outline
from nctakt.editor.document import Document, split_text
from nctakt.editor.edits import remedies
from nctakt.editor.server import Server

PROGRAM = (
    *("%\n", "%", "%L\n", "%L X", "#RT CYCLE [ID=1 SCOPE=PROG]\n", "#RT CYCLE END\n", "$ENDIF\n"),
    *("$IF P1 > 3\n", "$ELSE\n", "G01 X10 (ä😀) Y20\n", "\tX1\r\n", '"text" ; ü\n', "(((", "\r"),
    *("V.E.COUNT = Vs.E.LIST[2].A\n", "[L] $GOTO [L]\n", "L CYCLE [NAME=x.nc @P1=", "P1,5\n"),
    *("#VAR\nV.P.A[3] : UNS32 = 4\n#ENDVAR\n", "#COMMENT BEGIN\n", "$SWITCH P1\n$CASE 1\n"),
    *("X1 \\\n", "V.", "V..", "V.E.", "Vs", "$", "#", "#RT ", "N", "N10:", "M30\n", "\x00"),
    *("; nctakt: ignore 900243\n", "\ufeff", "$IF EDG P1 = 3 THEN M100", "\r\n\r\n", "P1++\n"),
    *("V.E.NEW = 1\n", "V.CH.B=3\n", "Vs.E.😀", "X[INDP POS=", '#MSG ["a', "@P1"),
)
LIST = (
    *("var[0].name A\n", "var[0", "gruppe[0].achse[0].bezeichnung X\n", "# c\n", "Ende\n", "  \n"),
    *("x\t( y\n", "vch[0].name  ü\n", "<a>", '"q"\n', "\ufeff", "thread[0].name", "var[0].scope "),
)


@pytest.fixture(scope="module")
def server() -> Server:
    return Server("en")


@each_seed(40, 15)
def test_each_request_is_answered(seed: int, server: Server, tmp_path: Path) -> None:
    """Programs and lists, with any ends of lines, encodings of positions, half a word."""
    chance = random.Random(seed)
    is_list = chance.random() < 0.25
    path = tmp_path / ("ext_var.lis" if is_list else "part.nc")
    text = "".join(chance.choices(LIST if is_list else PROGRAM, k=chance.randrange(12)))
    encoding = chance.choice(("utf-16", "utf-8", "utf-32"))
    document = Document(path.as_uri(), path, str(path), "", 0, split_text(text), encoding)
    server.work.open(document)
    loaded = server.work.machine_of(document)
    machine, names = loaded.machine, loaded.machine.names
    found = server.work.check(document)

    def at() -> Position:
        return Position(chance.randrange(len(document.lines) + 2), chance.randrange(30))

    def renamed(position: Position, name: str) -> None:
        with contextlib.suppress(Failure):  # refused with its reason
            navigation.rename(document, position, name, loaded, lambda: [document])

    new = chance.choice(("A", "X1", "5", "N5", "ü"))
    count = len(document.lines)
    print_lines = list_lines.format_list if is_list else formatting.format_lines
    shown = [(item, server.shown(document, item)) for item in found]
    requests: tuple[Callable[[], Any], ...] = (
        lambda: hover.hover(document, at(), machine, found, "en"),
        lambda: completion.complete(document, at(), machine, "de"),
        lambda: navigation.definition(document, at(), loaded),
        lambda: navigation.references(
            document, at(), loaded, lambda: [document], with_definition=True
        ),
        lambda: navigation.highlights(document, at(), loaded),
        lambda: renamed(at(), new),
        lambda: outline.document_symbols(document),
        lambda: outline.folding_ranges(document),
        lambda: outline.selection_range(document, at()),
        lambda: colours.semantic_tokens(document, names, 0, count),
        lambda: hints.inlay_hints(document, found, names, range(count), "en"),
        lambda: hints.code_lenses(document, {1: 2, 500: 1}, "en"),
        lambda: list(hints.document_links(document, loaded)),
        lambda: hints.signature_help(document.line(0)[: chance.randrange(20)], "en"),
        lambda: remedies.actions(document, shown, loaded, "en"),
    )
    for request in requests:
        for _ in range(3):
            request()
    printed = print_lines(document.lines, 0, count)
    assert print_lines(printed, 0, count) == printed
    server.work.close(document.uri)


def test_a_program_without_a_name_folds(server: Server) -> None:
    """A program needs no ``%`` line."""
    lines = ["$IF P1 > 3", "X1", "$ENDIF", "M30"]
    document = Document("untitled:1", None, "1", "nctakt", 0, lines)
    assert [(fold.start_line, fold.end_line) for fold in outline.folding_ranges(document)] == [
        (0, 2)
    ]


def test_a_file_that_is_open_by_two_names_is_still_open_when_one_is_closed(
    server: Server, tmp_path: Path
) -> None:
    """A link and its file are one: the other one goes on to count."""
    path, link = tmp_path / "sub.nc", tmp_path / "link.nc"
    path.write_text("M17\n")
    link.symlink_to(path)
    first, second = (
        Document(own.as_uri(), own, str(own), "nctakt", 0, ["X1", "M17", ""])
        for own in (path, link)
    )
    server.work.open(first)
    server.work.open(second)
    server.work.close(second.uri)
    assert server.work.lines_of(path) == ["X1", "M17"]
    server.work.close(first.uri)
    assert server.work.lines_of(path) is None
