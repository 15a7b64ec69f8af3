# SPDX-License-Identifier: MIT
"""Structures, `#` commands, programs, limits and hostile input."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import overload

import pytest
from support.nc_trees import numbers, read, shape, statement, statements

from nctakt.base.text import decode_text, split_lines
from nctakt.messages import Collector
from nctakt.nc.parse.lexer import BLOCK_LENGTH, BLOCK_LENGTH_HARD, without_comments
from nctakt.nc.parse.parser import parse, parse_program
from nctakt.nc.parse.printer import format_items, print_program
from nctakt.nc.parse.structure_stack import STRUCTURE_DEPTH
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    Block,
    CycleControl,
    Flush,
    For,
    Goto,
    HashCommand,
    If,
    RealtimeCycle,
    Switch,
    Time,
    Timer,
    Unreadable,
    UserError,
    UserMessage,
    VariableDeclarations,
)

CYCLE = """N10 #RT CYCLE DEF[ID = 17 SCOPE = PROG]
N20 $IF ONCE Vs.CH.A < 1
  M100
  $IF V.E.B
    V.E.B = 0
  $ELSEIF V.E.C
  $ELSE
    M101
  $ENDIF
$ENDIF
N50 #RT CYCLE END"""


def test_a_realtime_cycle_holds_its_keywords_and_its_body() -> None:
    """RC-101: definition with DEF, keywords in order, statements inside."""
    cycle = statement(CYCLE)
    assert isinstance(cycle, RealtimeCycle)
    assert cycle.definition_only
    assert format_items(cycle.keywords) == "[ID=17 SCOPE=PROG]"
    (outer,) = cycle.body
    assert isinstance(outer, If)
    assert outer.frequency == "ONCE"
    assert outer.else_body is None
    inner = outer.body[1]
    assert isinstance(inner, If)
    assert inner.frequency is None
    assert len(inner.elseifs) == 1
    assert inner.else_body is not None


@pytest.mark.parametrize("frequency", ["ONCE", "EDGE", "ALWAYS", "once"])
def test_frequencies_qualify_if_and_elseif(frequency: str) -> None:
    """RC-203: the parser accepts a frequency on ``$ELSEIF`` too; the checker refuses it (22021)."""
    node = statement(f"$IF {frequency} P1\n$ELSEIF {frequency} P2\n$ENDIF")
    assert isinstance(node, If)
    assert node.frequency == node.elseifs[0].frequency == frequency.upper()


@pytest.mark.parametrize("action", ["START", "HOLD", "CONTINUE", "ABORT ACTION", "DELETE"])
def test_cycle_management(action: str) -> None:
    """RC-111: five actions, keywords in brackets."""
    control = statement(f"#RT CYCLE {action.lower()} [ID = P1 + 1]")
    assert isinstance(control, CycleControl)
    assert control.action == action
    assert format_items(control.keywords) == "[ID=P1 + 1]"


def test_a_conditional_jump_in_one_line_is_an_if_with_a_jump() -> None:
    """``$IF c $GOTO N20`` needs no ``$ENDIF``."""
    short, after = statements("$IF P1 > 2 $GOTO N020\nG0 X1")
    assert isinstance(short, If)
    (jump,) = short.body
    assert isinstance(jump, Goto)
    assert jump.label == "N20"
    assert isinstance(after, Block)


def test_loops_and_branches() -> None:
    """``$FOR`` has three bounds; ``$DEFAULT`` is the case without a value."""
    loop = statement("$FOR V.P.I = 0, P1 + 1, -2\nG0 X1\n$ENDFOR")
    assert isinstance(loop, For)
    switch = statement("$SWITCH P1\n$CASE 1\nG0\n$DEFAULT\n$CASE 2\n$ENDSWITCH")
    assert isinstance(switch, Switch)
    assert [case.value is None for case in switch.cases] == [False, True, False]


@pytest.mark.parametrize(
    ("text", "kind", "fields"),
    [
        ("#FLUSH", Flush, {"mode": None}),
        ("#flush wait", Flush, {"mode": "WAIT"}),
        ("#FLUSH CONTINUE", Flush, {"mode": "CONTINUE"}),
        ("#FLUSH SOMETIMES", HashCommand, {}),
        ("#FLUSH [WAIT]", HashCommand, {}),
        ("#TIME 1.5", Time, {}),
        ("#TIME [P1]", Time, {}),
        ("#TIME", HashCommand, {}),
        ("#TIMER START SYN [ID=1]", Timer, {"action": "START"}),
        ("#TIMER START [ID=1]", Timer, {"action": "START", "options": ()}),
        ("#TIMER", HashCommand, {}),
        ('#MSG SAVE EXCLUSIVE ["%d %f", P1, V.RTG.TIMER[P1]]', UserMessage, {}),
        ("#MSG SAVE", HashCommand, {}),
        ("#ERROR [ID=1 RC=2 PV1=P1]", UserError, {}),
        ("#ERROR ALL [ID=1]", HashCommand, {}),
        ("#CHANNEL INIT [CMDPOS]", HashCommand, {}),
    ],
)
def test_known_commands_have_nodes_and_others_stay_general(
    text: str, kind: type, fields: dict[str, object]
) -> None:
    """A known command in a form that it does not have stays for the checker to refuse."""
    node = statement(text)
    assert type(node) is kind
    for name, value in fields.items():
        assert getattr(node, name) == value


