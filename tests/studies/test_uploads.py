# SPDX-License-Identifier: MIT
"""What a PLC and measures import reaches the workers of a cluster."""

from __future__ import annotations

import os
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.studies.rows.row_store import RowStore
from nctakt.studies.runs.bundle import bundle
from nctakt.studies.study import Study

GAUGE = """\
def look(hli):
    if hli.read("V.E.VALUE") == 3:
        raise ValueError("three")
"""
FILES = {
    "own/part.nc": "G01 X[V.E.VALUE] F6000\nM30\n",
    "own/cell.py": "import gauge\nfrom kit.doors import shut\nfrom nctakt import Plc\n\n"
    "class Cell(Plc):\n    inputs = 'inputs.csv'\n\n"
    "    def each_tick(self, hli):\n        gauge.look(hli)\n        shut(hli)\n",
    "own/inputs.csv": "time,V.E.TRIGGER\n5ms,1\n",
    "own/gauge.py": GAUGE,
    "own/measures.py": "from deep import number\n\ndef both(run):\n    return number\n",
    "own/deep.py": "number = 3.5\n",
    "library/kit/__init__.py": "",
    "library/kit/doors.py": "from . import state\n\ndef shut(hli):\n    assert state.word\n",
    "library/kit/state.py": "word = 'shut'\n",
}


def study(folder: Path) -> Study:
    """A study whose PLC and measure import files of the user."""
    for name, text in FILES.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return Study(
        program=str(folder / "own/part.nc"),
        plc=str(folder / "own/cell.py"),
        until="20 ms",
        vary=[{"variable": "V.E.VALUE", "from": 1, "to": 6, "step": 1}],
        measure={"both": f"python {folder / 'own/measures.py'}:both", "end": "X at end"},
    )


def wheel(folder: Path, name: str, text: str) -> Path:
    """A wheel with one module."""
    path = folder / f"{name}-1.0-py3-none-any.whl"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(f"{name}.py", text)
        archive.writestr(f"{name}-1.0.dist-info/METADATA", f"Name: {name}\n")
    return path


@pytest.fixture(autouse=True)
def own_modules(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The modules of this process, without those of the test before."""
    monkeypatch.syspath_prepend(tmp_path / "library")
    before = list(sys.modules)
    yield
    for name in [name for name in sys.modules if name not in before]:
        if name.partition(".")[0] in ("deep", "gauge", "kit", "wheeled"):
            del sys.modules[name]


def test_imported_modules_are_found(tmp_path: Path) -> None:
    """Those beside the PLC and on Python's path, and the PLC's inputs."""
    packed = bundle(study(tmp_path).plan)
    names = {Path(name).name for name, _ in packed.files}
    assert {Path(name).name for name in FILES} <= names
    assert sorted(packed.modules) == ["deep", "gauge", "kit"]


def test_installed_packages_are_not_sent(tmp_path: Path) -> None:
    """They are not the user's, and may be made for this machine only."""
    plan = study(tmp_path).plan
    (tmp_path / "own/gauge.py").write_text("import click, json, nctakt\n" + GAUGE)
    assert sorted(bundle(plan).modules) == ["deep", "gauge", "kit"]


def test_rows_of_another_module_are_refused(tmp_path: Path) -> None:
    """A module of the PLC that has changed since makes other runs (901309)."""
    plan = study(tmp_path).plan
    RowStore(tmp_path / "rows", plan, resumes=False).close()
    RowStore(tmp_path / "rows", plan, resumes=True).close()
    (tmp_path / "library/kit/state.py").write_text("word = 'open'\n")
    with pytest.raises(Failure) as raised:
        RowStore(tmp_path / "rows", plan, resumes=True)
    assert raised.value.diagnostics[0].id == 901309


def test_uploads_that_cannot_be(tmp_path: Path) -> None:
    """A file that is not there, a wheel that is none."""
    plan = study(tmp_path).plan
    (tmp_path / "no.whl").write_text("no wheel")
    for name, number in (("nowhere.csv", 900500), ("no.whl", 900503)):
        with pytest.raises(Failure) as raised:
            bundle(plan, [tmp_path / name])
        assert raised.value.diagnostics[0].id == number


def test_uploads_need_a_cluster(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Without ``--scheduler`` the option would have no effect."""
    study(tmp_path)
    assert main(["study", str(tmp_path / "own/part.nc"), "--upload", "a.whl"]) == 2
    assert "--scheduler" in capsys.readouterr().err


@pytest.mark.nightly
@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="the scheduler is ended by a signal")
@pytest.mark.filterwarnings("ignore")
def test_a_worker_in_another_folder_makes_the_same_rows(
    tmp_path: Path, scheduler: tuple[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """With modules, a wheel, and later with a module that has changed."""
    from nctakt.studies.workers.cluster import rows_of_cluster  # noqa: PLC0415 - an extra

    address, _ = scheduler
    study(tmp_path)
    monkeypatch.chdir(tmp_path)  # the paths of the plan are relative, for this process only
    own = study(Path())
    wheels = [wheel(tmp_path, "wheeled", "number = 4.5\n")]
    monkeypatch.syspath_prepend(tmp_path / "site-packages")
    (tmp_path / "site-packages").mkdir()
    (tmp_path / "site-packages/wheeled.py").write_text("number = 4.5\n")
    (tmp_path / "own/deep.py").write_text("from wheeled import number\n")
    expected = own.run()
    assert expected.column("both") == [4.5, 4.5, None, 4.5, 4.5, 4.5]
    assert expected.counts == {"passed": 5, "failed": 0, "refused": 1, "crashed": 0}
    with pytest.raises(Failure) as raised:
        own.run(executor=lambda p, n: rows_of_cluster(p, n, address))
    assert raised.value.diagnostics[0].id == 901485
    assert "wheeled" in str(raised.value)
    made = own.run(executor=lambda p, n: rows_of_cluster(p, n, address, wheels))
    assert made.rows == expected.rows
    (tmp_path / "own/gauge.py").write_text("def look(hli):\n    pass\n")
    changed = own.run(executor=lambda p, n: rows_of_cluster(p, n, address, wheels))
    assert changed.counts["passed"] == 6
