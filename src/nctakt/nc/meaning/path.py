# SPDX-License-Identifier: MIT
"""Words and keywords of commands of the path: contouring, splines, corners, groups of axes.

In: nodes of the tree. Out: their keywords and names, and the forms that their values have.
"""

from __future__ import annotations

from nctakt.base.dataclass import dataclass, field
from nctakt.base.whole_numbers import is_whole
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name
from nctakt.nc.vocabulary.path_keywords import (
    ACTIONS,
    CONTOUR_MODES,
    CONTOUR_NUMBERS,
    HSC_CURVES,
    HSC_NUMBERS,
    SLOPES,
    VECTOR_BLOCKS,
    VECTOR_LIMITS,
)

#: The word of the angle.
ANGLE_WORD = "#ANG"

#: Words with the size of a chamfer or rounding at the end of their block.
CORNER_SIZE_WORDS = ("#CHR", "#CHF", "#RND")

#: The feed of that.
CORNER_FEED_WORD = "#FRC"

#: Words after ``#FGROUP``.
FEED_GROUP_RADIUS, FEED_GROUP_WEAKEST = "ROT", "WAXIS"


def axis_and_factor(item: Keyword | Expression) -> tuple[str, Expression | None]:
    """Return name and factor in an item of a checked ``#FGROUP``."""
    assert isinstance(item, Keyword | Name)
    return item.name, item.value if isinstance(item, Keyword) else None


#: Values of G351 for an axis: mirrored, or not.
MIRROR_VALUES = (-1.0, 1.0)

#: Bounds of programmed overrides, %, and their keywords: of feed blocks, of rapid ones.
OVERRIDE_MIN_PCT, OVERRIDE_MAX_PCT = 0.1, 200.0

OVERRIDE_FACTORS = ("FEED_FACT", "RAPID_FACT")

#: Keywords of ``#TURN``.
TURN_KEYWORDS = (
    "ROT_FEED_CPL",
    "TIME_IN_REV_CPL",
    "TAPPING_ACT_POS",
    "TAPPING_N_CYCLES",
    "THREAD_CUT_ACT_SPEED",
    "THREAD_CUT_N_CYCLES",
    "THREAD_CUT_IGNORE_OV",
    "THREAD_CHAIN",
)


@dataclass(frozen=True, slots=True)
class Form:
    """The form of a command: words in brackets, keywords with a number, keywords with a word.

    ``defaults``: keywords with a number that may be left out.
    """

    words: tuple[str, ...] = ()
    numbers: tuple[str, ...] = ()
    names: dict[str, tuple[str, ...]] = field(default_factory=dict)
    defaults: tuple[str, ...] = ()
    needs_bracket: bool = True

    @property
    def keywords(self) -> tuple[str, ...]:
        """The items that may appear in its bracket."""
        every = (*self.words, *self.numbers, *self.defaults, *self.names)
        return tuple(dict.fromkeys(every))


#: The highest OPMODE of ``#HSC``; the lowest is 1.
HIGHEST_HSC_MODE = 2

#: Words of ``#DYNAMIC WEIGHT``: by the length of a motion, by the radius of an arc.
DYNAMIC_WEIGHTS = ("PATH", "CURVE")

#: Keywords of ``#CORNER PARAM`` with a number; all of them and UNIT are needed.
CORNER_NUMBERS = ("DIST", "FEED")

CONTOURING_FORM = Form(
    (*CONTOUR_MODES, *ACTIONS, "CHECK_JERK", "CONST_VEL"),
    (*(name for mode in CONTOUR_MODES.values() for name in mode), *CONTOUR_NUMBERS),
)

_HSC = Form(HSC_CURVES, HSC_NUMBERS)

