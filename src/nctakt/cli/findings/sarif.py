# SPDX-License-Identifier: MIT
"""The findings of a check as SARIF 2.1.0, the format of code scanning (OASIS standard).

In: ``CheckResult``, language, the root of relative paths. Out: the log as text. Rules are the
messages of the findings, named ``NCTAKT22009``; their texts are those of the catalogue. A result
keeps its fingerprint when lines are added above it: it consists of rule, path, the text of the
line, and the number of equal ones before it.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from urllib.parse import quote

from nctakt.base.diagnostics import Language, Message, Severity
from nctakt.base.version import __version__
from nctakt.checking.check import CheckResult
from nctakt.checking.inputs import Finding
from nctakt.cli.findings.formats import position_of, relative, rule_of, text_with_remedy

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
#: The root of relative paths: the folder of the checkout.
BASE = "%SRCROOT%"
_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "note"}
_FINGERPRINT_DIGITS = 16

Json = dict[str, object]


def as_sarif(result: CheckResult, language: Language, root: Path) -> str:
    """Return the log with one run."""
    messages: dict[int, Message] = {}
    for finding in result.findings:
        messages.setdefault(finding.diagnostic.id, finding.diagnostic.message)
    index = {number: position for position, number in enumerate(sorted(messages))}
    driver: Json = {
        "name": "nctakt",
        "version": __version__,
        "semanticVersion": __version__,
        "rules": [_rule(number, messages[number], language) for number in index],
    }
    seen: dict[str, int] = {}
    run: Json = {
        "tool": {"driver": driver},
        "language": language,
        "columnKind": "unicodeCodePoints",
        "artifacts": [
            {
                "location": _location(file.file, root),
                "roles": ["analysisTarget"],
                "description": {"text": file.kind},
            }
            for file in result.files
        ],
        "results": [_result(finding, language, root, index, seen) for finding in result.findings],
    }
    log: Json = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    return json.dumps(log, indent=2) + "\n"


def _rule(number: int, message: Message, language: Language) -> Json:
    """Return the message of a number without values: each of its parameters as ``<name>``."""
    names = {name: f"<{name}>" for name in message.parameters}
    remedy = message.remedy.get(language).format_map(names)
    cause = message.cause.get(language)
    help_text = "\n\n".join(text for text in (cause, remedy) if text)
    text = message.text.get(language).format_map(names)
    return {
        "id": rule_of(number),
        "shortDescription": {"text": text},
        "fullDescription": {"text": cause or text},
        "help": {"text": help_text or text},
        "defaultConfiguration": {"level": _LEVELS[message.severity]},
        "properties": {"also": [other for other in message.known_as if other != number]},
    }


def _result(
    finding: Finding, language: Language, root: Path, index: dict[int, int], seen: dict[str, int]
) -> Json:
    message, span = finding.diagnostic, position_of(finding)
    region: Json = {"startLine": 1}
    if span is not None:
        region = {
            "startLine": span.line,
            "startColumn": span.column,
            "endColumn": max(span.end_column, span.column + 1),
        }
    location: Json = {"artifactLocation": _location(finding.file, root), "region": region}
    return {
        "ruleId": rule_of(message.id),
        "ruleIndex": index[message.id],
        "level": _LEVELS[message.severity],
        "message": {"text": text_with_remedy(finding, language)},
        "locations": [{"physicalLocation": location}],
        "partialFingerprints": {"primaryLocationLineHash": _fingerprint(finding, root, seen)},
    }


def _location(file: str, root: Path) -> Json:
    path = relative(file, root)
    if path.is_absolute():
        return {"uri": path.as_uri()}
    return {"uri": quote(path.as_posix(), errors="surrogateescape"), "uriBaseId": BASE}


def _fingerprint(finding: Finding, root: Path, seen: dict[str, int]) -> str:
    line = " ".join(finding.diagnostic.source_line.split())
    path = relative(finding.file, root).as_posix()
    text = "\0".join((rule_of(finding.diagnostic.id), path, line))
    digest = hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()
    short = digest[:_FINGERPRINT_DIGITS]
    seen[short] = seen.get(short, 0) + 1
    return f"{short}:{seen[short]}"
