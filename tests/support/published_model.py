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
FILE = f"{PACKAGE}/nodesets/Opc.Ua.CNC.NodeSet.xml"
_XML = "{http://opcfoundation.org/UA/2011/03/UANodeSet.xsd}"


class PublishedNode(NamedTuple):
    """A node as it is published; IDs of the model as numbers, others as ``i=…``."""

    kind: str
    name: str
    attributes: dict[str, str]
    references: list[tuple[str, bool, str]]
    fields: list[tuple[str, str]]


def installed(package: str, folder: Path) -> Path:
    """Return the folder of Node modules with a package; skip the test where npm cannot fetch it.

    NCTAKT_NODE_MODULES names a folder that has it already.
    """
    own = os.environ.get("NCTAKT_NODE_MODULES")
    if own and (Path(own) / package).is_dir():
        return Path(own)
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip(f"npm is not installed: {package} cannot be fetched")
    (folder / "package.json").write_text("{}", encoding="utf-8")
    command = [npm, "install", "--no-audit", "--no-fund", "--ignore-scripts", package]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=120, check=False)
    except subprocess.TimeoutExpired:
        pytest.skip(f"npm could not fetch {package} in time")
    if done.returncode or not (folder / "node_modules" / package).is_dir():
        pytest.skip(f"npm could not fetch {package}")
    return folder / "node_modules"


def node_set(folder: Path) -> dict[str, PublishedNode]:
    """Return the published nodes by their IDs; skip the test where npm cannot fetch them."""
    return _read(installed(PACKAGE, folder) / FILE)


def machine_tool_node_set(folder: Path) -> dict[str, PublishedNode]:
    """Return the published nodes of OPC 40501-1 in the same way."""
    return _read(installed(PACKAGE, folder) / FILE.replace("CNC.NodeSet", "MachineTool.NodeSet2"))


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