def test_declarations() -> None:
    """``#VAR``: dimensions, type, length of a text, initial value over several lines."""
    node = statement(
        '#VAR\nV.L.A\nV.P.B[2][3] : REAL64 = [1, 2, 3, \\\n4,\n5, 6]\nV.L.C:STRING[20]="X"\n#ENDVAR'
    )
    assert isinstance(node, VariableDeclarations)
    first, second, third = node.declarations
    assert first.type_name is None
    assert len(second.variable.parts[-1].indices) == 2
    assert (second.type_name, third.type_name) == ("REAL64", "STRING")
    assert third.size is not None


# --- programs ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "name", "main", "subprograms"),
    [
        ("G0 X1", "", 1, {}),
        ("%MAIN\nG0 X1", "MAIN", 1, {}),
        ("% my program \nG0 X1", "my program", 1, {}),
        ("%L A\nM17\n%L B (sub)\nG0\nM29\n%MAIN\nG0\nG1\nM30", "MAIN", 3, {"A": 1, "B": 2}),
        ("%MAIN\nM30\n%L A\nM17", "MAIN", 1, {"A": 1}),
        ("G0\n% comment\nG1\nM30\n%L A\nM17", "", 3, {"A": 1}),
        ("%MAIN\nG0\n%comment\nG1", "MAIN", 2, {}),
        ("%l a\nM17", "", 0, {"a": 1}),
        ("%\nG0", "", 1, {}),
    ],
)
def test_main_program_and_local_subprograms(
    text: str, name: str, main: int, subprograms: dict[str, int]
) -> None:
    """``%L name`` begins a subprogram before or after the main program, ``%`` mid-way comments."""
    program, diagnostics = read(text)
    assert diagnostics == []
    assert (program.name, len(program.statements)) == (name, main)
    assert {sub.name: len(sub.statements) for sub in program.subprograms} == subprograms


def test_blocks_that_cannot_be_read_keep_their_place() -> None:
    """They become nodes, with the label that a jump may lead to."""
    program, _ = read("M30\nN20: :::\n")
    unreadable = program.statements[1]
    assert isinstance(unreadable, Unreadable)
    assert unreadable.head.label == "N20"
    assert unreadable.text == "N20: :::"


@pytest.mark.parametrize("text", ["", "\n", "; comment", "#COMMENT BEGIN\nG0\n#COMMENT END"])
def test_an_empty_program_is_a_warning(text: str) -> None:
    """900109: nothing to run."""
    program, diagnostics = read(text)
    assert [found.id for found in diagnostics] == [900109]
    assert program.statements == ()


@pytest.mark.parametrize("end", [b"\n", b"\r\n", b"\r"])
@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
@pytest.mark.parametrize("last", [True, False])
def test_line_ends_and_encodings(end: bytes, mark: bytes, last: bool) -> None:
    """CRLF, LF and CR, with and without byte order mark, with and without a last line end."""
    data = mark + end.join([b"%MAIN", "G0 X1 (größer)".encode(), b"M30"]) + (end if last else b"")
    collector = Collector()
    program = parse_program(Source("a.nc", split_lines(decode_text(data).text)), collector)
    assert collector.diagnostics == []
    assert print_program(program) == "%MAIN\nG0 X1\nM30\n"


def test_diagnostics_come_in_the_order_of_the_text() -> None:
    """A structure that stays open is found at the end, and reported where it begins."""
    assert numbers("$IF P1\n:::\n$WHILE P2\nX=\n") == [20375, 20797, 20375, 900101]


def test_diagnostics_have_their_line_also_in_continued_blocks() -> None:
    """The place of a mistake is its own line, whichever line began the block."""
    _, diagnostics = read("G0 X1 \\\n  Y2 \\\n  Z::")
    (found,) = diagnostics
    assert found.span is not None
    assert (found.span.line, found.span.column, found.source_line) == (3, 4, "  Z::")


