# SPDX-License-Identifier: MIT
"""parse(print(tree)) == tree, for any tree that the parser can make."""

from __future__ import annotations

import dataclasses

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.nc_trees import read, shape

from nctakt.base.diagnostics import Span
from nctakt.nc import tree
from nctakt.nc.parse.printer import format_expression, print_program
from nctakt.nc.source import Source
from nctakt.nc.tree import (
    NO_HEAD,
    ArrayLiteral,
    Assignment,
    AxisWord,
    Binary,
    Block,
    Bracket,
    BracketCommand,
    Break,
    Call,
    Case,
    Constant,
    Continue,
    CycleControl,
    Declaration,
    Do,
    ElseIf,
    Expression,
    Flush,
    For,
    Goto,
    HashCommand,
    Head,
    If,
    Keyword,
    MacroDefinition,
    Name,
    Number,
    OffsetCommand,
    Parameter,
    Part,
    Program,
    RealtimeCycle,
    RealtimeLoop,
    Repeat,
    StringLiteral,
    StringWord,
    Subprogram,
    SubprogramCall,
    Switch,
    Time,
    Timer,
    Unary,
    UserError,
    UserMessage,
    Variable,
    VariableBlock,
    VariableDeclarations,
    While,
    Word,
)
from nctakt.nc.vocabulary.operators import FUNCTIONS, INFIX

SPAN = Span("", 1, 1, 2)

whole = st.integers(0, 10**6).map(lambda value: Number(SPAN, float(value)))
numbers = st.one_of(
    whole,
    st.floats(-1e12, 1e12, allow_nan=False).map(lambda value: Number(SPAN, value + 0.0)),
    st.floats(allow_nan=False, allow_infinity=False).map(lambda value: Number(SPAN, value + 0.0)),
)
texts = st.text(st.characters(exclude_characters='"\n\r\0', codec="utf-8"), max_size=8)
identifiers = st.from_regex(r"[A-Za-z_][A-Za-z_0-9]{0,6}", fullmatch=True)


def names(taken: tuple[str, ...]) -> st.SearchStrategy[Name]:
    """Bare words that are nothing else."""
    words = st.sampled_from(["BLOCK", "Global", "MOVE_CONT", "report.txt", "POS", "cmdpos", "Q"])
    return words.filter(lambda word: word not in taken).map(
        lambda word: Name(SPAN, word.upper(), word)
    )


def variables(index: st.SearchStrategy[Expression]) -> st.SearchStrategy[Variable]:
    part = st.builds(
        Part,
        st.just(SPAN),
        st.one_of(identifiers, identifiers.map(lambda name: "+" + name)),
        st.lists(index, max_size=2).map(tuple),
    )
    return st.builds(
        Variable,
        st.just(SPAN),
        st.sampled_from(["E", "CH", "P", "L", "RTA", "RTG", "G"]),
        st.lists(part, min_size=1, max_size=3).map(tuple),
        st.booleans(),
    )


def negated(operand: Expression) -> Expression:
    if isinstance(operand, Number):
        return Number(SPAN, -operand.value + 0.0)
    return Unary(SPAN, "-", operand)


