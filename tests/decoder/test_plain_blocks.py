# SPDX-License-Identifier: MIT
"""Plain blocks on their short way: the same commands, events and diagnostics as from the tree.

Every program is decoded in both ways, as a long one that is read from its text: once with the short
way (``decoder/fast/lines.py``), once with each block as a tree. Rows of the queue are compared as
bits.
"""

from __future__ import annotations

import random
import struct
from collections.abc import Generator, Sequence
from math import cos, radians, sin
from pathlib import Path

import pytest
from support.decoded_rows import rows
from support.random_seeds import each_seed

from nctakt.base.mode import is_compiled
from nctakt.decoder import program
from nctakt.decoder.fast import handover
from nctakt.kernel.tick.command_queue import CommandQueue
from nctakt.messages import Collector
from nctakt.nc import outline
from nctakt.nc.fast.plain_lines import EMPTY, OTHER, PLAIN, PlainScanner, shape_code
from nctakt.nc.parse.lexer import Lexer
from nctakt.nc.parse.parser import parse
from nctakt.nc.source import Source
from nctakt.nc.tree import AxisWord, Block, Number, Word
from nctakt.nc.vocabulary.entries import Support
from nctakt.nc.vocabulary.function_rows import Form, GFunction, Group
from nctakt.nc.vocabulary.functions import (
    AXIS_VALUES,
    CUTTING_SPEED,
    G_FUNCTIONS,
    POSITIVE_LIMIT,
)
from nctakt.run.controller import Controller, NcText

#: Lines of all kinds: plain ones, nearly plain ones, and those that change what plain ones mean.
OTHERS = (
    "",
    "   ",
    "; G01 X1",
    "(a (b) c)",
    "N30 (only a comment)",
    "G90",
    "G91",
    "G70",
    "G71",
    "G54",
    "G53",
    "G92 X3 Y-2",
    "G60 X1",
    "G93 F0.1",
    "G94",
    "G95",
    "G94 F9000",
    "#OVERRIDE [FEED_FACT=50]",
    "#OVERRIDE [FEED_FACT=100]",
    "#CS ON [1, 2, 0, 0, 0, 30]",
    "#CS OFF ALL",
    "X[OVERRIDE FEED_FACT=30]",
    "G166 X2",
    "G360",
    "G359",
    "G261",
    "G260",
    "G02 X4 Y3 R900",
    "G03 I5 J0\nG01",
    "X5 Y5",
    "G04 0.01",
    "F 2000",
    "F3000.5",
    "G01",
    "G00",
    "M100",
    "V.P.A = V.P.A + 1",
    "X = V.P.A",
    "X = 1 Y2",
    "X1.5 Y[1 + 1]",
    "/ X9",
    "/2 Y9",
    "N40: X2",
    "#CONTOUR MODE [DEV PATH_DEV = 0.2]",
    "#CONTOUR MODE ON",
    "#FLUSH WAIT",
    '#MSG ["hello %f", V.P.A]',
    "$IF V.P.A > 3\nX7\nG01 Y3\n$ENDIF",
    "$FOR V.P.I = 1, 3, 1\nX = V.P.I\n$ENDFOR",
    "X1 \\\nY2",
    "#COMMENT BEGIN\nX1\n#COMMENT END",
    "#SLOPE [TYPE=TRAPEZ]",
    "#SLOPE [TYPE=STEP]",
    "#FLUSH",
    "D3",
    "D0",
    "V.G.WZ_AKT.R = 0.01\nG41 G26",
    "G40",
)
#: Words that let motions wait for the next one.
SHAPES = (
    "X20 Y0\nG301 I0.5\nY20",
    "X0\nG302 I0.2",
    "G301 I0.1",
    "X1 Y60 #CHR=0.3",
    "X30 Y30 #RND=2",
    "G301 I0.1 F800",
    "#SPLINE TYPE AKIMA",
    "#AKIMA TRANS [START=TANGENTIAL END=AUTO]",
    "#AKIMA TRANS [START=AUTO END=TANGENTIAL]",
    "#SPLINE ON\nX10\nX12 Y4\nX15 Y5\nX19 Y5\n#SPLINE OFF",
    "G03 X4 Y3 R900\nG301 I0.2\nG01",
)
WRONG = (
    "X99999",
    "G01 X1 X2",
    "X",
    "Q5",
    "G01 G00 X1",
    "X1 0",
    "Y1..2",
    "N X1",
    "G17 G02 X1",
    "M99",
)
ENDS = ("M30", "", "%L SUB\nX1\nM17")


