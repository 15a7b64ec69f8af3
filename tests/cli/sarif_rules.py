# SPDX-License-Identifier: MIT
"""The part of the SARIF 2.1.0 standard that nctakt writes, as a test can ask for it.

The schema of the standard is in no package that could be installed for the tests. So the objects
that nctakt writes are described here from the text of the standard (OASIS, sections 3.13 to 3.52):
which properties they may have, of which types, which they must have. An object with a property that
does not stand here fails, as the schema allows no others either.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

Check = Callable[[object, str], Iterator[str]]


@dataclass(frozen=True, slots=True)
class Shape:
    """An object: its properties, those it must have, those of which it must have one."""

    properties: dict[str, Check]
    required: tuple[str, ...] = ()
    one_of: tuple[str, ...] = ()

    def __call__(self, value: object, path: str) -> Iterator[str]:
        if not isinstance(value, dict):
            yield f"{path}: no object"
            return
        for name in self.required:
            if name not in value:
                yield f"{path}: no {name}"
        if self.one_of and not any(name in value for name in self.one_of):
            yield f"{path}: none of {self.one_of}"
        for name, item in value.items():
            if name not in self.properties:
                yield f"{path}: {name} is no property of it"
            else:
                yield from self.properties[name](item, f"{path}.{name}")


def text(pattern: str = r"(?s).*") -> Check:
    """A string that fits the pattern."""

    def check(value: object, path: str) -> Iterator[str]:
        if not isinstance(value, str) or not re.fullmatch(pattern, value):
            yield f"{path}: {value!r}"

    return check


def whole(least: int) -> Check:
    """A whole number from ``least`` on."""

    def check(value: object, path: str) -> Iterator[str]:
        if not isinstance(value, int) or isinstance(value, bool) or value < least:
            yield f"{path}: {value!r}"

    return check


def array(item: Check, *, unique: bool = False, least: int = 0) -> Check:
    """A list of items of one kind."""

    def check(value: object, path: str) -> Iterator[str]:
        if not isinstance(value, list) or len(value) < least:
            yield f"{path}: {value!r}"
            return
        if unique and any(one in value[:place] for place, one in enumerate(value)):
            yield f"{path}: the same twice"
        for place, one in enumerate(value):
            yield from item(one, f"{path}[{place}]")

    return check


def texts(value: object, path: str) -> Iterator[str]:
    """An object whose values are strings."""
    if not isinstance(value, dict):
        yield f"{path}: no object"
        return
    for name, item in value.items():
        yield from text()(item, f"{path}.{name}")


_LEVEL = text("none|note|warning|error")
#: A reference to a file: no blanks and none of the characters that a URI has to escape.
_URI = text(r"[A-Za-z0-9\-._~:/?#\[\]@!$&'()*+,;=%]+")
_MESSAGE = Shape({"text": text(), "id": text(), "markdown": text()}, one_of=("text", "id"))
_STRINGS = Shape({"text": text(), "markdown": text()}, required=("text",))
_LOCATION_OF_ARTIFACT = Shape(
    {"uri": _URI, "uriBaseId": text(), "index": whole(-1), "description": _MESSAGE}
)
_REGION = Shape(
    {
        "startLine": whole(1),
        "startColumn": whole(1),
        "endLine": whole(1),
        "endColumn": whole(1),
        "snippet": Shape({"text": text()}),
    }
)
_PHYSICAL = Shape(
    {"artifactLocation": _LOCATION_OF_ARTIFACT, "region": _REGION, "contextRegion": _REGION},
    one_of=("address", "artifactLocation"),
)
_RULE = Shape(
    {
        "id": text(".+"),
        "name": text(),
        "shortDescription": _STRINGS,
        "fullDescription": _STRINGS,
        "help": _STRINGS,
        "helpUri": _URI,
        "defaultConfiguration": Shape({"level": _LEVEL}),
    },
    required=("id",),
)
_DRIVER = Shape(
    {
        "name": text(".+"),
        "version": text(),
        "semanticVersion": text(r"\d+\.\d+\.\d+.*"),
        "informationUri": _URI,
        "rules": array(_RULE, unique=True),
    },
    required=("name",),
)
_RESULT = Shape(
    {
        "ruleId": text(),
        "ruleIndex": whole(-1),
        "level": _LEVEL,
        "message": _MESSAGE,
        "locations": array(Shape({"physicalLocation": _PHYSICAL})),
        "partialFingerprints": texts,
    },
    required=("message",),
)
_ARTIFACT = Shape(
    {
        "location": _LOCATION_OF_ARTIFACT,
        "roles": array(text("analysisTarget"), unique=True),
        "description": _MESSAGE,
    }
)
_RUN = Shape(
    {
        "tool": Shape({"driver": _DRIVER}, required=("driver",)),
        "language": text("[a-z]{2}(-[A-Z]{2})?"),
        "columnKind": text("utf16CodeUnits|unicodeCodePoints"),
        "artifacts": array(_ARTIFACT, unique=True),
        "results": array(_RESULT),
    },
    required=("tool",),
)
LOG = Shape(
    {"$schema": _URI, "version": text(r"2\.1\.0"), "runs": array(_RUN)},
    required=("version", "runs"),
)


def faults(log: object) -> list[str]:
    """What is wrong with a log; the indices of its results lead to their rules, too."""
    found = list(LOG(log, "log"))
    if found:
        return found
    assert isinstance(log, dict)
    for run in log["runs"]:
        rules = run["tool"]["driver"]["rules"]
        names = [rule["id"] for rule in rules]
        if len(set(names)) != len(names):
            found.append("two rules of one name")
        for result in run["results"]:
            if rules[result["ruleIndex"]]["id"] != result["ruleId"]:
                found.append(f"{result['ruleId']}: its index is that of another rule")
            for location in result["locations"]:
                region = location["physicalLocation"]["region"]
                if region.get("endColumn", 2) <= region.get("startColumn", 1):
                    found.append(f"{result['ruleId']}: an empty region")
    return found
