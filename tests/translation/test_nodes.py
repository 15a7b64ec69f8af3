# SPDX-License-Identifier: MIT
"""Nodes of Structured Text against Python's exact whole numbers and its texts (ST-302, ST-711)."""

from __future__ import annotations

import random
import struct
from fractions import Fraction

from support.random_seeds import each_seed

from nctakt.kernel.st import chains, kinds
from nctakt.kernel.st.blocks_of_bytes import FillBytes, MoveBytes
from nctakt.kernel.st.context import PlcContext
from nctakt.kernel.st.kept import WholeAfter
from nctakt.kernel.st.reals import (
    AddReal,
    LoadRealFixed,
    LoadRealFrame,
    MultiplyReal,
    NegateReal,
    Real,
    RealConstant,
    RoundToSingle,
    SubtractReal,
    WholeOfReal,
)
from nctakt.kernel.st.steps import CopyBytes, StoreAt, StoreFixed
from nctakt.kernel.st.text.conversions import RealOfString, StringOfReal
from nctakt.kernel.st.text.texts import ChangeString, FindString, PartOfString, StringPart
from nctakt.kernel.st.updates import updated
from nctakt.kernel.st.wholes import (
    AddWhole,
    AndBits,
    CompareUnsigned,
    DivideWhole,
    ElementPlace,
    FramePlace,
    InstancePlace,
    LoadAt,
    LoadElement,
    LoadFixed,
    LoadFrame,
    LoadInstance,
    MoveBits,
    MultiplyWhole,
    PointedPlace,
    SubtractWhole,
    Whole,
    WholeConstant,
    WrapWhole,
)

DATA, STACK = 512, 4096
FIRST = kinds.NULL_BYTES
MASK = (1 << 64) - 1
EDGES = (0, 1, -1, 2, 7, -7, 127, 128, 255, 65535, 1 << 31, -(1 << 31), 1 << 62, -(1 << 63))


def a_context() -> tuple[PlcContext, bytearray]:
    """A context and its memory: data, a stack, and the bytes after it."""
    memory = bytearray(FIRST + DATA + STACK + kinds.SLACK)
    return PlcContext(memory, FIRST + DATA, FIRST + DATA + STACK), memory


def signed(number: int) -> int:
    """The low 64 bits as a signed number."""
    return ((number + (1 << 63)) & MASK) - (1 << 63)


def cut_quotient(left: int, right: int) -> int:
    """A quotient cut towards zero, exactly."""
    return int(Fraction(left, right))


