# SPDX-License-Identifier: MIT
"""The library for OPC UA has one place in our code that depends on its inside."""

from __future__ import annotations

import ast
from importlib.util import find_spec
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[3] / "src" / "nctakt" / "servers" / "opcua"
FILES = sorted(path for path in FOLDER.glob("*.py") if path.name != "library.py")

#: The library's modules whose classes ours derive from.
MODULES = ("binary_server_asyncio", "internal_server", "internal_session", "server", "uaprocessor")


def private_names(tree: ast.AST) -> set[str]:
    """Names of attributes and methods that begin with one underscore."""
    names = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    names |= {
        node.name
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    }
    return {name for name in names if name.startswith("_") and not name.startswith("__")}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_only_one_module_knows_the_inside_of_the_library(path: Path) -> None:
    """The others import its numbers and types alone."""
    found = [
        node.module
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("asyncua.")
    ]
    assert found == []


#: Our modules with classes that derive from the library's.
DERIVED = ("clients/connection.py", "server.py", "clients/sessions.py")


def test_no_class_of_ours_takes_a_private_name_of_the_library() -> None:
    """An attribute of ours would overwrite one of the library's, or the other way round."""
    spec = find_spec("asyncua")
    if spec is None or spec.origin is None:
        pytest.skip("needs the extra [opcua]")
    server = Path(spec.origin).parent / "server"
    theirs: set[str] = set()
    for module in MODULES:
        theirs |= private_names(ast.parse((server / f"{module}.py").read_text("utf-8")))
    derived = [FOLDER / name for name in DERIVED]
    for path in derived:
        assert private_names(ast.parse(path.read_text("utf-8"))) & theirs == set(), path.name
