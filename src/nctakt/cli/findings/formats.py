# SPDX-License-Identifier: MIT
"""The findings of a check as text for a reader, and in the formats of other tools.

In: ``CheckResult``, language, the folder that paths are relative to. Out: text with a newline at
its end. JSON is nctakt's own (docs/ci.md), ``github`` are the workflow commands of GitHub
Actions. SARIF is in ``sarif.py``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import click

from nctakt.base.diagnostics import Diagnostic, Language, Severity, Span, Text
from nctakt.base.version import __version__
from nctakt.checking.check import CheckResult
from nctakt.checking.inputs import Finding
from nctakt.cli.findings.selection import RULE_PREFIX
from nctakt.messages.machines.lists import PARAMETER_MAY_CHANGE_RUN, PARAMETER_WOULD_CHANGE_RUN

COLOURS = {Severity.ERROR: "red", Severity.WARNING: "yellow", Severity.NOTE: None}
_GITHUB = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "notice"}
_REMEDY = Text("remedy", "Abhilfe")
_CHANNEL = (Text("channel", "Kanal"), Text("channels", "Kanäle"))
#: Counted things: singular and plural.
_COUNTS = {
    Severity.ERROR: (Text("error", "Fehler"), Text("errors", "Fehler")),
    Severity.WARNING: (Text("warning", "Warnung"), Text("warnings", "Warnungen")),
    Severity.NOTE: (Text("note", "Hinweis"), Text("notes", "Hinweise")),
}
_FILES = (Text("file", "Datei"), Text("files", "Dateien"))


#: The messages of such entries, each with its heading for one entry and for any other number.
_HEADINGS = {
    PARAMETER_WOULD_CHANGE_RUN: (
        Text(
            "{count} entry without effect here would change a run",
            "{count} Eintrag ohne Wirkung hier würde einen Lauf ändern",
        ),
        Text(
            "{count} entries without effect here would change a run",
            "{count} Einträge ohne Wirkung hier würden einen Lauf ändern",
        ),
    ),
    PARAMETER_MAY_CHANGE_RUN: (
        Text(
            "{count} entry without effect here may change a run",
            "{count} Eintrag ohne Wirkung hier kann einen Lauf ändern",
        ),
        Text(
            "{count} entries without effect here may change a run",
            "{count} Einträge ohne Wirkung hier können einen Lauf ändern",
        ),
    ),
}
_ROW = Text("{id:14} {key} is {value}, not {default}", "{id:14} {key} ist {value}, nicht {default}")


def rule_of(number: int) -> str:
    """Return the name of a message among the rules of other tools."""
    return f"{RULE_PREFIX}{number}"


def text_with_remedy(finding: Finding, language: Language) -> str:
    """Return the text and, on separate lines, the remedy and the channels that it concerns."""
    message = finding.diagnostic
    remedy = message.remedy(language)
    label = _REMEDY.get(language)
    lines = [message.text(language), *([f"{label}: {remedy}"] if remedy else [])]
    return "\n".join([*lines, *_channels(finding, language)])


def _channels(finding: Finding, language: Language) -> list[str]:
    """Return ``channel: 2``; nothing for a list, and if all channels are concerned."""
    if not finding.channels:
        return []
    label = _CHANNEL[len(finding.channels) > 1].get(language)
    return [f"{label}: {', '.join(map(str, finding.channels))}"]


def position_of(finding: Finding) -> Span | None:
    """Return the span of a finding; ``None`` if it concerns a whole file, or no file."""
    span = finding.diagnostic.span
    return span if span is not None and span.line else None


def relative(file: str, root: Path) -> Path:
    """Return the path of ``file`` from ``root`` on, an absolute one if it lies outside."""
    absolute = Path(os.path.abspath(root / file))  # noqa: PTH100 - links in it shall stay
    return absolute.relative_to(root) if absolute.is_relative_to(root) else absolute


# --- text ----------------------------------------------------------------------------------------


def as_text(result: CheckResult, language: Language) -> str:
    """Return the findings in colours, each with its line and remedy; ``--effects`` as a table."""
    lines: list[str] = []
    listed = [one.diagnostic for one in result.findings if is_listed(one.diagnostic)]
    for finding in result.findings:
        if is_listed(finding.diagnostic):
            continue
        headline, *rest = finding.diagnostic.render(language).split("\n")
        lines += [click.style(headline, fg=COLOURS[finding.diagnostic.severity]), *rest]
        lines += [f"  {line}" for line in _channels(finding, language)]
    lines += effect_lines(listed, language, COLOURS)
    return "".join(f"{line}\n" for line in lines)


def closing_line(result: CheckResult, language: Language) -> str:
    """Return the sums: ``3 files: 1 error, 2 warnings, 0 notes``."""
    counts = [
        _counted(result.count(severity), texts, language) for severity, texts in _COUNTS.items()
    ]
    return f"{_counted(len(result.files), _FILES, language)}: {', '.join(counts)}"


def _counted(number: int, texts: tuple[Text, Text], language: Language) -> str:
    return f"{number} {texts[number != 1].get(language)}"


# --- JSON ----------------------------------------------------------------------------------------


def as_json(result: CheckResult, language: Language, root: Path) -> str:
    """Return one JSON object in ASCII; its keys are the same in every language."""
    document = {
        "nctakt": __version__,
        "files": [
            {"file": relative(file.file, root).as_posix(), "kind": file.kind}
            for file in result.files
        ],
        "diagnostics": [_json_of(finding, language, root) for finding in result.findings],
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
    """Return diagnostics as in ``as_json``; ``file``: for those without a position."""
    findings = [
        Finding(item.span.file if item.span is not None else file, item) for item in diagnostics
    ]
    return [
        {**_json_of(item, language, Path.cwd()), **({} if item.file else {"file": None})}
        for item in findings
    ]


def _json_of(finding: Finding, language: Language, root: Path) -> dict[str, object]:
    message, span = finding.diagnostic, position_of(finding)
    return {
        "id": message.id,
        "also": list(message.also),
        "rule": rule_of(message.id),
        "severity": message.severity.name.lower(),
        "file": relative(finding.file, root).as_posix(),
        "line": None if span is None else span.line,
        "column": None if span is None else span.column,
        "end_column": None if span is None else span.end_column,
        "text": message.text(language),
        "remedy": message.remedy(language),
        "source_line": message.source_line,
        "channels": list(finding.channels),
    }


# --- GitHub --------------------------------------------------------------------------------------


def as_github(result: CheckResult, language: Language, root: Path) -> str:
    """Return a workflow command for each finding, which GitHub Actions shows next to its line."""
    return "".join(f"{line}\n" for line in _github_lines(result, language, root))


def _github_lines(result: CheckResult, language: Language, root: Path) -> Iterator[str]:
    for finding in result.findings:
        message, span = finding.diagnostic, position_of(finding)
        properties = {"file": relative(finding.file, root).as_posix()}
        if span is not None:
            properties["line"] = str(span.line)
            properties["col"] = str(span.column)
            properties["endColumn"] = str(span.end_column)
        properties["title"] = rule_of(message.id)
        words = ",".join(f"{name}={_property(value)}" for name, value in properties.items())
        text = _escaped(text_with_remedy(finding, language))
        yield f"::{_GITHUB[message.severity]} {words}::{text}"


def _escaped(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _escaped(text).replace(":", "%3A").replace(",", "%2C")


def is_listed(diagnostic: Diagnostic) -> bool:
    """Return whether a finding belongs into the table."""
    return diagnostic.message in _HEADINGS


def effect_lines(
    diagnostics: Sequence[Diagnostic], language: Language, colours: Mapping[Severity, str | None]
) -> Iterator[str]:
    """Yield the table of the findings among ``diagnostics`` for which ``is_listed`` is true."""
    for message, headings in _HEADINGS.items():
        listed = [one for one in diagnostics if one.message is message]
        if not listed:
            continue
        text = headings[len(listed) != 1].get(language).format(count=len(listed))
        severity = listed[0].severity
        heading = f"{severity.label(language)} {message.id}: {text}"
        yield click.style(heading, fg=colours[severity])
        file = ""
        for one in listed:
            assert one.span is not None
            if one.span.file != file:
                file = one.span.file
                yield f"  {file}"
            yield f"  {one.span.line:6}  {_ROW.get(language).format_map(one.values)}"
            meaning = one.values["meaning"]
            assert isinstance(meaning, Text)
            yield f"{'':10}{meaning.get(language)}"
        label = "Abhilfe" if language == "de" else "remedy"
        yield f"  {label}: {listed[0].remedy(language)}"