def operation(draw: random.Random, depth: int) -> tuple[Whole, int]:
    """A random expression: its node, and its value by Python."""
    if depth == 0:
        number = draw.choice(EDGES) if draw.random() < 0.5 else draw.randint(-1000, 1000)
        return WholeConstant(number), number
    left, a = operation(draw, depth - 1)
    right, b = operation(draw, depth - 1)
    match draw.randrange(6):
        case 0:
            return AddWhole(left, right), signed(a + b)
        case 1:
            return SubtractWhole(left, right), signed(a - b)
        case 2:
            return MultiplyWhole(left, right), signed(a * b)
        case 3 if b != 0:
            return DivideWhole(left, right, False, False), signed(cut_quotient(a, b))
        case 4 if b != 0:
            rest = (a & MASK) - (b & MASK) * ((a & MASK) // (b & MASK))
            return DivideWhole(left, right, True, True), signed(rest)
    bits = draw.choice((8, 16, 32))
    low = a & ((1 << bits) - 1)
    if draw.random() < 0.5:
        kind = {8: kinds.I8, 16: kinds.I16, 32: kinds.I32}[bits]
        return WrapWhole(left, kind), low - ((low >> (bits - 1)) << bits)
    turns = b - bits * (b // bits)
    rotated = ((low << turns) | (low >> (bits - turns))) & ((1 << bits) - 1)
    return MoveBits(left, WholeConstant(b), kinds.ROTATE_LEFT, bits), rotated


@each_seed(compiled=6, plain=3)
def test_whole_numbers_wrap_at_64_bits(seed: int) -> None:
    """ST-302, ST-503, ST-714: each operation is that of exact numbers, cut to 64 bits."""
    draw = random.Random(seed)
    context, _ = a_context()
    for _ in range(50):
        node, expected = operation(draw, draw.randint(1, 4))
        assert node.measure(context) == expected
        assert context.fault == 0


def test_signed_and_unsigned_compare_by_value() -> None:
    """ST-303: -1 < 18446744073709551615, though both have the same bits."""
    context, _ = a_context()
    both = WholeConstant(-1), WholeConstant(-1)
    assert CompareUnsigned(*both, kinds.LESS, False, True).measure(context) == 1
    assert CompareUnsigned(*both, kinds.EQUAL, False, True).measure(context) == 0
    assert CompareUnsigned(*both, kinds.EQUAL, True, True).measure(context) == 1


def test_real_to_whole_rounds_half_away_from_zero() -> None:
    """ST-307: 1.5 -> 2, 1.4 -> 1, -1.5 -> -2, -1.4 -> -1; outside: 902270."""
    context, _ = a_context()
    for number, expected in ((1.5, 2), (1.4, 1), (-1.5, -2), (-1.4, -1), (32767.4, 32767)):
        node = WholeOfReal(RealConstant(number), kinds.I16, kinds.NEAREST)
        assert node.measure(context) == expected
    assert WholeOfReal(RealConstant(32767.5), kinds.I16, kinds.NEAREST).measure(context) == 0
    assert context.fault == kinds.CONVERSION


def both_ways(draw: random.Random, depth: int) -> tuple[Real, Real]:
    """A random sum or product, as a chain where it can be one and as a tree of its operations."""
    match draw.randrange(5) if depth == 0 else 5:
        case 0 | 1:
            number = draw.choice((0.0, 1.5, -0.25, 1e300, float("inf"), draw.uniform(-9.0, 9.0)))
            return RealConstant(number), RealConstant(number)
        case 2:
            at = FIRST + 8 * draw.randrange(8)
            return (LoadRealFixed(at, kinds.F64, FIRST + DATA),) * 2
        case 3 | 4:
            kind, place = draw.choice((kinds.F32, kinds.F64)), 8 * draw.randrange(4)
            return (LoadRealFrame(place, kind),) * 2
    left, other_left = both_ways(draw, draw.randrange(depth))
    right, other_right = both_ways(draw, draw.randrange(depth))
    operation, tree = draw.choice(
        (
            (kinds.LINK_ADD, AddReal),
            (kinds.LINK_SUBTRACT, SubtractReal),
            (kinds.LINK_MULTIPLY, MultiplyReal),
        )
    )
    chain, node = chains.joined(operation, left, right), tree(other_left, other_right)
    match draw.randrange(6):
        case 0:
            return chains.rounded(chain), RoundToSingle(node)
        case 1:
            return NegateReal(chain), NegateReal(node)
    return chain, node


@each_seed(compiled=6, plain=3)
def test_a_chain_is_what_its_operations_are(seed: int) -> None:
    """ST-304, ST-305: to the bit; what is not a number stops the PLC, wherever it arises."""
    draw = random.Random(seed)
    faults = set()
    for _ in range(200):
        context, memory = a_context()
        for at in range(FIRST, FIRST + 64, 8):
            struct.pack_into("<d", memory, at, draw.uniform(-1e6, 1e6))
        for at in range(FIRST + DATA, FIRST + DATA + 40, 4):
            struct.pack_into("<f", memory, at, draw.uniform(-1e6, 1e6))
        chain, node = both_ways(draw, draw.randint(1, 6))
        found = struct.pack("<d", chain.measure(context)), context.fault
        context.fault = 0
        expected = struct.pack("<d", node.measure(context)), context.fault
        assert found[1] == expected[1]
        assert found[1] or found[0] == expected[0]
        faults.add(context.fault)
    assert faults == {0, kinds.INVALID}


def a_place(draw: random.Random, kind: int) -> tuple[Whole, Whole]:
    """A variable or an element: its address, and the node that reads it."""
    at = 8 * draw.randrange(8)
    index = draw.choice((WholeConstant(draw.randint(-3, 9)), LoadFrame(16, kinds.I8)))
    match draw.randrange(4):
        case 0:
            return WholeConstant(FIRST + at), LoadFixed(FIRST + at, kind, FIRST + DATA)
        case 1:
            return FramePlace(at), LoadFrame(at, kind)
        case 2:
            return InstancePlace(at), LoadInstance(at, kind)
    array = draw.choice((WholeConstant(FIRST + 128), FramePlace(64), WholeConstant(1 << 40)))
    parts = array, index, -2, 8, 8
    return ElementPlace(*parts), LoadElement(*parts, 0, kind)


@each_seed(compiled=6, plain=3)
def test_a_change_in_place_is_what_load_and_store_are(seed: int) -> None:
    """ST-311, ST-502, ST-830: to the byte, with all faults, whatever the variable is."""
    draw = random.Random(seed)
    faults = set()
    for _ in range(300):
        kind, other_kind = (draw.randint(kinds.I8, kinds.U64) for _ in range(2))
        address, loaded = a_place(draw, kind)
        operand = draw.choice((a_place(draw, other_kind)[1], WholeConstant(draw.choice(EDGES))))
        operator, tree = draw.choice(
            ((kinds.ADD, AddWhole), (kinds.SUBTRACT, SubtractWhole), (kinds.AND, AndBits))
        )
        content, results = draw.randbytes(DATA + 256), []
        max_steps = draw.choice((2, 3, 100))
        for step in (
            updated(address, kind, operator, operand, 7, 3),
            StoreAt(address, kind, tree(loaded, operand), 7, 3),
        ):
            context, memory = a_context()
            memory[FIRST : FIRST + len(content)] = content
            memory[FIRST + DATA + 16] = content[0] & 7
            context.instance = FIRST + 256
            context.max_steps = max_steps
            end = step.execute(context)
            faulty = context.fault, context.fault_source, context.fault_a
            results.append((end, context.steps, faulty, context.dump()))
        assert results[0] == results[1]
        faults.add(context.fault)
    assert faults == {0, kinds.BUDGET, kinds.INDEX, kinds.PLACE}


def test_the_index_of_an_element_is_evaluated_once() -> None:
    """ST-502: an index that assigns does so once, also where the element does not exist."""
    context, memory = a_context()
    count = LoadFixed(FIRST, kinds.I32, FIRST + DATA)
    counted = StoreFixed(FIRST, kinds.I32, AddWhole(count, WholeConstant(1)), 1, 1, FIRST + DATA)
    index = WholeAfter(counted, WholeConstant(9))
    LoadElement(WholeConstant(FIRST + 8), index, 0, 3, 4, 0, kinds.I32).measure(context)
    assert context.fault == kinds.INDEX
    assert memory[FIRST] == 1


@each_seed(compiled=3, plain=2)
def test_reals_are_written_as_short_as_they_read_back(seed: int) -> None:
    """ST-308: the text of a number reads back as the same number."""
    draw = random.Random(seed)
    for _ in range(20):
        number = draw.choice((-1, 1)) * draw.random() * 10.0 ** draw.randint(-300, 300)
        context, memory = a_context()
        node = StringOfReal(RealConstant(number), False, 0)
        text = memory[node.measure(context) :][:256].split(b"\0")[0].decode()
        assert float(text) == number
        assert len(text) <= len(repr(number)) + 20
        part = StringPart(WholeConstant(context.stack), kinds.MAX_TEXT)
        assert RealOfString(part).measure(context) == number


def python_change(text: bytes, inserted: bytes, function: int, length: int, position: int) -> bytes:
    """What ST-711 says of CONCAT, INSERT, DELETE and REPLACE, in Python."""
    length = max(length, 0)
    if function == kinds.CONCAT:
        return (text + inserted)[:255]
    if function == kinds.INSERT:
        position = max(position, 0)
        return (text[:position] + inserted + text[position:])[:255]
    begin = max(position, 1) - 1
    if function == kinds.DELETE:
        inserted = b""
    return (text[:begin] + inserted + text[begin + length :])[:255]


@each_seed(compiled=3, plain=2)
def test_texts_are_put_together_as_in_python(seed: int) -> None:
    """ST-711: positions from 1, what lies outside takes nothing, 255 bytes at most."""
    draw = random.Random(seed)
    for _ in range(30):
        context, memory = a_context()
        texts = [bytes(draw.choices(b"abc", k=draw.choice((0, 1, 3, 120)))) for _ in range(2)]
        for number, text in enumerate(texts):
            memory[FIRST + 200 * number : FIRST + 200 * number + len(text)] = text
        one, other = (StringPart(WholeConstant(FIRST + 200 * i), 150) for i in range(2))
        length, position = draw.randint(-2, 6), draw.randint(-2, 8)
        nodes = WholeConstant(length), WholeConstant(position)
        function = draw.choice((kinds.CONCAT, kinds.INSERT, kinds.DELETE, kinds.REPLACE))
        removed = nodes[0] if function in (kinds.DELETE, kinds.REPLACE) else Whole()
        inserted = StringPart(WholeConstant(FIRST + 500), 0) if function == kinds.DELETE else other
        at = ChangeString(one, inserted, removed, nodes[1], function, 0).measure(context)
        expected = python_change(texts[0], texts[1], function, length, position)
        assert memory[at : at + 256].split(b"\0")[0] == expected
        found = FindString(one, other).measure(context)
        assert found == (texts[0].find(texts[1]) + 1 if texts[1] else 0)
        at = PartOfString(one, *nodes, kinds.MID, 0).measure(context)
        begin = max(position, 1) - 1
        assert memory[at : at + 256].split(b"\0")[0] == texts[0][begin : begin + max(length, 0)]


@each_seed(compiled=5, plain=3)
def test_no_access_leaves_the_memory(seed: int) -> None:
    """ST-001, ST-315: whatever a pointer holds, bytes outside stay, and 902266 or 902267 comes."""
    draw = random.Random(seed)
    for _ in range(40):
        context, memory = a_context()
        pattern = bytes([170]) * kinds.NULL_BYTES
        memory[:FIRST] = pattern
        memory[context.end :] = bytes([170]) * (len(memory) - context.end)
        numbers = [
            draw.choice((0, 1, FIRST - 1, FIRST, context.end, context.end - 4, -1, 1 << 62,
                         -(1 << 63), draw.randint(FIRST, context.end)))
            for _ in range(3)
        ]  # fmt: skip
        size = draw.choice((0, 1, 8, 64, DATA))
        position = PointedPlace(WholeConstant(numbers[0]), size)
        element = ElementPlace(position, WholeConstant(numbers[1]), -5, 10, max(size, 8))
        count = WholeConstant(draw.choice((-1, 0, 1, 100, 1 << 40, -(1 << 63))))
        pointers = WholeConstant(numbers[0]), WholeConstant(numbers[2])
        match draw.randrange(5):
            case 0:
                LoadAt(element, 0, kinds.I64).measure(context)
            case 1:
                StoreAt(element, kinds.U8, WholeConstant(1), 1, 1).execute(context)
            case 2:
                CopyBytes(position, pointers[1], size, 1, 1).execute(context)
            case 3:
                MoveBytes(*pointers, count).measure(context)
            case 4:
                FillBytes(pointers[0], WholeConstant(1), count).measure(context)
        assert memory[:FIRST] == pattern
        assert not memory[context.end + 64 :].strip(b"\xaa")
        assert context.fault in (0, kinds.INDEX, kinds.PLACE)
