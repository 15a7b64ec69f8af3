# SPDX-License-Identifier: MIT
"""A request that cannot be carried out, as an exception that carries its diagnostics.

Raised where an input of a user (a file, an option, a machine, a PLC) makes it impossible to go on;
the command line turns it into an exit code, a program that uses nctakt as a library catches it.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Diagnostic


class Failure(Exception):
    """``diagnostics`` say what is wrong, at least one; the exception's text is theirs."""

    def __init__(self, *diagnostics: Diagnostic) -> None:
        assert diagnostics
        super().__init__("\n".join(diagnostic.render() for diagnostic in diagnostics))
        self.diagnostics = diagnostics
