# SPDX-License-Identifier: MIT
"""Blocks with G351 and G68, factors of ``#SCALE``.

In: the tree of a block or a command. Out: diagnostics.
"""

from __future__ import annotations

from nctakt.messages.path.frames import INVALID_MIRROR_VALUE, INVALID_SCALE_FACTOR
from nctakt.messages.programs.checked_blocks import EXCLUSIVE_WORDS
from nctakt.nc.check.findings import Findings
from nctakt.nc.check.path.motion_words import CENTRE_WORDS, functions_of
from nctakt.nc.meaning.path import MIRROR_VALUES
from nctakt.nc.tree import AxisWord, Block, Number, OffsetCommand, Unary, Word
from nctakt.nc.vocabulary.function_rows import Group
from nctakt.nc.vocabulary.functions import MIRRORING_OF_AXES, ROTATION_ON, members


def check_mirrored_axes(block: Block, findings: Findings) -> None:
    """Report other words in a block with G351, and values that say neither on nor off."""
    functions = functions_of(block)
    if MIRRORING_OF_AXES not in functions:
        return
    name = f"G{MIRRORING_OF_AXES}"
    for word in block.words:
        if not isinstance(word, AxisWord):
            if word is not functions[MIRRORING_OF_AXES]:
                written = findings.written(word.span)
                findings.report(EXCLUSIVE_WORDS, word.span, word=written, other=name)
            continue
        value = _constant(word)
        if value is not None and value not in MIRROR_VALUES:
            findings.report(INVALID_MIRROR_VALUE, word.span, axis=word.name, value=value)


def check_rotation_block(block: Block, findings: Findings) -> None:
    """Report motions in a block with G68, whose axis words are the centre of rotation."""
    functions = functions_of(block)
    if ROTATION_ON not in functions:
        return
    motions = [functions[motion] for motion in members(Group.MOTION) if motion in functions]
    centres = [word for word in block.words if isinstance(word, Word) and word.name in CENTRE_WORDS]
    for word in motions + centres:
        written = findings.written(word.span)
        findings.report(EXCLUSIVE_WORDS, word.span, word=written, other=f"G{ROTATION_ON}")


def check_scale_factors(command: OffsetCommand, findings: Findings) -> None:
    """Report factors of ``#SCALE`` that are not above 0."""
    if command.name not in ("SCALE", "SCALE ON"):
        return
    for word in command.words:
        if not isinstance(word, AxisWord):
            continue
        value = _constant(word)
        if value is not None and value <= 0.0:
            findings.report(INVALID_SCALE_FACTOR, word.span, axis=word.name, value=value)


def _constant(word: AxisWord) -> float | None:
    """Return a number that is written as such, with or without a sign."""
    value, sign = word.value, 1.0
    while isinstance(value, Unary):
        sign = -sign if value.operator == "-" else sign
        value = value.operand
    return sign * value.value if isinstance(value, Number) else None
