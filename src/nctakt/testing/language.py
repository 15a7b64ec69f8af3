# SPDX-License-Identifier: MIT
"""The language in which tests report failures."""

from __future__ import annotations

import os
from collections.abc import Iterable

from nctakt.base.diagnostics import LANGUAGE_VARIABLE, Diagnostic, Language


def language_of_tests() -> Language:
    """Return that of ``NCTAKT_LANGUAGE``, which ``nctakt test`` sets, else English as pytest's."""
    return "de" if os.environ.get(LANGUAGE_VARIABLE) == "de" else "en"


def rendered(diagnostics: Iterable[Diagnostic]) -> str:
    """Return diagnostics below each other, with their source lines and remedies."""
    language = language_of_tests()
    return "\n".join(found.render(language) for found in diagnostics)
