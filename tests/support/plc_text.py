# SPDX-License-Identifier: MIT
"""Structured Text in tests: checked without files."""

from __future__ import annotations

from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.messages import Collector
from nctakt.st.inspection import inspect_texts
from nctakt.st.program import Program
from nctakt.st.reporting import Reporter
from nctakt.st.sources import Sources


def check(text: str | bytes, name: str = "cell.st") -> tuple[Program, list[Diagnostic]]:
    """Check a text; the program with all that was reported."""
    return check_files({name: text})


def check_files(
    texts: dict[str, str | bytes], libraries: list[str] | None = None
) -> tuple[Program, list[Diagnostic]]:
    """Check texts by their names."""
    collector = Collector()
    data = {
        name: text if isinstance(text, bytes) else text.encode("utf-8")
        for name, text in texts.items()
    }
    program = inspect_texts("Cell", data, Reporter(Sources(), collector), libraries=libraries)
    return program, collector.diagnostics


def errors(text: str | bytes, name: str = "cell.st") -> list[str]:
    """The errors of a text as ``line: text``."""
    return [
        f"{0 if found.span is None else found.span.line}: {found.text()}"
        for found in check(text, name)[1]
        if found.severity is Severity.ERROR
    ]


def body_errors(variables: str, body: str) -> list[str]:
    """The errors of a program with these variables and this body, which is on line 5 on."""
    text = f"PROGRAM MAIN\nVAR\n{variables}\nEND_VAR\n{body}\nEND_PROGRAM\n"
    return errors(text)


def messages(variables: str, body: str) -> list[str]:
    """All texts that are reported about a program with these variables and this body."""
    text = f"PROGRAM MAIN\nVAR\n{variables}\nEND_VAR\n{body}\nEND_PROGRAM\n"
    return [found.text() for found in check(text)[1]]


def pou_file(name: str, declaration: str, body: str, members: str = "") -> str:
    """A POU as its file in a project holds it."""
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n<TcPlcObject Version="1.1.0.1">\n'
        f'<POU Name="{name}" Id="{{0}}" SpecialFunc="None">\n'
        f"<Declaration><![CDATA[{declaration}]]></Declaration>\n"
        f"<Implementation><ST><![CDATA[{body}]]></ST></Implementation>\n"
        f"{members}</POU>\n</TcPlcObject>\n"
    )
