# SPDX-License-Identifier: MIT
"""Processes that nctakt starts import nothing from the folder that they are in."""

from __future__ import annotations

import asyncio
import os
import secrets
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from nctakt.base.python_process import python_command, python_environment
from nctakt.session.session import Session
from nctakt.studies.study import Study
from nctakt.studies.workers.worker_process import WorkerProcess

PART = (
    "#RT CYCLE [ID = 1 SCOPE = PROG]\n$IF V.E.VALUE == 0\nV.E.COUNT += 1\n$ENDIF\n#RT CYCLE END\n"
)

#: Modules that Python, a library or nctakt imports early, the first one beside them.
BAIT = (
    *("nctakt", "click", "enum", "fnmatch", "json", "multiprocessing", "numpy", "lsprotocol"),
    *("pathlib", "pickle", "re", "rich", "signal", "sitecustomize", "typing"),
)


@pytest.fixture
def trap(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working directory with a program, and modules that note it when they are imported."""
    for name in BAIT:
        text = f"open({str(tmp_path / 'caught')!r}, 'a').write('{name} ')\n"
        (tmp_path / f"{name}.py").write_text(text, "utf-8")
    (tmp_path / "part.nc").write_text(f"{PART}G04 0.01\nM30\n", "utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", os.pathsep)  # two empty entries: the working directory
    return tmp_path


def count_branches(folder: Path) -> None:
    """As the language server does for *Count branches*."""
    pytest.importorskip("pygls")
    from nctakt.editor.display.presentation import _counted  # noqa: PLC0415 - a library may be missing

    assert asyncio.run(_counted(folder / "part.nc")) == {2: 10}


def start_worker(folder: Path) -> None:
    """As a study does that has several threads."""
    vary: list[dict[str, Any]] = [{"variable": "V.E.VALUE", "from": 1, "to": 2, "step": 1}]
    study = Study(program=str(folder / "part.nc"), until="0.1 s", vary=vary)
    WorkerProcess.started(study.plan).end()


def open_session(folder: Path) -> None:
    """As the debugger and the live page do."""
    session = Session(folder / "part.nc")
    session.step(1)
    session.close()


def share_memory(folder: Path) -> None:
    """As ``run --hli`` does: Python's resource tracker is a process, too."""
    name = f"nctakt_{secrets.token_hex(4)}"
    script = folder / "bin" / "share.py"  # as the command nctakt is a script in its own folder
    script.parent.mkdir()
    script.write_text(f"import nctakt\nnctakt.Controller().interface_image({name!r}).close()")
    environment = {**os.environ, "PYTHONPATH": python_environment()["PYTHONPATH"]}
    subprocess.run([sys.executable, script], cwd=folder, env=environment, check=True)


def check_by_module(folder: Path) -> None:
    """``python -m nctakt``, which puts the working directory in front, without a nctakt there."""
    (folder / "nctakt.py").unlink()
    environment = {**os.environ, "PYTHONPATH": python_environment()["PYTHONPATH"]}
    words = [sys.executable, "-m", "nctakt", "check", "part.nc"]
    subprocess.run(words, cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)


@pytest.mark.slow
@pytest.mark.parametrize(
    "start", [count_branches, start_worker, open_session, share_memory, check_by_module]
)
def test_no_module_of_the_working_directory_runs(trap: Path, start: Callable[[Path], None]) -> None:
    """Nor one of the program's folder."""
    start(trap)
    caught = trap / "caught"
    assert not caught.exists(), caught.read_text("utf-8")


def test_the_search_path_means_the_same_folders_elsewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Relative entries are made absolute, empty ones go."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(["", "lib", "/opt/more", ""]))
    entries = python_environment()["PYTHONPATH"].split(os.pathsep)
    assert entries[1:] == [str(tmp_path / "lib"), "/opt/more"]
    assert python_command("nctakt", "run")[1:] == ["-P", "-m", "nctakt", "run"]
