# SPDX-License-Identifier: MIT
"""What a check has found as SARIF 2.1.0, the format of code scanning (OASIS standard).

In: ``CheckResult``, language, the folder that paths are relative to. Out: the log as text. Rules
are the messages that were found, named ``NCTAKT22009``; their texts are those of the catalogue. A
result keeps its fingerprint when lines are added above it: it is made of rule, path, the text of
the line, and how many equal ones stand before it.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from urllib.parse import quote

from nctakt import __version__
from nctakt.base.diagnostics import Language, Message, Severity
from nctakt.checking.check import CheckResult
from nctakt.checking.inputs import Found
from nctakt.cli.formats import place_of, relative, rule_of, text_with_remedy

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
#: What paths are relative to: the folder of the checkout, whatever it is called there.
BASE = "%SRCROOT%"
_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "note"}
_FINGERPRINT_DIGITS = 16

Json = dict[str, object]


def as_sarif(result: CheckResult, language: Language, root: Path) -> str:
    """The log with one run."""
    messages = {found.diagnostic.id: found.diagnostic.message for found in result.found}
    rules = [messages[number] for number in sorted(messages)]
    index = {message.id: place for place, message in enumerate(rules)}
    driver: Json = {
        "name": "nctakt",
        "version": __version__,
        "semanticVersion": __version__,
        "rules": [_rule(message, language) for message in rules],
    }
    seen: dict[str, int] = {}
    run: Json = {
        "tool": {"driver": driver},
        "language": language,
        "columnKind": "unicodeCodePoints",
        "artifacts": [
            {
                "location": _location(one.file, root),
                "roles": ["analysisTarget"],
                "description": {"text": one.kind},
            }
            for one in result.files
        ],
        "results": [_result(found, language, root, index, seen) for found in result.found],
    }
    log: Json = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    return json.dumps(log, indent=2) + "\n"


def _rule(message: Message, language: Language) -> Json:
    """The message without values: each of its parameters as ``<name>``."""
    names = {name: f"<{name}>" for name in message.parameters}
    remedy = message.remedy.get(language).format_map(names)
    cause = message.cause.get(language)
    help_text = "\n\n".join(text for text in (cause, remedy) if text)
    text = message.text.get(language).format_map(names)
    return {
        "id": rule_of(message.id),
        "shortDescription": {"text": text},
        "fullDescription": {"text": cause or text},
        "help": {"text": help_text or text},
        "defaultConfiguration": {"level": _LEVELS[message.severity]},
    }


def _result(
    found: Found, language: Language, root: Path, index: dict[int, int], seen: dict[str, int]
) -> Json:
    one, span = found.diagnostic, place_of(found)
    region: Json = {"startLine": 1}
    if span is not None:
        region = {
            "startLine": span.line,
            "startColumn": span.column,
            "endColumn": max(span.end_column, span.column + 1),
        }
    place: Json = {"artifactLocation": _location(found.file, root), "region": region}
    return {
        "ruleId": rule_of(one.id),
        "ruleIndex": index[one.id],
        "level": _LEVELS[one.severity],
        "message": {"text": text_with_remedy(found, language)},
        "locations": [{"physicalLocation": place}],
        "partialFingerprints": {"primaryLocationLineHash": _fingerprint(found, root, seen)},
    }


def _location(file: str, root: Path) -> Json:
    path = relative(file, root)
    if path.is_absolute():
        return {"uri": path.as_uri()}
    return {"uri": quote(path.as_posix(), errors="surrogateescape"), "uriBaseId": BASE}


def _fingerprint(found: Found, root: Path, seen: dict[str, int]) -> str:
    line = " ".join(found.diagnostic.source_line.split())
    path = relative(found.file, root).as_posix()
    text = "\0".join((rule_of(found.diagnostic.id), path, line))
    digest = hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()
    short = digest[:_FINGERPRINT_DIGITS]
    seen[short] = seen.get(short, 0) + 1
    return f"{short}:{seen[short]}"
