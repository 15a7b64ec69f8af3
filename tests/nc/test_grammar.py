# SPDX-License-Identifier: MIT
"""The grammar as text says what the code does."""

from __future__ import annotations

from importlib.resources import files

from nctakt.nc.parse.block_head import SKIP_LEVELS
from nctakt.nc.parse.controls import CONTROL_WORDS
from nctakt.nc.parse.expressions import EXPRESSION_DEPTH
from nctakt.nc.parse.hash_commands import CYCLE_ACTIONS
from nctakt.nc.parse.lexer import BLOCK_LENGTH, BLOCK_LENGTH_HARD
from nctakt.nc.parse.structure_stack import STRUCTURE_DEPTH
from nctakt.nc.vocabulary.operators import CONSTANTS, INFIX, PREFIX

GRAMMAR = files("nctakt.nc").joinpath("grammar.txt").read_text(encoding="utf-8")
TEXT = " ".join(GRAMMAR.split())


def test_the_grammar_states_the_limits_of_the_code() -> None:
    """Each bound is in the text as the code has it."""
    assert f"at most {BLOCK_LENGTH} characters (a warning), {BLOCK_LENGTH_HARD} can be" in TEXT
    assert f"at most {EXPRESSION_DEPTH} nodes high" in TEXT
    assert f"nest at most {EXPRESSION_DEPTH} deep" in TEXT
    assert f"At most {STRUCTURE_DEPTH} structures" in TEXT
    assert f"LEVEL is 1 to {SKIP_LEVELS}." in TEXT


def test_the_grammar_lists_the_operators_in_the_order_of_their_precedence() -> None:
    """RC-206: the line of the grammar and the table of the code agree."""
    groups: dict[int, list[str]] = {}
    for operator in INFIX.values():
        groups.setdefault(operator.precedence, []).append(operator.symbol)
    groups[PREFIX["-"].precedence] = ["(unary - and NOT are here)"]
    line = " ".join(" ".join(groups[strength]) for strength in sorted(groups, reverse=True))
    assert line in TEXT


def test_the_grammar_names_each_word_that_the_parser_knows() -> None:
    """Control words, actions of cycles and constants."""
    for word in (*CONTROL_WORDS, *CONSTANTS, *" ".join(CYCLE_ACTIONS).split()):
        assert f'"{word}"' in TEXT, word
