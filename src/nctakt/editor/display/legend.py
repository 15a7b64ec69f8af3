# SPDX-License-Identifier: MIT
"""The types and modifiers of semantic tokens, which an editor is given at the start."""

from __future__ import annotations

from lsprotocol.types import SemanticTokensLegend

TYPES = (
    "comment",
    "string",
    "number",
    "keyword",
    "macro",
    "function",
    "variable",
    "parameter",
    "property",
    "label",
    "class",
    "operator",
    "type",
    "enum",
    "enumMember",
    "method",
    "namespace",
)
MODIFIERS = ("realtime", "decoder", "frozen", "defaultLibrary", "readonly")
LEGEND = SemanticTokensLegend(list(TYPES), list(MODIFIERS))