def operations(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    one = [name for name, function in FUNCTIONS.items() if function.minimum == 1]
    return st.one_of(
        st.builds(Binary, st.just(SPAN), st.sampled_from(sorted(INFIX)), inner, inner),
        inner.map(negated),
        inner.map(lambda operand: Unary(SPAN, "NOT", operand)),
        st.builds(Call, st.just(SPAN), st.sampled_from(one), inner.map(lambda node: (node,))),
        st.builds(Call, st.just(SPAN), st.just("ATAN2"), st.tuples(inner, inner)),
        st.builds(Parameter, st.just(SPAN), inner, st.booleans()),
        variables(inner),
    )


def expressions(bare: bool) -> st.SearchStrategy[Expression]:
    leaves: list[st.SearchStrategy[Expression]] = [
        numbers,
        variables(whole),
        st.builds(Parameter, st.just(SPAN), whole, st.booleans()),
        st.builds(Constant, st.just(SPAN), st.sampled_from(["TRUE", "FALSE", "PI"])),
        texts.map(lambda text: StringLiteral(SPAN, text)),
    ]
    if bare:
        leaves.append(names(()))
    return st.recursive(st.one_of(leaves), operations, max_leaves=6)


values = expressions(bare=True)
word_values = expressions(bare=False)
lists = st.lists(values, min_size=2, max_size=4).map(lambda items: ArrayLiteral(SPAN, tuple(items)))
targets = st.one_of(variables(values), st.builds(Parameter, st.just(SPAN), values, st.booleans()))

keyword_names = st.sampled_from(
    ["ID", "SCOPE", "FEED", "POS", "G", "M", "S.POS", "PV1", "@P1", "OFF"]
)
keywords = st.builds(Keyword, st.just(SPAN), keyword_names, values)
flags = st.sampled_from(["INDP", "ABORTING", "STOP", "SYN"]).map(lambda name: Keyword(SPAN, name))
nested = st.lists(flags, min_size=1, max_size=2).map(
    lambda items: Keyword(SPAN, "LIST", None, tuple(items))
)
keyword_lists = st.lists(st.one_of(keywords, flags, nested), max_size=4).map(tuple)
item_lists = st.lists(st.one_of(keywords, flags, nested, word_values), max_size=4).map(tuple)

digits = st.integers(0, 999).map(lambda value: Number(SPAN, float(value)))
block_words = st.one_of(
    st.builds(
        Word, st.just(SPAN), st.sampled_from(["F", "S", "T", "S.POS", "S2", "FOO2"]), word_values
    ),
    st.builds(Word, st.just(SPAN), st.sampled_from("GMHTD"), digits, word_values),
    st.builds(
        Word,
        st.just(SPAN),
        st.just("G"),
        digits,
        st.none(),
        st.lists(values, min_size=1, max_size=3).map(tuple),
    ),
    st.builds(Word, st.just(SPAN), st.sampled_from(["FEED", "FOO"]), word_values),
    st.builds(AxisWord, st.just(SPAN), st.sampled_from(["X", "Y", "Z1", "XR", "C2"]), word_values),
    st.builds(
        BracketCommand,
        st.just(SPAN),
        st.sampled_from(["X", "Z1", "S2", "S", "M17"]),
        keyword_lists,
    ),
    texts.map(lambda text: StringWord(SPAN, text)),
)

heads = st.one_of(
    st.just(NO_HEAD),
    st.builds(
        Head,
        st.one_of(st.none(), whole),
        st.one_of(st.none(), st.integers(1, 10)),
        st.one_of(st.none(), st.sampled_from(["LOOP", "END_1"])),
    ),
    st.integers(0, 99).map(lambda value: Head(Number(SPAN, float(value)), None, f"N{value}")),
)


def node(kind: type, *fields: st.SearchStrategy) -> st.SearchStrategy:  # type: ignore[type-arg]
    return st.builds(kind, st.just(SPAN), heads, *fields)


options = st.lists(st.sampled_from(["SYN", "Save"]), max_size=2).map(
    lambda words: tuple(Name(SPAN, word.upper(), word) for word in words)
)
call_names = st.one_of(
    st.sampled_from(["UP1", "sub.nc", "C:\\dir\\a.nc", "a b.nc"]).map(
        lambda name: StringLiteral(SPAN, name)
    ),
    variables(whole),
)
call_words = st.lists(
    st.builds(AxisWord, st.just(SPAN), st.sampled_from("XYZ"), numbers), max_size=2
).map(tuple)
commands = st.builds(
    HashCommand,
    st.just(SPAN),
    heads,
    st.sampled_from([("KIN", "Id"), ("CS", "ON"), ("SLOPE",)]).map(
        lambda words: tuple(Name(SPAN, word.upper(), word) for word in words)
    ),
    st.lists(
        st.one_of(keywords, item_lists.map(lambda items: Bracket(SPAN, items))), max_size=3
    ).map(tuple),
)

simple_statements = st.one_of(
    node(Block, st.lists(block_words, min_size=1, max_size=5).map(tuple)),
    node(
        Assignment,
        targets,
        st.sampled_from(["=", "+=", "-=", "*=", "/="]),
        st.one_of(values, lists),
    ),
    node(VariableBlock, targets),
    node(MacroDefinition, texts, texts),
    node(SubprogramCall, st.booleans(), call_names, st.just(False), st.just(()), call_words),
    node(SubprogramCall, st.booleans(), call_names, st.just(True), keyword_lists, call_words),
    node(Goto, st.sampled_from(["N20", "LOOP"])),
    node(Break),
    node(Continue),
    node(
        CycleControl,
        st.sampled_from(["START", "HOLD", "CONTINUE", "ABORT ACTION", "DELETE"]),
        keyword_lists,
    ),
    node(Flush, st.sampled_from([None, "WAIT", "CONTINUE"])),
    node(Time, word_values),
    node(UserMessage, options, word_values, st.lists(word_values, max_size=2).map(tuple)),
    node(Timer, st.sampled_from(["START", "READ"]), options, keyword_lists),
    node(UserError, keyword_lists),
    node(
        OffsetCommand,
        st.sampled_from(["PSET", "PRESET", "SUPPRESS OFFSETS"]),
        st.one_of(st.just(()), keyword_lists),
        st.lists(block_words.filter(lambda word: not isinstance(word, StringWord)), max_size=3).map(
            tuple
        ),
    ),
    commands,
)
declarations = st.builds(
    Declaration,
    st.just(SPAN),
    heads,
    variables(whole),
    st.sampled_from([None, "REAL64"]),
    st.none(),
    st.one_of(st.none(), values, lists),
)
text_declarations = st.builds(
    Declaration,
    st.just(SPAN),
    heads,
    variables(whole),
    st.just("STRING"),
    whole,
    st.one_of(st.none(), texts.map(lambda text: StringLiteral(SPAN, text))),
)


def structures(inner: st.SearchStrategy) -> st.SearchStrategy:  # type: ignore[type-arg]
    body = st.lists(inner, max_size=3).map(tuple)
    frequencies = st.sampled_from([None, "ONCE", "EDGE", "ALWAYS"])
    branches = st.lists(
        st.builds(ElseIf, st.just(SPAN), heads, frequencies, values, body), max_size=2
    ).map(tuple)
    cases = st.lists(
        st.builds(Case, st.just(SPAN), heads, st.one_of(st.none(), values), body), max_size=3
    ).map(tuple)
    otherwise = st.one_of(st.none(), body)
    return st.one_of(
        node(If, frequencies, values, body, branches, otherwise, st.just(False)),
        node(If, st.none(), word_values, body, st.just(()), otherwise, st.just(True)),
        node(For, targets, values, values, values, body),
        node(While, values, body),
        node(RealtimeLoop, st.booleans(), body),
        node(Do, body, values),
        node(Repeat, body, values),
        node(Switch, values, cases),
    )


nested_statements = st.recursive(simple_statements, structures, max_leaves=4)
statements = st.one_of(
    nested_statements,
    node(
        VariableDeclarations,
        st.lists(st.one_of(declarations, text_declarations), max_size=3).map(tuple),
    ),
    node(
        RealtimeCycle,
        st.booleans(),
        keyword_lists,
        st.lists(nested_statements, max_size=3).map(tuple),
    ),
)
bodies = st.lists(statements, max_size=4).map(tuple)
programs = st.builds(
    Program,
    st.just(Source("", [])),
    st.sampled_from(["MAIN", "my program"]),
    st.lists(statements, min_size=1, max_size=4).map(tuple),
    st.lists(
        st.builds(Subprogram, st.just(SPAN), st.sampled_from(["UP1", "UP2"]), bodies), max_size=2
    ).map(tuple),
)


@pytest.mark.slow
@given(values)
@settings(max_examples=150, deadline=None)
def test_an_expression_is_read_as_it_is_printed(expression: Expression) -> None:
    """Brackets are wherever precedence needs them (RC-206)."""
    program, diagnostics = read(f"P1 = {format_expression(expression)}")
    assert diagnostics == []
    (assignment,) = program.statements
    assert isinstance(assignment, Assignment)
    assert shape(assignment.value) == shape(expression)


@pytest.mark.nightly
@pytest.mark.slow
@given(programs)
@settings(max_examples=60, deadline=None)
def test_a_program_is_read_as_it_is_printed(program: Program) -> None:
    """parse(print(tree)) == tree for statements of all kinds, inside each other."""
    text = print_program(program)
    again, diagnostics = read(text)
    assert [found.render() for found in diagnostics if found.id != 900118] == []
    assert shape(again) == shape(program)


@pytest.mark.slow
@given(st.lists(st.text(st.characters(codec="utf-8"), max_size=60), max_size=8))
@settings(max_examples=300, deadline=None)
def test_any_text_gives_diagnostics_inside_the_text(lines: list[str]) -> None:
    """No text makes the parser fail; each diagnostic is in a line that exists."""
    _check_places(lines)


FRAGMENTS = st.sampled_from(
    "#RT CYCLE|#RT CYCLE END|#RT CYCLE DEF[ID=1|$IF |$ELSE|$ENDIF|$FOR P1 = |$ENDFOR|#VAR|#ENDVAR"
    "|V.E.A|V.|P1|P[|[|]|=|+=|,|X|Y1.5|G01|M30|SIN[|NOT |-|**|&&|N10|N20:|/|/3|%|%L A"
    "|L CYCLE [NAME="
    '|LL UP|"|"a"|;|(|)|\\|#MSG [|#COMMENT BEGIN|#COMMENT END|$CASE |$SWITCH |$GOTO |@P1|S2[|INDP'
    "| |ONCE |1|.5|:|UNS32|$DO|$ENDDO |#IF |#ENDIF|#FLUSH|Vs.CH.B[1]|PI|TRUE".split("|")
)


@pytest.mark.slow
@given(st.lists(st.lists(FRAGMENTS, max_size=8).map("".join), max_size=12))
@settings(max_examples=300, deadline=None)
def test_any_mixture_of_the_language_gives_diagnostics_inside_the_text(lines: list[str]) -> None:
    """The same for texts that look like NC programs, and printing what was read succeeds."""
    _check_places(lines)


def _check_places(lines: list[str]) -> None:
    lines = [line for text in lines for line in text.split("\n")]
    program, diagnostics = read("\n".join(lines))
    for found in diagnostics:
        assert found.span is not None
        assert 1 <= found.span.line <= max(1, len(lines))
        assert 1 <= found.span.column < found.span.end_column <= len(found.source_line) + 2
        assert found.render("de")
        assert found.render("en")
    print_program(program)


#: What only mistakes, or lines with nothing to carry out, leave in a tree.
NEVER_PRINTED = {"ProgramStart", "Unreadable"}


def _fields_of(found: object, met: dict[str, dict[str, set[str]]]) -> None:
    """Note the values of each field of each node of a tree."""
    if isinstance(found, tuple):
        for item in found:
            _fields_of(item, met)
    if not dataclasses.is_dataclass(found) or isinstance(found, Span | Source):
        return
    fields = met.setdefault(type(found).__name__, {})
    for field in dataclasses.fields(found):
        value = getattr(found, field.name)
        fields.setdefault(field.name, set()).add(str(shape(value))[:80])
        _fields_of(value, met)


@pytest.mark.nightly
@pytest.mark.slow
def test_each_kind_of_node_and_each_field_is_among_the_trees() -> None:
    """Each node that the parser makes occurs, and each of its fields with several values."""
    met: dict[str, dict[str, set[str]]] = {}

    parts = st.one_of(simple_statements, block_words, declarations)
    branching = structures(simple_statements)
    many = st.lists(programs, min_size=2, max_size=3)

    @given(many, st.lists(parts, min_size=15), st.lists(branching, min_size=8))
    @settings(max_examples=12, deadline=None, derandomize=True, database=None)
    def gather(texts: list[Program], parts: list[object], branching: list[object]) -> None:
        _fields_of((*texts, *parts, *branching), met)

    gather()
    kinds = {
        name: kind
        for name, kind in vars(tree).items()
        if isinstance(kind, type)
        and kind.__module__.startswith(tree.__name__)
        and not kind.__subclasses__()
    }
    assert met.keys() == kinds.keys() - NEVER_PRINTED
    places = ("span", "else_span", "end_span", "source")
    constant = [
        f"{name}.{field}"
        for name, fields in met.items()
        for field, seen in fields.items()
        if len(seen) < 2 and field not in places
    ]
    assert constant == []