# --- bounds --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("length", "expected"),
    [
        (BLOCK_LENGTH - 1, []),
        (BLOCK_LENGTH, []),
        (BLOCK_LENGTH + 1, [900110]),
        (BLOCK_LENGTH_HARD, [900110]),
        (BLOCK_LENGTH_HARD + 1, [20301]),
        (1_000_000, [20301]),
    ],
)
@pytest.mark.parametrize("kind", ["blanks", "words", "comment", "brackets", "continued"])
def test_the_length_of_a_block_is_bounded(kind: str, length: int, expected: list[int]) -> None:
    """20301 beyond 4096 characters, a warning beyond 4000; a long line costs no more time."""
    if kind == "continued":
        parts = ["G0 \\"] + ["X1 X1 X1 X1 X1 X1 X1 X1 X1 \\"] * ((length - 3) // 28 - 1)
        rest = length - sum(len(part) for part in parts)
        text = "\n".join(parts) + "\n" + " " * (rest - 2) + "X1"
    else:
        filling = {"blanks": " ", "words": "X1", "comment": "(", "brackets": "["}[kind]
        begin = "; " if kind == "comment" else "G0 "
        text = begin + filling * length
        text = text[:length]
    found = [number for number in numbers(text) if number in (900110, 20301)]
    assert found == expected


@pytest.mark.parametrize(
    ("depth", "expected"),
    [(STRUCTURE_DEPTH - 1, []), (STRUCTURE_DEPTH, []), (STRUCTURE_DEPTH + 1, [20211])],
)
def test_structures_nest_up_to_the_limit(depth: int, expected: list[int]) -> None:
    """20211: structures inside each other are bounded, so that walking them may recurse."""
    text = "$IF P1\n" * depth + "G0 X1\n" + "$ENDIF\n" * depth
    assert numbers(text) == expected


def test_structures_far_beyond_the_limit_are_one_mistake() -> None:
    """What is too deep is left out of the tree, and reported once."""
    depth = 20_000
    program, diagnostics = read("$WHILE P1\n" * depth + "$ENDWHILE\n" * depth + "G0 X1")
    assert [found.id for found in diagnostics] == [20211]
    assert print_program(program).count("$WHILE") == STRUCTURE_DEPTH


def test_ends_that_fit_nothing_are_found_fast() -> None:
    """Hostile nesting takes no more than linear time."""
    depth = 20_000
    found = numbers("$WHILE 0\n" * depth + "$ENDIF\n" * depth + ":::\n" * depth)
    assert found.count(20218) == depth
    assert found.count(20375) == depth


@pytest.mark.nightly
@pytest.mark.slow
def test_a_realtime_cycle_may_have_very_many_statements() -> None:
    """The list of statements is no nesting: 100,000 of them in one cycle."""
    count = 100_000
    cycle = statement("#RT CYCLE [SCOPE=PROG]\n" + "V.E.A += 1\n" * count + "#RT CYCLE END")
    assert isinstance(cycle, RealtimeCycle)
    assert len(cycle.body) == count


def test_a_byte_0_ends_the_reading() -> None:
    """900108: a file that is no text gives one diagnostic, wherever the byte is."""
    binary = bytes(range(256)) * 1000
    lines = split_lines(decode_text(binary).text)
    collector = Collector()
    parse_program(Source("a.exe", lines), collector)
    assert [found.id for found in collector.diagnostics] == [900108]
    assert numbers("G0 X1\nG0 \0\n:::") == [900108]
    assert numbers("#COMMENT BEGIN\n\0\n:::") == [900108]
    assert numbers("G0 \\\n\0\n:::") == [900108]


class Counting(Sequence[str]):
    """Lines that are made when they are asked for, and count how many were."""

    def __init__(self) -> None:
        self.asked = 0

    def __len__(self) -> int:
        return 1_000_000

    @overload
    def __getitem__(self, index: int) -> str: ...
    @overload
    def __getitem__(self, index: slice) -> list[str]: ...
    def __getitem__(self, index: int | slice) -> str | list[str]:
        assert isinstance(index, int)
        return f"G1 X{index}"

    def __iter__(self) -> Iterator[str]:
        for index in range(len(self)):
            self.asked += 1
            yield self[index]


def test_lines_are_read_when_they_are_due() -> None:
    """The statements come one by one; a program need not fit into memory."""
    lines = Counting()
    found = parse(Source("big.nc", lines), Collector())
    first = next(found)
    assert isinstance(first, Block)
    assert lines.asked == 1
    next(found)
    assert lines.asked == 2


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("G0 X1", "G0 X1"),
        ("G0 (a) X1", "G0     X1"),
        ("G0 (a (b) c) X1", "G0           X1"),
        ("G0 (a (b) X1", "G0          "),
        ("G0 ; (a", "G0 "),
        ('G0 "(;" (x) ; y', 'G0 "(;"     '),
        ('G0 "open ; (x)', 'G0 "open ; (x)'),
        ("a) b", "a) b"),
    ],
)
def test_comments_become_blanks(line: str, expected: str) -> None:
    """Columns stay true; quotes protect, parentheses nest and may stay open."""
    assert without_comments(line) == expected


def test_trees_do_not_depend_on_their_place() -> None:
    """Blanks, comments and case change places and nothing else."""
    loose = "  n10   #rt  cycle  def [ id=17   scope=prog ] ; comment\n#Rt cYcle enD (x"
    tight = "N10#RT CYCLE DEF[ID=17SCOPE=PROG]\n#RT CYCLE END"
    tight = tight.replace("17SCOPE", "17 SCOPE").replace("=PROG", "=prog")
    assert shape(statements(loose)) == shape(statements(tight))
