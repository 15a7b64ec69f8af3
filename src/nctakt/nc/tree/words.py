# SPDX-License-Identifier: MIT
"""The words of a block."""

from __future__ import annotations

from nctakt.base.dataclass import dataclass
from nctakt.nc.tree.values import Expression, Keyword, Node


@dataclass(frozen=True, slots=True)
class BlockWord(Node):
    """One word of a block."""


@dataclass(frozen=True, slots=True)
class Word(BlockWord):
    """``G01``, ``F100``, ``S.POS=314``; ``value`` is ``None`` for a word without a value.

    ``additional``: the value of ``M110=130`` or ``G129=50``; ``arguments``: those of ``G805[1,
    2]``. Unknown words are kept as well.
    """

    name: str
    value: Expression | None
    additional: Expression | None = None
    arguments: tuple[Expression, ...] = ()


@dataclass(frozen=True, slots=True)
class AxisWord(BlockWord):
    """A word whose name may be that of an axis (first letter A B C Q U V W X Y Z): ``X10``,
    ``XR=5``.

    The checker decides whether the machine has that axis.
    """

    name: str
    value: Expression | None


@dataclass(frozen=True, slots=True)
class BracketCommand(BlockWord):
    """``X[INDP G90 POS=10]``, ``S2[M03 REV=1000]``, ``M17[MAIN]``."""

    name: str
    items: tuple[Keyword | Expression, ...]


@dataclass(frozen=True, slots=True)
class StringWord(BlockWord):
    """A quoted text in a block: the use of a macro."""

    text: str