def number(chance: random.Random) -> str:
    """A number as programs write them."""
    digits = f"{chance.uniform(0, 150):.{chance.randrange(6)}f}"
    if chance.random() < 0.1:
        digits = f"{chance.random():.{chance.randrange(1, 18)}f}".lstrip("0")
    sign = chance.choice(("", "", "-", "+"))
    return sign + digits + chance.choice(("", "", "" if "." in digits else "."))


def plain_line(chance: random.Random) -> str:
    """A line that is mostly plain."""
    letters = chance.sample("XYZA", chance.randrange(1, 5))
    words = [f"{letter}{number(chance)}" for letter in letters]
    if chance.random() < 0.5:
        words.insert(chance.randrange(len(words) + 1), chance.choice(("G01", "G1", "G00", "G 0")))
    if chance.random() < 0.2:
        words.insert(chance.randrange(len(words) + 1), f"F{chance.randrange(9000)}.5")
    if chance.random() < 0.3:
        words.insert(0, f"N{chance.randrange(1, 100000)}")
    if chance.random() < 0.1:
        words.append(chance.choice(("; end", "(note)", "(open", "(a) ")))
    if chance.random() < 0.1:
        words.insert(chance.randrange(len(words) + 1), "(in (side))")
    line = chance.choice((" ", "", "\t", "  ")).join(words)
    return chance.choice(("", "", " ")) + (line.lower() if chance.random() < 0.1 else line)


def text(seed: int, others: Sequence[str] = OTHERS) -> str:
    """A program of all kinds of lines; some have a mistake in them."""
    chance = random.Random(seed)
    lines = ["#VAR", "V.P.A = 1", "V.P.I = 0", "#ENDVAR"]
    if chance.random() < 0.9:
        lines.append("G01 F6000")
    for _ in range(chance.randrange(5, 60)):
        lines.append(plain_line(chance) if chance.random() < 0.75 else chance.choice(others))
    if chance.random() < 0.3:
        lines.insert(chance.randrange(len(lines)), chance.choice(WRONG))
    lines.append(chance.choice(ENDS))
    return "\n".join(lines)


