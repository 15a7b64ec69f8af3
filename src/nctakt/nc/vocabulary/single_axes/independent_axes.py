# SPDX-License-Identifier: MIT
"""Commands of programs for independent axes: ``X[INDP_SYN …]``, ``X[INDP_ASYN …]`` (SA-1 … SA-3).

In: the bracket of the tree. Out: an ``IndependentCommand``, and every mistake that can be found
without values. Checker and decoder read these commands through this module only.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from types import MappingProxyType

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Span, Text
from nctakt.messages.axes.independent_axes import AXIS_VALUE_INVALID, INDEPENDENT_SYNTAX
from nctakt.nc.tree import BracketCommand, Expression, Keyword, Number
from nctakt.nc.vocabulary.functions import ABSOLUTE, G_FUNCTIONS, LINE, RAPID, RELATIVE
from nctakt.nc.vocabulary.single_axes.axis_brackets import INDP_SYN, BracketReader
from nctakt.nc.vocabulary.single_axes.axis_commands import Finding

#: Keywords without and with a value.
VALUES = ("FEED", "TIME", "FEED_MAX_WEIGHT", "POS")
_SPEEDS = ("FEED", "TIME", "FEED_MAX_WEIGHT")
#: Keywords of the language that are refused; each has a row among the forms (``commands.py``).
REFUSED_KEYWORDS = MappingProxyType(
    {
        "SLOPE_TYPE": "SLOPE_TYPE",
        "SLOPE_PROFIL": "SLOPE_TYPE",
        "DRY_RUN": "DRY_RUN",
        "ACC_WEIGHT": "ACC_WEIGHT",
        "RAPID_ACC_WEIGHT": "ACC_WEIGHT",
        "M": "M",
        "H": "M",
        "G100": "G100",
    }
)
FLAGS = ("G90", "G91", "G00", "G01", "INCL_OFFSETS")
_MEASURING_LINE = 100
_G_WORDS = MappingProxyType(
    {float(number): G_FUNCTIONS[number].name for number in (ABSOLUTE, RELATIVE, RAPID, LINE)}
    | {float(_MEASURING_LINE): "G100"}
)

#: Reasons of message 21068.
_REASONS = MappingProxyType(
    {
        "G": Text("only G90, G91, G00 and G01 are possible", "möglich sind nur G90, G91, G00, G01"),
        "both": Text("either G90 or G91", "entweder G90 oder G91"),
        "neither": Text("G90 or G91 is missing", "G90 oder G91 fehlt"),
        "motions": Text("either G00 or G01", "entweder G00 oder G01"),
        "POS": Text("POS is missing", "POS fehlt"),
        "speeds": Text(
            "only one of FEED, TIME and FEED_MAX_WEIGHT",
            "nur eines von FEED, TIME und FEED_MAX_WEIGHT",
        ),
        "speed": Text(
            "G01 needs FEED, TIME or FEED_MAX_WEIGHT",
            "G01 braucht FEED, TIME oder FEED_MAX_WEIGHT",
        ),
        "rapid": Text(
            "G00 moves at rapid traverse, without FEED, TIME or FEED_MAX_WEIGHT",
            "G00 fährt im Eilgang, ohne FEED, TIME oder FEED_MAX_WEIGHT",
        ),
    }
)
#: The highest weight, percent.
MAX_WEIGHT = 100.0


@dataclass(frozen=True, slots=True)
class IndependentCommand:
    """The content of a command; absent parts are ``None`` or false.

    ``waits``: INDP_SYN. ``rapid``: neither G01 nor a speed, or G00. ``with_offsets``: INCL_OFFSETS.
    """

    axis: str
    form: str
    span: Span
    waits: bool
    absolute: bool
    rapid: bool
    speeds: Mapping[str, Expression]
    position: Expression | None
    with_offsets: bool

    def expressions(self) -> list[Expression]:
        """Return the values of the command, in the order of computation."""
        position = () if self.position is None else (self.position,)
        return [*self.speeds.values(), *position]


def read_independent(
    command: BracketCommand,
) -> tuple[IndependentCommand, list[Finding], list[tuple[str, Span]]]:
    """Return the command, its mistakes, and its keywords that are refused by name."""
    reader = _Reader(command)
    reader.read()
    return reader.command(), reader.findings, reader.refused


class _Reader(BracketReader):
    """Reads the keywords of one command."""

    syntax = INDEPENDENT_SYNTAX
    flags = FLAGS
    values = VALUES
    refusals = REFUSED_KEYWORDS

    def read(self) -> bool:
        """Note the keywords and their mistakes."""
        if not super().read():
            return False
        for reason in self._combination():
            self.wrong(_REASONS[reason])
        self._check_numbers()
        return not self.findings

    def name_of(self, item: Keyword) -> str:
        """Return the name of a keyword, of G functions with its number."""
        if item.name != "G":
            return item.name
        name = _G_WORDS.get(item.value.value, "") if isinstance(item.value, Number) else ""
        if not name:
            self.wrong(_REASONS["G"], item.span)
        return name

    def _combination(self) -> list[str]:
        """Return the reasons why the keywords do not fit together."""
        has = self.keywords.__contains__
        speeds = [name for name in _SPEEDS if has(name)]
        is_refused = {word for word, _ in self.refused}
        wrong = []
        if has("G90") and has("G91"):
            wrong.append("both")
        if has("G00") and has("G01"):
            wrong.append("motions")
        if not has("POS"):
            return wrong if "M" in is_refused else [*wrong, "POS"]
        if not has("G90") and not has("G91"):
            wrong.append("neither")
        if len(speeds) > 1:
            wrong.append("speeds")
        if has("G00") and speeds:
            wrong.append("rapid")
        if has("G01") and not speeds:
            wrong.append("speed")
        return wrong

    def _check_numbers(self) -> None:
        for name in _SPEEDS:
            value = self.value(name)
            if isinstance(value, Number) and not is_valid(name, value.value):
                values = {"word": name, "value": value.value}
                self.find(AXIS_VALUE_INVALID, value.span, **values, **self.named)

    def command(self) -> IndependentCommand:
        """Return the command."""
        values = {name: self.value(name) for name in _SPEEDS}
        speeds = {name: value for name, value in values.items() if value is not None}
        return IndependentCommand(
            self.bracket.name,
            self.form,
            self.bracket.span,
            self.form == INDP_SYN,
            "G90" in self.keywords,
            not speeds,
            speeds,
            self.value("POS"),
            "INCL_OFFSETS" in self.keywords,
        )


def is_valid(name: str, value: float) -> bool:
    """Return whether FEED, TIME or FEED_MAX_WEIGHT may have a value: above 0, a weight to 100."""
    return 0.0 < value < inf and (name != "FEED_MAX_WEIGHT" or value <= MAX_WEIGHT)
