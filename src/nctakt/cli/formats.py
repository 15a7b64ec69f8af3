# SPDX-License-Identifier: MIT
"""What a check has found, as text for a person and in the formats of other tools.

In: ``CheckResult``, language, the folder that paths are relative to. Out: text with a newline at
its end. JSON is nctakt's own (docs/checking.md), ``github`` are the workflow commands of GitHub
Actions. SARIF is in ``sarif.py``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

import click

from nctakt import __version__
from nctakt.base.diagnostics import Diagnostic, Language, Severity, Span, Text
from nctakt.checking.check import CheckResult
from nctakt.checking.inputs import Found
from nctakt.cli.selection import RULE_PREFIX

COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.NOTE: None}
_GITHUB = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "notice"}
_REMEDY = Text("remedy", "Abhilfe")
_CHANNEL = (Text("channel", "Kanal"), Text("channels", "Kanäle"))
#: What is counted: for one of it, for any other number.
_COUNTS = {
    Severity.ERROR: (Text("error", "Fehler"), Text("errors", "Fehler")),
    Severity.WARNING: (Text("warning", "Warnung"), Text("warnings", "Warnungen")),
    Severity.NOTE: (Text("note", "Hinweis"), Text("notes", "Hinweise")),
}
_FILES = (Text("file", "Datei"), Text("files", "Dateien"))


def rule_of(number: int) -> str:
    """The name of a message where rules of many tools stand beside each other."""
    return f"{RULE_PREFIX}{number}"


def text_with_remedy(found: Found, language: Language) -> str:
    """The text and, on lines of their own, the remedy and the channels that it concerns."""
    one = found.diagnostic
    remedy = one.remedy(language)
    label = _REMEDY.get(language)
    lines = [one.text(language), *([f"{label}: {remedy}"] if remedy else [])]
    return "\n".join([*lines, *_channels(found, language)])


def _channels(found: Found, language: Language) -> list[str]:
    """``channel: 2``; nothing where all channels are concerned, or a list."""
    if not found.channels:
        return []
    label = _CHANNEL[len(found.channels) > 1].get(language)
    return [f"{label}: {', '.join(map(str, found.channels))}"]


def place_of(found: Found) -> Span | None:
    """Return the line of a finding; ``None``: it concerns a whole file, or none."""
    span = found.diagnostic.span
    return span if span is not None and span.line else None


def relative(file: str, root: Path) -> Path:
    """The path of ``file`` from ``root`` on; absolute where it lies outside of it."""
    absolute = Path(os.path.abspath(root / file))  # noqa: PTH100 - links in it shall stay
    return absolute.relative_to(root) if absolute.is_relative_to(root) else absolute


# --- text ----------------------------------------------------------------------------------------


def as_text(result: CheckResult, language: Language) -> str:
    """Each finding with its line and remedy, in colours; those below each other are told apart."""
    lines: list[str] = []
    for found in result.found:
        headline, *rest = found.diagnostic.render(language).split("\n")
        lines += [click.style(headline, fg=COLOURS[found.diagnostic.severity]), *rest]
        lines += [f"  {line}" for line in _channels(found, language)]
    return "".join(f"{line}\n" for line in lines)


def closing_line(result: CheckResult, language: Language) -> str:
    """``3 files: 1 error, 2 warnings, 0 notes``."""
    counts = [
        _counted(result.count(severity), texts, language) for severity, texts in _COUNTS.items()
    ]
    return f"{_counted(len(result.files), _FILES, language)}: {', '.join(counts)}"


def _counted(number: int, texts: tuple[Text, Text], language: Language) -> str:
    return f"{number} {texts[number != 1].get(language)}"


# --- JSON ----------------------------------------------------------------------------------------


def as_json(result: CheckResult, language: Language, root: Path) -> str:
    """One object; its keys are the same in every language, its text is ASCII for any terminal."""
    document = {
        "nctakt": __version__,
        "files": [
            {"file": relative(one.file, root).as_posix(), "kind": one.kind} for one in result.files
        ],
        "diagnostics": [_json_of(found, language, root) for found in result.found],
        "counts": {
            "files": len(result.files),
            "errors": result.count(Severity.ERROR),
            "warnings": result.count(Severity.WARNING),
            "notes": result.count(Severity.NOTE),
        },
    }
    return json.dumps(document, indent=2) + "\n"


def diagnostics_as_json(
    diagnostics: Sequence[Diagnostic], file: str, language: Language
) -> list[dict[str, object]]:
    """Return diagnostics as ``as_json`` has them; ``file``: that of those without a place."""
    found = [Found(one.span.file if one.span is not None else file, one) for one in diagnostics]
    return [
        {**_json_of(one, language, Path.cwd()), **({} if one.file else {"file": None})}
        for one in found
    ]


def _json_of(found: Found, language: Language, root: Path) -> dict[str, object]:
    one, span = found.diagnostic, place_of(found)
    return {
        "id": one.id,
        "rule": rule_of(one.id),
        "severity": one.severity.name.lower(),
        "file": relative(found.file, root).as_posix(),
        "line": None if span is None else span.line,
        "column": None if span is None else span.column,
        "end_column": None if span is None else span.end_column,
        "text": one.text(language),
        "remedy": one.remedy(language),
        "source_line": one.source_line,
        "channels": list(found.channels),
    }


# --- GitHub --------------------------------------------------------------------------------------


def as_github(result: CheckResult, language: Language, root: Path) -> str:
    """One workflow command for each finding, which GitHub Actions shows beside its line."""
    return "".join(f"{line}\n" for line in _github_lines(result, language, root))


def _github_lines(result: CheckResult, language: Language, root: Path) -> Iterator[str]:
    for found in result.found:
        one, span = found.diagnostic, place_of(found)
        properties = {"file": relative(found.file, root).as_posix()}
        if span is not None:
            properties["line"] = str(span.line)
            properties["col"] = str(span.column)
            properties["endColumn"] = str(span.end_column)
        properties["title"] = rule_of(one.id)
        words = ",".join(f"{name}={_property(value)}" for name, value in properties.items())
        message = _escaped(text_with_remedy(found, language))
        yield f"::{_GITHUB[one.severity]} {words}::{message}"


def _escaped(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _escaped(text).replace(":", "%3A").replace(",", "%2C")
