# SPDX-License-Identifier: MIT
"""Constructs that nctakt runs and the controller refuses, or takes otherwise.

A program that uses one behaves differently on the machine, so ``nctakt check`` warns of each; the
table in ``docs/support.md`` is written from these rows.
"""

from __future__ import annotations

from typing import NamedTuple

from nctakt.base.diagnostics import Text


class Extension(NamedTuple):
    """A construct, and what the controller does with it."""

    construct: Text
    controller: Text


BUFFERED_MOTION = Extension(
    Text("BUFFERED of a single-axis command", "BUFFERED eines Einzelachsbefehls"),
    Text(
        "the manuals announce it and the controller does not have it",
        "die Handbücher kündigen es an, die Steuerung hat es nicht",
    ),
)
COMPOUND_ASSIGNMENT = Extension(
    Text("-=, *= and /=", "-=, *= und /="),
    Text("the manuals know += only", "die Handbücher kennen nur +="),
)
SCOPE_LEFT_OUT = Extension(
    Text("#RT CYCLE without SCOPE, taken as PROG", "#RT CYCLE ohne SCOPE, als PROG verstanden"),
    Text(
        "each example of the manuals has SCOPE, and none says what counts without it",
        "in den Handbüchern steht SCOPE immer, und nirgends, was ohne es gilt",
    ),
)
TEXT_IN_CYCLE = Extension(
    Text(
        "comparison and assignment of texts in a realtime cycle",
        "Vergleich und Zuweisung von Texten im Echtzeit-Zyklus",
    ),
    Text(
        "the controller knows no texts there (21981)",
        "die Steuerung kennt dort keine Texte (21981)",
    ),
)
COPY_IN_CYCLE = Extension(
    Text(
        "copy of a structure or array in a realtime cycle",
        "Kopie einer Struktur oder eines Feldes im Echtzeit-Zyklus",
    ),
    Text("the controller refuses it (21984)", "die Steuerung lehnt sie ab (21984)"),
)

#: All of them, as the document lists them.
EXTENSIONS = (
    SCOPE_LEFT_OUT,
    COMPOUND_ASSIGNMENT,
    BUFFERED_MOTION,
    TEXT_IN_CYCLE,
    COPY_IN_CYCLE,
)
