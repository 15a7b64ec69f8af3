# SPDX-License-Identifier: MIT
"""The recipes of ``CONTRIBUTING.md`` lead where they say, in a copy of the project.

All examples go into one copy, where the tests that the recipes name run as plain Python.
``NCTAKT_RECIPES=compiled`` builds the copy and runs them compiled.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from support.recipes import RECIPES, Recipe

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parent.parent.parent
COMPILED = os.environ.get("NCTAKT_RECIPES") == "compiled"
#: What the tests of the recipes need of the project.
PARTS = ("src", "tests", "scripts", "examples", "pyproject.toml", "setup.py", "README.md")


def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run Python in a copy of the project, which takes its own package."""
    plain = {} if COMPILED else {"NCTAKT_PLAIN": "1"}
    environment = {**os.environ, **plain, "PYTHONPATH": str(folder / "src")}
    for name in [one for one in environment if one.startswith(("PYTEST_", "NCTAKT_SEEDS"))]:
        del environment[name]
    command = [sys.executable, *words]
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


@pytest.fixture(scope="module")
def changed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project with the changes of all recipes."""
    folder = tmp_path_factory.mktemp("recipes") / "project"
    folder.mkdir()
    left_out = shutil.ignore_patterns("__pycache__", "*.so", "*.c", "node_modules")
    for part in PARTS:
        if (ROOT / part).is_dir():
            shutil.copytree(ROOT / part, folder / part, ignore=left_out)
        else:
            shutil.copy2(ROOT / part, folder / part)
    for recipe in RECIPES:
        for edit in recipe.edits:
            edit.apply(folder)
    for script in dict.fromkeys(script for recipe in RECIPES for script in recipe.scripts):
        done = run(folder, script)
        assert done.returncode == 0, done.stdout + done.stderr
    if COMPILED:
        done = run(folder, "setup.py", "--quiet", "build_ext", "--inplace")
        assert done.returncode == 0, done.stdout + done.stderr
    return folder


@pytest.mark.nightly
@pytest.mark.parametrize("recipe", RECIPES, ids=lambda one: one.heading)
def test_the_tests_of_a_recipe_pass(recipe: Recipe, changed: Path) -> None:
    """The example of a recipe passes the tests that the recipe names."""
    words = ("-m", "pytest", "-q", "-p", "no:cacheprovider", "--no-header")
    done = run(changed, *words, *recipe.tests)
    assert done.returncode == 0, done.stdout + done.stderr
    assert " passed" in done.stdout


@pytest.mark.parametrize("recipe", RECIPES, ids=lambda one: one.heading)
def test_a_recipe_touches_as_many_files_as_it_says(recipe: Recipe) -> None:
    """``CONTRIBUTING.md`` has the recipe, with its number of files and their names."""
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    (steps,) = re.findall(
        rf"^### {re.escape(recipe.heading)}\n(.*?)(?=^### |\Z)", text, re.M | re.S
    )
    count = int(recipe.heading.split(": ")[1].split()[0])
    assert recipe.files == count
    assert len(re.findall(r"^\d\. ", steps, re.M)) == count
