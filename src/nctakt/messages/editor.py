# SPDX-License-Identifier: MIT
"""Messages about the language server for editors."""

from __future__ import annotations

from nctakt.messages.catalogue import error

EDITOR_LIBRARY_MISSING = error(
    901290,
    en="nctakt lsp needs the library pygls, which is not installed",
    de="nctakt lsp braucht die Bibliothek pygls, sie ist nicht installiert",
    remedy_en='Install it: .venv/bin/pip install ".[editor]"',
    remedy_de='Installieren: .venv/bin/pip install ".[editor]"',
)
