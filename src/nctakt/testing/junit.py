# SPDX-License-Identifier: MIT
"""The JUnit file of ``nctakt test``: its name, and suites of Structured Text as TcUnit writes them.

In: the report of pytest. Out: the same with one ``testsuite`` for each suite of the PLC (ST-904).
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import pytest

#: The property of a test by which its suite is known.
SUITE = "nctakt suite"
_COUNTED = {"failure": "failures", "skipped": "skipped", "error": "errors"}
_STATUS = {"failure": "FAIL", "error": "FAIL", "skipped": "SKIP"}
#: The attribute ``type`` of a result, which the schema of JUnit wants and pytest leaves out.
_TYPES = {"failure": "AssertionError", "error": "Error"}


class ReportName:
    """A plugin for a run whose report is written as ``partial`` and named ``name`` in the end."""

    def __init__(self, partial: Path, name: Path) -> None:
        self._partial = str(partial.absolute())
        self._name = str(name.absolute())

    @pytest.hookimpl(tryfirst=True)
    def pytest_terminal_summary(self, config: pytest.Config) -> None:
        """Give the report, written by now, its name before pytest reports it."""
        for plugin in config.pluginmanager.get_plugins():
            if getattr(plugin, "logfile", None) == self._partial:
                vars(plugin)["logfile"] = self._name


def group_suites(report: Path) -> None:
    """Give each suite of the PLC its own ``testsuite``, its tests their status, results a type."""
    tree = ElementTree.parse(report)
    root = tree.getroot()
    for tag, name in _TYPES.items():
        for result in root.iter(tag):
            result.attrib.setdefault("type", name)
    suites: dict[tuple[str, str], ElementTree.Element] = {}
    for whole in list(root):
        for case in list(whole):
            path = _take_suite(case)
            if path:
                whole.remove(case)
                key = case.get("file", "").partition(":")[0], path
                suites.setdefault(key, ElementTree.Element("testsuite")).append(case)
        _count(whole)
        if suites and not len(whole):
            root.remove(whole)
    names = Counter(path for _, path in suites)
    for number, ((_, path), suite) in enumerate(suites.items()):
        suite.attrib.update(id=str(number), name=path)
        _count(suite)
        seconds = sum(float(case.get("time", "0")) for case in suite)
        suite.set("time", f"{seconds:.3f}")
        for case in suite if names[path] == 1 else ():
            case.set("classname", path)
        root.append(suite)
    tree.write(report, "utf-8", xml_declaration=True)


def _take_suite(case: ElementTree.Element) -> str:
    """Return the suite of a test, which it does not show any more; empty for any other test."""
    properties = case.find("properties")
    for one in () if properties is None else properties:
        if properties is not None and one.get("name") == SUITE:
            case.remove(properties)
            kinds = [part.tag for part in case]
            case.set("line", str(int(case.get("line", "-1")) + 1))  # pytest counts from 0
            status = next((_STATUS[kind] for kind in kinds if kind in _STATUS), "PASS")
            case.set("status", status)
            return one.get("value", "")
    return ""


def _count(suite: ElementTree.Element) -> None:
    """Set the number of a suite's tests, and their results."""
    found = Counter(_COUNTED.get(part.tag, "") for case in suite for part in case)
    suite.set("tests", str(len(suite.findall("testcase"))))
    for name in _COUNTED.values():
        suite.set(name, str(found[name]))
