# SPDX-License-Identifier: MIT
"""Tests run on the machine of the project around them."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path

import pytest

import nctakt

pytestmark = pytest.mark.slow

SOURCES = Path(nctakt.__file__).parent.parent


def run_pytest(folder: Path, **environment: str) -> str:
    """What pytest says in a folder, without colours."""
    known = {one.name for one in entry_points(group="pytest11")}
    words = [] if "nctakt" in known else ["-p", "nctakt.testing.plugin"]
    path = os.pathsep.join(filter(None, [str(SOURCES), os.environ.get("PYTHONPATH", "")]))
    kept = {name: value for name, value in os.environ.items() if name != "NCTAKT_MACHINE"}
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "pytest",
            *words,
            "-p",
            "no:asyncio",
            "-p",
            "no:cacheprovider",
            "-q",
            ".",
        ],
        cwd=folder,
        check=False,
        capture_output=True,
        encoding="utf-8",
        env={**kept, "PYTHONPATH": path, **environment},
    )
    return done.stdout + done.stderr


@pytest.mark.nightly
def test_a_test_runs_on_the_machine_of_its_project(tmp_path: Path) -> None:
    """NC files and fixtures take it, a line says which; NCTAKT_MACHINE counts before it."""
    (tmp_path / "nctakt.toml").write_text('machine = "demo5"\n', "utf-8")
    (tmp_path / "a.nc").write_text("G01 C10 F1000 ; expect: ended\nM30\n", "utf-8")
    (tmp_path / "test_b.py").write_text(
        'def test_b(run_nc):\n    assert run_nc("a.nc").ended\n', "utf-8"
    )
    (tmp_path / "plan.toml").write_text('program = "a.nc"\n', "utf-8")
    (tmp_path / "test_c.py").write_text(
        'def test_c(study):\n    assert study(program="a.nc") and study("plan.toml")\n', "utf-8"
    )
    reported = run_pytest(tmp_path)
    assert "3 passed" in reported
    assert reported.count("nctakt: the machine is demo5, as nctakt.toml says") == 1
    assert "3 failed" in run_pytest(tmp_path, NCTAKT_MACHINE="demo")
    (tmp_path / "pytest.ini").write_text("[pytest]\nnctakt_machine = demo\n", "utf-8")
    assert "3 failed" in run_pytest(tmp_path)
    assert "3 passed" in run_pytest(tmp_path, NCTAKT_MACHINE="demo5")