#: The commands by their words.
PATH_COMMANDS = {
    "HSC": _HSC,
    "HSC ON": Form(_HSC.words, _HSC.numbers, needs_bracket=False),
    "HSC OFF": Form(_HSC.words, _HSC.numbers, needs_bracket=False),
    "CONTOUR MODE": CONTOURING_FORM,
    "CONTOUR MODE ON": Form(CONTOURING_FORM.words, CONTOURING_FORM.numbers, needs_bracket=False),
    "CONTOUR MODE OFF": Form(needs_bracket=False),
    "CORNER PARAM": Form(numbers=CORNER_NUMBERS, names={"UNIT": ("FWORD", "PERCENT")}),
    "DYNAMIC WEIGHT ON": Form(DYNAMIC_WEIGHTS),
    "DYNAMIC WEIGHT OFF": Form(DYNAMIC_WEIGHTS),
    "ROTATION ON": Form(numbers=("ANGLE", "CENTER1", "CENTER2"), needs_bracket=False),
    "ROTATION OFF": Form(needs_bracket=False),
    "SCALE OFF": Form(needs_bracket=False),
    "SET SLOPE PROFIL": Form(needs_bracket=False),
    "SLOPE": Form(numbers=("NO_OPT",), names={"TYPE": SLOPES}),
    "SLOPE DEFAULT": Form(needs_bracket=False),
    "OVERRIDE": Form(numbers=OVERRIDE_FACTORS),
    "TURN": Form(numbers=TURN_KEYWORDS),
    "VECTOR LIMIT ON": Form(VECTOR_BLOCKS, defaults=VECTOR_LIMITS),
    "VECTOR LIMIT ON ALL": Form(needs_bracket=False),
    "VECTOR LIMIT OFF": Form((*VECTOR_BLOCKS, *VECTOR_LIMITS), needs_bracket=False),
    "VECTOR LIMIT OFF ALL": Form(needs_bracket=False),
}


def command_name(command: HashCommand) -> str:
    """Return the words of a command."""
    return " ".join(word.name for word in command.words)


def keywords(command: HashCommand) -> tuple[Keyword, ...]:
    """Return the keywords in the brackets of a checked command."""
    return tuple(
        item
        for argument in command.arguments
        if isinstance(argument, Bracket)
        for item in argument.items
        if isinstance(item, Keyword)
    )


def is_hsc_value(keyword: str, value: float) -> bool:
    """Return whether a keyword of ``#HSC`` may have this value."""
    if keyword == "OPMODE":
        return is_whole(value, 1, HIGHEST_HSC_MODE)
    return value >= 0.0


def is_size(keyword: str, value: float, mode: str) -> bool:
    """Return whether a keyword of ``#CONTOUR MODE`` may have this value in a mode."""
    if keyword in ("PATH_DIST", "SYM_DIST") and value == -1.0:
        return True
    return value > 0.0 or (value == 0.0 and mode == "POS" and keyword in CONTOUR_MODES["POS"])


#: Words that switch, as written, with their meaning.
SWITCHES = {
    "#SPLINE ON": True,
    "#SPLINE OFF": False,
    "#SET SPLINE ON": True,
    "#SET SPLINE OFF": False,
}

#: Words of a direction, with whether it is that of the start.
VECTORS = {
    "#AKIMA STARTVECTOR": True,
    "#AKIMA ENDVECTOR": False,
    "#SET ASPLINE STARTTANG": True,
    "#SET ASPLINE ZIELTANG": False,
}

#: Commands without words of a block.
SPLINE_COMMANDS = frozenset(
    (
        "SPLINE TYPE AKIMA",
        "SPLINE TYPE BSPLINE",
        "SET SPLINETYPE AKIMA",
        "SET SPLINETYPE BSPLINE",
        "AKIMA TRANS",
        "SET ASPLINE MODE",
    )
)

TRANSITIONS = ("AUTO", "TANGENTIAL", "USER")


def transitions(command: HashCommand) -> tuple[str | Expression | None, str | Expression | None]:
    """Return start and end of ``#AKIMA TRANS`` or ``#SET ASPLINE MODE``; ``None``: not given.

    Raises ``ValueError`` for another form.
    """
    if not command.arguments:
        return (None, None)
    if len(command.arguments) > 1 or not isinstance(command.arguments[0], Bracket):
        raise ValueError
    items = command.arguments[0].items
    if command_name(command) == "SET ASPLINE MODE":
        if len(items) != 2 or any(isinstance(item, Keyword) for item in items):
            raise ValueError
        first, second = items
        assert isinstance(first, Expression)
        assert isinstance(second, Expression)
        return (first, second)
    found: dict[str, str | Expression | None] = {"START": None, "END": None}
    for item in items:
        if not isinstance(item, Keyword) or item.name not in found:
            raise ValueError
        if not isinstance(item.value, Name) or item.value.name not in TRANSITIONS:
            raise ValueError
        found[item.name] = item.value.name
    return (found["START"], found["END"])


def is_transition(number: float) -> bool:
    """Return whether a number, counted from 1, names one of ``TRANSITIONS``."""
    return is_whole(number, 1, len(TRANSITIONS))
