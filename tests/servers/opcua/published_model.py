# SPDX-License-Identifier: MIT
"""The published node set of OPC 40502, fetched from npm: the oracle for our types."""

from __future__ import annotations

import os
import shutil
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import NamedTuple

import pytest

PACKAGE = "node-opcua-nodesets"
FILE = Path("node_modules") / PACKAGE / "nodesets" / "Opc.Ua.CNC.NodeSet.xml"
_XML = "{http://opcfoundation.org/UA/2011/03/UANodeSet.xsd}"


class PublishedNode(NamedTuple):
    """A node as it is published; IDs of the model as numbers, others as ``i=…``."""

    kind: str
    name: str
    attributes: dict[str, str]
    references: list[tuple[str, bool, str]]
    fields: list[tuple[str, str]]


def node_set(folder: Path) -> dict[str, PublishedNode]:
    """Return the published nodes by their IDs; skip the test where npm cannot fetch them."""
    own = os.environ.get("NCTAKT_NODE_MODULES")
    path = Path(own) / FILE if own else folder / FILE
    if not path.is_file():
        npm = shutil.which("npm")
        if npm is None:
            pytest.skip("npm is not installed: the published node set cannot be fetched")
        (folder / "package.json").write_text("{}", encoding="utf-8")
        command = [npm, "install", "--no-audit", "--no-fund", "--ignore-scripts", PACKAGE]
        try:
            done = subprocess.run(
                command, cwd=folder, capture_output=True, timeout=120, check=False
            )
        except subprocess.TimeoutExpired:
            pytest.skip("npm could not fetch the published node set in time")
        if done.returncode or not path.is_file():
            pytest.skip("npm could not fetch the published node set")
    return _read(path)


def _read(path: Path) -> dict[str, PublishedNode]:
    nodes = {}
    for element in ET.parse(path).getroot():
        kind = element.tag.removeprefix(_XML)
        if not kind.startswith("UA"):
            continue
        nodes[element.attrib["NodeId"]] = PublishedNode(
            kind,
            element.attrib["BrowseName"],
            dict(element.attrib),
            [
                (one.attrib["ReferenceType"], one.get("IsForward") != "false", one.text or "")
                for one in element.iter(f"{_XML}Reference")
            ],
            [
                (one.attrib["Name"], one.get("Value") or one.get("DataType") or "")
                for one in element.iter(f"{_XML}Field")
            ],
        )
    return nodes
