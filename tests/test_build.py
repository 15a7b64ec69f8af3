# SPDX-License-Identifier: MIT
"""Installing: which modules are compiled, what a wheel needs, what happens without a C compiler."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
import zipfile
from importlib.machinery import ExtensionFileLoader
from pathlib import Path
from types import ModuleType

import pytest

from nctakt.base.mode import is_compiled

ROOT = Path(__file__).parent.parent
needs_compiled_modules = pytest.mark.skipif(not is_compiled(), reason="the modules run plain")


@pytest.fixture
def setup(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """``setup.py`` as a module."""
    monkeypatch.chdir(ROOT)
    spec = importlib.util.spec_from_file_location("setup", ROOT / "setup.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def run(*words: str | Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run Python in the project's folder."""
    return subprocess.run(
        [sys.executable, *words],
        cwd=ROOT,
        check=False,
        capture_output=True,
        text=True,
        env={**os.environ, **environment},
    )


@needs_compiled_modules
def test_every_module_with_types_is_compiled(setup: ModuleType) -> None:
    """None is left as plain Python beside compiled ones, which would not fit together."""
    names = [one.name for one in setup.extensions()]
    assert {"nctakt._cython", "nctakt.kernel.kernel"} < set(names)
    specs = [importlib.util.find_spec(name) for name in names]
    assert [type(one and one.loader) for one in specs] == [ExtensionFileLoader] * len(names)


def test_modules_that_have_moved_are_removed(setup: ModuleType, tmp_path: Path) -> None:
    """What an earlier build has left would be imported, or go into a wheel."""
    compiled = f"nctakt/kernel/kernel{setup.ENDING}"
    kept = ["nctakt/__init__.py", "nctakt/kernel/kernel.py", compiled]
    left = ["nctakt/gone.py", f"nctakt/gone{setup.ENDING}", "nctakt/kernel/kernel.cpython-310.so"]
    for name in (*kept, *left):
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
    setup.remove_strangers(tmp_path)
    found = [path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.*")]
    assert sorted(found) == sorted(kept)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems translate without forks")
def test_modules_that_cannot_be_translated_are_named() -> None:
    """The others are translated first, so that one build shows all mistakes."""
    jobs = '{"right": lambda: True, "wrong": lambda: False, "broken": lambda: 1 / 0}'
    code = f"import runpy; runpy.run_path('setup.py')['run_in_forks']({jobs}, 2)"
    done = run("-c", code)
    assert done.returncode == 1
    assert "ZeroDivisionError" in done.stderr
    assert done.stderr.rstrip().endswith("not translated: broken, wrong")


@pytest.mark.nightly
@pytest.mark.slow
@needs_compiled_modules
@pytest.mark.skipif(sys.platform == "win32", reason="the compiler is not named by CC there")
def test_without_a_compiler_plain_python_is_installed(tmp_path: Path) -> None:
    """No module is compiled, and the reason is reported; the build succeeds."""
    folders = ("--build-lib", tmp_path, "--build-temp", tmp_path / "objects")
    done = run("setup.py", "--quiet", "build_ext", *folders, CC="no-such-compiler")
    assert done.returncode == 0, done.stderr
    assert "plain Python is installed" in done.stdout + done.stderr
    assert [*tmp_path.rglob("*.so")] == []


@pytest.mark.nightly
@pytest.mark.slow
@needs_compiled_modules
def test_a_wheel_needs_no_compiler(tmp_path: Path) -> None:
    """It holds the modules of the sources and no others, and runs where no program is found."""
    pip = ("-m", "pip", "--disable-pip-version-check")
    words: tuple[str | Path, ...] = (
        "wheel",
        "--no-deps",
        "--no-build-isolation",
        "--wheel-dir",
        tmp_path,
        ROOT,
    )
    done = run(*pip, *words)
    assert done.returncode == 0, done.stdout + done.stderr
    (wheel,) = tmp_path.glob("nctakt-*.whl")
    with zipfile.ZipFile(wheel) as archive:
        modules = {name for name in archive.namelist() if name.endswith(".py")}
    package = ROOT / "src"
    assert modules == {
        path.relative_to(package).as_posix() for path in (package / "nctakt").rglob("*.py")
    }
    site = tmp_path / "site"
    words = ("install", "--no-deps", "--no-index", "--target", site, wheel)
    done = run(*pip, *words, PATH="")
    assert done.returncode == 0, done.stdout + done.stderr
    program = ROOT / "examples" / "crossing.nc"
    done = run("-m", "nctakt", "run", "--compiled", program, PYTHONPATH=str(site), PATH="")
    assert done.returncode == 0, done.stderr
    assert "X has arrived, 1 crossing" in done.stdout
    where = run("-c", "import nctakt; print(nctakt.__file__)", PYTHONPATH=str(site)).stdout
    assert Path(where.strip()).is_relative_to(site)