@pytest.fixture(autouse=True)
def long(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every program is a long one."""
    monkeypatch.setattr(outline, "KEPT_STATEMENTS", 0)


def by_tree(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each block is decoded from its tree."""

    def decode(_self: object, _reader: object, blocks: int) -> Generator[None, None, int]:
        return blocks
        yield

    monkeypatch.setattr(handover.PlainBlocks, "decode", decode)


def counted(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many commands each filling of the queue by plain blocks has added, as they come."""
    added: list[int] = []
    fill = handover.PlainBlocks.fill

    def count(blocks: handover.PlainBlocks, ring: CommandQueue, timed: int, tick: int) -> None:
        before = ring.timed_count
        fill(blocks, ring, timed, tick)
        added.append(ring.timed_count - before)

    monkeypatch.setattr(handover.PlainBlocks, "fill", count)
    return added


#: The modal functions that are not refused; G96 needs a face axis, which the demo has not.
MODAL = [
    row
    for row in G_FUNCTIONS.values()
    if row.group not in (None, Group.MOTION) and row.support is not Support.REFUSED
    if row.number != CUTTING_SPEED
    and (row.number not in AXIS_VALUES or row.number == POSITIVE_LIMIT)
]


@each_seed(8, 3)
def test_both_ways_give_the_same_commands(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Random programs: the rows of the queue are equal to the bit, and so are the diagnostics."""
    content = text(seed)
    short = rows(content)
    by_tree(monkeypatch)
    assert rows(content) == short


@each_seed(8, 3)
def test_both_ways_give_the_same_shapes(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """MO-4, MO-18: plain lines wait for chamfers, roundings and splines where one follows."""
    content = text(3000 + seed, OTHERS[:30] + 3 * SHAPES)
    water = 100_000 if seed % 2 else 1 + seed % 7
    short = rows(content, water)
    by_tree(monkeypatch)
    assert rows(content, water) == short


def test_only_lines_beside_a_corner_take_the_long_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """A chamfer slows down the line before it and the one after it, no other."""
    lines = [f"X{i} Y{i % 2 * 5}" for i in range(1, 20)]
    taken = counted(monkeypatch)
    content = "\n".join(["G01 F6000", *lines, "G301 I0.5", *lines, "M30"])
    assert len(rows(content)[0]) > 38
    assert sum(taken) == len(lines) - 1 + len(lines) - 2


@pytest.mark.nightly
@pytest.mark.slow
@pytest.mark.skipif(not is_compiled(), reason="the same in both modes")
def test_many_random_programs_are_in_order_and_full_of_plain_blocks(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The comparison is worth something: rows of both ways in most of its programs."""
    taken = counted(monkeypatch)
    found = [len(rows(text(seed))[0]) for seed in range(30)]
    assert sum(count > 5 for count in found) > 15
    assert 0.5 * sum(found) < sum(taken) < 0.95 * sum(found)


@pytest.mark.nightly
@pytest.mark.slow
@pytest.mark.parametrize("row", MODAL, ids=lambda row: row.name)
def test_plain_blocks_follow_the_table_of_functions(
    row: GFunction, monkeypatch: pytest.MonkeyPatch
) -> None:
    """While a modal function is active that is not ``plain``, no block takes the short way."""
    forms = {Form.ZERO_OFFSET: "G159=1", Form.AXIS_WEIGHTS: f"{row.name} X50"}
    forms |= {Form.AXIS_VALUES: f"{row.name} X50", Form.MIRRORED_AXES: "G351 Z-1\nG01"}
    word = forms.get(row.form, row.name)
    lines = ["#CORNER PARAM [DIST=1 UNIT=PERCENT FEED=50]", "M3 S600", "G01 F60 G26"]
    lines += ["V.G.WZ_AKT.R = 0.01", f"{word} F60", "Y1"]
    lines += [f"X{10 * i} Y{i % 2 * 5}" for i in range(1, 8)]
    content = "\n".join([*lines, "G40 X0 Y0", "M30"])
    taken = counted(monkeypatch)
    short = rows(content)
    assert len(short[0]) > 7
    assert (sum(taken) > 0) is row.plain
    by_tree(monkeypatch)
    assert rows(content) == short


@each_seed(8, 3)
def test_the_queue_is_filled_as_far(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Decoding stops at the same block when the queue is full (what is read later, is later)."""
    content = text(1000 + seed)
    water = 1 + seed % 7
    short = rows(content, water)
    by_tree(monkeypatch)
    assert rows(content, water) == short


@each_seed(8, 3)
def test_both_ways_mark_the_same_blocks(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each block has its mark, and what is in force changes where it does."""
    content = text(4000 + seed, OTHERS[:30] + 3 * SHAPES if seed % 2 else OTHERS)
    water = 100_000 if seed % 3 else 1 + seed % 7
    short = rows(content, water, marks=True)
    by_tree(monkeypatch)
    assert rows(content, water, marks=True) == short


def test_marked_blocks_take_the_short_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """All but the first, and those that change between G00 and G01."""
    lines = [f"N{i} X{i} Y{i % 2 * 5}" for i in range(1, 20)]
    taken = counted(monkeypatch)
    rows("\n".join(["G01 X0.5 F6000", *lines, "G00 X0.7", *lines, "M30"]), marks=True)
    assert sum(taken) == 2 * len(lines)


@each_seed(6, 2)
def test_both_ways_run_the_same(seed: int, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Whole runs: trace, events with their places, diagnostics, messages."""
    content = text(2000 + seed)
    found = []
    for _ in range(2):
        run = Controller().run(
            NcText("p.nc", content), ticks=3000, skip=(2,), blocks=bool(seed % 2)
        )
        assert run.trace is not None
        found.append((run.state, run.ticks, run.diagnostics, list(run.trace.events), run.messages))
        by_tree(monkeypatch)
    assert found[0] == found[1]


def contour(seed: int) -> str:
    """A program that goes beside a contour, mostly in plain lines."""
    chance = random.Random(seed)
    lines = ["G01 F6000", f"V.G.WZ_AKT.R = {chance.choice((0.2, 1, 3))}"]
    lines += [chance.choice(("", "G360", "#SLOPE [TYPE=TRAPEZ]", "G261", "G94 F700"))]
    lines += [chance.choice(("G25", "G26", "G138", "G237", "G239", "G91"))]
    lines += [chance.choice(("G41", "G42", "G41 G26", "G42 G18", "G41 G19"))]
    axes = {"8": "ZX", "9": "YZ"}.get(lines[-1][-1], "XY")
    x = y = z = course = 0.0
    for _ in range(chance.randrange(10, 90)):
        course += radians(chance.choice((2, 2, 20, 60, 100)) * chance.uniform(-1, 1))
        size = chance.choice((0.5, 8, 30))
        x, y = x + size * cos(course), y + size * sin(course)
        if lines[3] == "G91":
            x, y = size * cos(course), size * sin(course)
        line = f"{axes[0]}{x:.3f} {axes[1]}{y:.3f}"
        kind = chance.randrange(60)
        if kind < 8:
            z += 0.3
            line += f" {next(iter(set('XYZ') - set(axes)))}{z:.1f}"
        if kind == 10:
            line = "A5"
        elif kind == 11:
            line = chance.choice(("M100", "F900", "G04 0.01", "V.P.A = 3", "; only this", ""))
        elif kind == 12:
            line = chance.choice((f"G00 {line}\nG01", f"G02 {line} R300\nG01", f"N7 {line} ; note"))
        elif kind == 13:
            line = chance.choice(("G40", "G41", "G42", "G26", "G25", "V.G.WZ_AKT.R = 0.7", "G141"))
        lines.append(line)
    lines += ["G40", f"{axes[0]}{x + 50:.3f}", "X1 Y1 Z1", "M30"]
    return "\n".join(["#VAR", "V.P.A = 1", "#ENDVAR", *lines])


@each_seed(8, 3)
def test_both_ways_give_the_same_contours(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """MO-9: random contours beside which the tool goes, with what interrupts them."""
    content = contour(seed)
    water = 100_000 if seed % 2 else 1 + seed % 7
    short = rows(content, water)
    by_tree(monkeypatch)
    assert rows(content, water) == short


@pytest.mark.nightly
@pytest.mark.slow
@pytest.mark.skipif(not is_compiled(), reason="the same in both modes")
def test_contours_are_full_of_plain_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    """The comparison is worth something: most ways are put into the queue directly."""
    taken = 0
    fill = handover.PlainBlocks.fill

    def count(blocks: handover.PlainBlocks, ring: CommandQueue, timed: int, tick: int) -> None:
        nonlocal taken
        before = ring.timed_count
        fill(blocks, ring, timed, tick)
        taken += ring.timed_count - before

    monkeypatch.setattr(handover.PlainBlocks, "fill", count)
    found = [rows(contour(seed)) for seed in range(20)]
    wrong = [one.id for _, diagnostics in found for one in diagnostics]
    assert {900950, 90019} <= set(wrong)
    assert taken > 0.5 * sum(len(queue) for queue, _ in found)


@pytest.mark.parametrize(("back", "number"), [("Y18", 900950), ("Y20", 90123)])
def test_a_contour_that_is_damaged_is_reported_at_its_line(
    back: str, number: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Diagnostics have the places of plain blocks that are over by now, without their comments.

    Back to where it began the contour is a closed one with an inner corner there. The way to it
    leads across the last side, to X10.
    """
    content = "\n".join(
        (
            "V.G.WZ_AKT.R = 2\nG01 F6000 X5\nY1\nG41\nX20 Y20\nX60 ; the side that is crossed",
            f"F3000\nY50\nX20 Y50\n  N9 {back} (back)\nX10\nG40\nX0 Y0\nX3\nM30",
        )
    )
    found = rows(content)
    places = [(one.id, str(one.span)) for one in found[1]]
    assert places == [(number, "p.nc:10:6"), (901964, "p.nc:5:1")]
    assert found[1][0].span is not None
    assert found[1][0].span.end_column == 9
    by_tree(monkeypatch)
    assert rows(content) == found


def test_blocks_that_the_short_way_does_not_take_are_reported_from_the_tree() -> None:
    """Software limits (120002), a missing feed (20008): with the place of their word or block."""
    lines = "G01 F100\nX1\nX99999\n"
    assert [str(one.span) for one in rows(lines)[1]] == ["p.nc:3:1"]
    assert [one.id for one in rows(lines)[1]] == [120002]
    found = rows("G90\nG00 X1 G93\n  G01 X2\n")[1]
    assert [(one.id, str(one.span)) for one in found] == [(20008, "p.nc:3:3")]


def test_blocks_without_time_are_counted_on_both_ways(monkeypatch: pytest.MonkeyPatch) -> None:
    """A bounded number of blocks in a row takes no time (900303), whichever way they go."""
    monkeypatch.setattr(program, "MAX_BLOCKS_WITHOUT_TIME", 20)
    assert rows("G01 F100\n" + "F100\n" * 18 + "X1\nM30")[1] == []
    short = rows("G01 F100\n" + "F100\n" * 30)
    assert [(one.id, str(one.span)) for one in short[1]] == [(900303, "p.nc:21:1")]
    by_tree(monkeypatch)
    assert rows("G01 F100\n" + "F100\n" * 30) == short


# --- the scanner --------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(20))
def test_numbers_are_those_of_float(seed: int) -> None:
    """Up to 15 digits a number is what ``float`` reads, to the last bit and with its sign."""
    chance = random.Random(seed)
    scanner = PlainScanner(["X"])
    for _ in range(2000):
        whole = "".join(chance.choices("0123456789", k=chance.randrange(9)))
        part = "".join(chance.choices("0123456789", k=chance.randrange(9)))
        digits = chance.choice(("", "-", "+")) + whole + chance.choice((".", "." + part, ""))
        what = scanner.read(f"X{digits}")
        count = sum(one.isdigit() for one in digits)
        assert what == (PLAIN if 0 < count <= 15 else OTHER), digits
        if what == PLAIN:
            assert struct.pack("d", scanner.values[0]) == struct.pack("d", float(digits))


def words_of(scanner: PlainScanner, axes: str) -> dict[str, float]:
    """What the scanner has read, by letter."""
    found = {axis: scanner.values[i] for i, axis in enumerate(axes) if scanner.axes >> i & 1}
    if scanner.motion >= 0:
        found["G"] = scanner.motion
    if scanner.has_feed:
        found["F"] = scanner.feed
    return found


@pytest.mark.parametrize("seed", range(30))
def test_the_scanner_reads_what_the_parser_reads(seed: int) -> None:
    """Words, numbers, column and shape of each plain line are those of its tree."""
    chance = random.Random(3000 + seed)
    scanner = PlainScanner(["X", "Y", "Z", "A"])
    plain = 0
    for _ in range(300):
        line = plain_line(chance)
        if chance.random() < 0.3:
            place = chance.randrange(len(line) + 1)
            line = line[:place] + chance.choice(' XN.-;()[]=1:%#/\0\\"gF\xa0') + line[place:]
        what = scanner.read(line)
        source = Source("p.nc", [line])
        collector = Collector()
        if what == EMPTY:
            assert list(Lexer(source, collector).blocks()) == []
        if what != PLAIN:
            continue
        plain += 1
        statements = list(parse(source, collector))
        assert not collector.diagnostics, line
        assert len(statements) == 1, line
        block = statements[0]
        assert isinstance(block, Block)
        assert block.span.column == scanner.column, line
        number = block.head.number
        value = 0 if number is None else number.value  # type: ignore[attr-defined]
        assert value == scanner.number
        words: dict[str, float] = {}
        shape: list[str | float] = []
        for word in block.words:
            assert isinstance(word, AxisWord | Word)
            assert isinstance(word.value, Number)
            words[word.name] = word.value.value
            shape += [word.name, word.value.value] if word.name == "G" else [word.name]
        assert words == words_of(scanner, "XYZA"), line
        assert shape_code(shape) == scanner.shape, line
    assert plain > 100


@pytest.mark.parametrize(
    "line",
    [
        *("X1=2", "X1 0", "X", "X-", "X.", "X1 Y", "G02 X1", "G1.5 X1", "X1 X2", "G01 G01 X1"),
        *("N1", "N1: X1", "N0 X1", "N1 [A] X1", "/X1", "X1 \\", "%1", "X1 ;\0", "X1 (\0", "Q1"),
        *("X1\xa0", "X\xbd", "X\u0661", "N1234567890123456 X1", "X1234567890123456", "L1 X1"),
        "X" + "1" * 4000,
    ],
)
def test_whatever_is_not_plain_is_left_to_the_parser(line: str) -> None:
    """Nothing is guessed: what the short way does not know has a meaning or a mistake elsewhere."""
    assert PlainScanner(["X", "Y"]).read(line) == OTHER


def test_shapes_that_no_plain_block_has_have_no_code() -> None:
    """Only one-letter words, G00 and G01 count, and not more than twelve."""
    assert shape_code(("X1",)) == 0
    assert shape_code(("G", 2.0, "X")) == 0
    assert shape_code(tuple("XYZABCUVWXYZF")) == 0
    assert len({shape_code(one) for one in (("X",), ("X", "Y"), ("G", 0.0), ("G", 1.0))}) == 4


def test_all_statements_of_a_skipped_line_are_skipped() -> None:
    """A skip level is that of the whole block."""
    text = '/V.P.A = 1 V.P.A = 2\n#MSG ["%d", V.P.A]\nM30'
    run = Controller().run(NcText("p.nc", f"V.P.A = 7\n{text}"), skip=[1])
    assert [one.text for one in run.messages] == ["7"]
    run = Controller().run(NcText("p.nc", f"V.P.A = 7\n{text}"))
    assert [one.text for one in run.messages] == ["2"]
