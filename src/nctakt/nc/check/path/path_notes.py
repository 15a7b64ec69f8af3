# SPDX-License-Identifier: MIT
"""Notes on settings of the path of which no public source settles all, once per program.

In: checked keywords of ``#CONTOUR MODE``, ``#HSC``, ``#SLOPE``, ``#VECTOR LIMIT``. Out: notes that
say what nctakt does.
"""

from __future__ import annotations

from collections.abc import Sequence

from nctakt.base.diagnostics import Text
from nctakt.messages.programs.checked_blocks import INVALID_COMMAND_FORM
from nctakt.nc.check.expressions import ValueChecker
from nctakt.nc.check.findings import Findings
from nctakt.nc.tree import Bracket, Expression, HashCommand, Keyword, Name, Number
from nctakt.nc.vocabulary.commands import forms_of
from nctakt.nc.vocabulary.path_keywords import HSC_MODES, HSC_NUMBERS, SLOPES
from nctakt.nc.vocabulary.simplifications import HSC_CONTOUR

_LIKE_DEV = Text(
    "each corner between two lines is rounded, as with DEV",
    "jede Ecke zwischen zwei Geraden wird wie bei DEV verschliffen",
)
_LIKE_DIST = Text(
    "as DIST with the distance PATH_DIST",
    "wie DIST mit dem Abstand PATH_DIST",
)
_LIKE_DIST_MASTER = Text(
    "as DIST with the distance SYM_DIST",
    "wie DIST mit dem Abstand SYM_DIST",
)
_OWN_CURVE = Text(
    "both halves of the curve are two cubics; without a point they meet where they bend evenly",
    "beide Kurvenhälften sind zwei Kubiken; ohne Punkt treffen sie sich, wo sie gleich krümmen",
)
_NOTHING = Text("it changes nothing", "es ändert nichts")
_AS_TRAPEZ = Text(
    "as TRAPEZ, whose ramps take the same time",
    "wie TRAPEZ, dessen Rampen gleich lange dauern",
)
_CONTOUR_NOTES = {
    "DIST_SOFT": _LIKE_DIST,
    "DIST_MASTER": _LIKE_DIST_MASTER,
    "POS": _OWN_CURVE,
    "AUTO_DEV": _LIKE_DEV,
    "PTP": _LIKE_DEV,
    "MAX_ANGLE": Text(
        "corners that change the direction by more degrees are not rounded",
        "Ecken mit größerer Richtungsänderung (Grad) werden nicht verschliffen",
    ),
    **dict.fromkeys(
        (
            "RELEVANT_PATH",
            "RELEVANT_TRACK",
            "TRACK_DEV",
            "TRACK_DIST",
            "ACC_MAX",
            "ACC_MIN",
            "RAMP_TIME",
            "DIST_WEIGHT",
            "MERGE",
            "CHECK_JERK",
            "CONST_VEL",
        ),
        _NOTHING,
    ),
}
#: Keywords of ``#HSC`` without an effect.
_IDLE_HSC_KEYWORDS = frozenset(HSC_NUMBERS) - {*HSC_MODES, "PATH_DEV", "MAX_ANGLE"}
_VECTOR_NOTES = {
    "DEC": Text(
        "the path speeds up and brakes with the lower one of ACC and DEC",
        "die Bahn beschleunigt und bremst mit dem kleineren Wert von ACC und DEC",
    ),
    "TRANS_ACC": _NOTHING,
}


def report_curve(command: HashCommand, name: str, findings: Findings) -> None:
    """Report once which contour ``#HSC ON`` has."""
    if name == "HSC ON":
        findings.report_simplified("#HSC", HSC_CONTOUR, command.span)


def report_simplified(
    command: str, item: Keyword, items: Sequence[Keyword | Expression], findings: Findings
) -> None:
    """Report what a keyword of a checked command does where the sources are silent."""
    meaning = None
    if command.startswith("#CONTOUR MODE"):
        meaning = _CONTOUR_NOTES.get(item.name)
        if item.name == "POST_DIST" and any(
            isinstance(other, Keyword) and other.name == "PRE_DIST" for other in items
        ):
            meaning = _OWN_CURVE
        command = "#CONTOUR MODE"
    elif command.startswith("#HSC") and item.name in _IDLE_HSC_KEYWORDS:
        meaning = _NOTHING
        command = "#HSC"
    elif command.startswith("#VECTOR LIMIT ON"):
        meaning = _VECTOR_NOTES.get(item.name)
        command = "#VECTOR LIMIT"
    elif command == "#SLOPE" and item.name == "NO_OPT":
        meaning = _NOTHING
    elif command == "#SLOPE" and isinstance(item.value, Name) and item.value.name in SLOPES[2:]:
        findings.report_simplified(f"#SLOPE [TYPE={item.value.name}]", _AS_TRAPEZ, item.span)
    if meaning is not None:
        findings.report_simplified(f"{command} [{item.name}]", meaning, item.span)


def check_old_slope(
    argument: Bracket | Keyword | Expression, values: ValueChecker, findings: Findings
) -> None:
    """Check the bracket of ``#SET SLOPE PROFIL [1]``; further arguments have no effect."""
    items = argument.items if isinstance(argument, Bracket) else ()
    if not items or any(isinstance(item, Keyword) for item in items):
        name = "#SET SLOPE PROFIL"
        findings.report(INVALID_COMMAND_FORM, argument.span, command=name, forms=forms_of(name))
        return
    for item in items:
        assert not isinstance(item, Keyword)
        values.value(item)
    first = items[0]
    if isinstance(first, Number) and int(first.value) in (2, 3):
        kind = SLOPES[int(first.value)]
        findings.report_simplified(f"#SET SLOPE PROFIL [{kind}]", _AS_TRAPEZ, first.span)
    for item in items[1:]:
        meaning = Text(
            "weights act on all ramps, whatever further arguments say",
            "Gewichtungen wirken auf alle Rampen, unabhängig von weiteren Argumenten",
        )
        findings.report_simplified("#SET SLOPE PROFIL", meaning, item.span)
