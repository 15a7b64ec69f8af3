# SPDX-License-Identifier: MIT
"""A request that cannot be carried out, as an exception that carries its diagnostics.

Raised if an input of a user (a file, an option, a machine, a PLC) makes it impossible to continue;
the command line turns it into an exit code, a program that uses nctakt as a library catches it.
"""

from __future__ import annotations

from nctakt.base.diagnostics import Diagnostic, Language, Text

_OWN_ERROR = Text("internal error of nctakt", "interner Fehler von nctakt")


class Failure(Exception):
    """A request that cannot be carried out, with the reasons in ``diagnostics``, at least one.

    >>> try:
    ...     Controller("nowhere")
    ... except Failure as failure:
    ...     print(failure.diagnostics[0])
    error 900060: the machine folder nowhere does not exist
      remedy: Name a folder with a start-up list or a built-in machine: demo, demo5
    """

    def __init__(self, *diagnostics: Diagnostic) -> None:
        assert diagnostics
        super().__init__("\n".join(diagnostic.render() for diagnostic in diagnostics))
        self.diagnostics = diagnostics

    def __reduce__(self) -> tuple[type[Failure], tuple[Diagnostic, ...]]:
        """Return how to make it in another process."""
        return type(self), self.diagnostics


def error_text(error: Exception, language: Language = "en") -> str:
    """Return an error as shown to users: a ``Failure`` unchanged, an internal one on one line.

    That of a controller's process has come with its traceback, and is the last line of it.
    """
    if isinstance(error, Failure):
        return "\n".join(found.render(language) for found in error.diagnostics)
    lines = str(error).strip().splitlines() or [""]
    name = "" if len(lines) > 1 else f"{type(error).__name__}: "
    return f"{_OWN_ERROR.get(language)}: {name}{lines[-1]}"
