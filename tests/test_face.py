# SPDX-License-Identifier: MIT
"""The public face: what ``import nctakt`` gives, and what it does not load."""

import ast
import doctest
import json
import pydoc
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

import nctakt
from nctakt.base.mode import is_compiled
from nctakt.schedule.simulation.results import Simulation

SOURCE = Path(nctakt.__file__)
EXAMPLES = Path(__file__).parent.parent / "examples"


def test_the_bare_package_loads_nothing() -> None:
    """``import nctakt`` imports no library, and of its own only what finds the names."""
    code = (
        "import json, sys; known = set(sys.modules); import nctakt; "
        "print(json.dumps(sorted(set(sys.modules) - known)))"
    )
    words = [sys.executable, "-c", code]
    done = subprocess.run(words, check=True, capture_output=True, encoding="utf-8")
    loaded = ["nctakt", "nctakt.base", "nctakt.base.lazy_names", "nctakt.base.version"]
    assert json.loads(done.stdout) == loaded


#: What a plain run does without: each of these costs milliseconds of every start.
NOT_FOR_A_PLAIN_RUN = {
    "csv", "decimal", "difflib", "hashlib", "html", "importlib.resources", "json", "matplotlib",
    "multiprocessing", "numpy", "rich", "shutil", "tempfile", "tomllib", "traceback", "xml",
    "nctakt.nc.lint", "nctakt.plc.script", "nctakt.plots", "nctakt.results.coverage",
    "nctakt.results.explained.why", "nctakt.results.trace.reading", "nctakt.schedule",
    "nctakt.testing",
}  # fmt: skip


@pytest.mark.skipif(not is_compiled(), reason="plain Python imports Cython, which imports the rest")
def test_a_plain_run_imports_what_it_needs(tmp_path: Path) -> None:
    """From the start to the summary: no picture, no schedule, no PLC, no tests."""
    program = tmp_path / "short.nc"
    program.write_text("G00 X10\nM30\n", "utf-8")
    words = [sys.executable, "-X", "importtime", "-m", "nctakt", "run", str(program)]
    done = subprocess.run(words, check=True, capture_output=True, encoding="utf-8")
    imported = {line.rpartition("|")[2].strip() for line in done.stderr.splitlines()}
    assert "nctakt.kernel.kernel" in imported
    assert not imported & NOT_FOR_A_PLAIN_RUN


#: What is not there where nobody has asked for an extra.
OF_EXTRAS = (
    "aiomqtt", "asyncua", "distributed", "hypothesis", "matplotlib", "nicegui", "optuna", "pandas",
    "polars", "pyarrow", "pygls", "pytest", "SALib", "scipy", "vcd", "watchfiles",
)  # fmt: skip

#: Commands, and their exit codes there: done, or the library that is missing is named.
IN_A_BARE_INSTALLATION = (
    (["run", "crossing.nc", "--quiet"], 0),
    (["run", "crossing.nc", "--quiet", "--plot", "crossing.png"], 2),
    (["study", "studies/stop.toml"], 1),
    (["study", "studies/stop.toml", "--scheduler", "tcp://127.0.0.1:1"], 2),
    (["live", "crossing.nc"], 2),
    (["serve", "crossing.nc", "--opcua"], 2),
    (["serve", "crossing.nc", "--mqtt", "mqtt://127.0.0.1"], 2),
    (["lsp"], 2),
    (["coverage", "reactions.nc"], 0),
    (["why", "reactions.nc"], 0),
)


@pytest.mark.nightly
def test_a_bare_installation_needs_no_library_of_an_extra(tmp_path: Path) -> None:
    """A missing library is reported with the command that installs it, never by a traceback."""
    shutil.copytree(EXAMPLES, tmp_path, dirs_exist_ok=True)
    words = [words for words, _ in IN_A_BARE_INSTALLATION]
    code = (
        "import json, sys\n"
        f"sys.modules.update(dict.fromkeys({OF_EXTRAS!r}))\n"
        "from nctakt.cli import main\n"
        f"codes = [main(words) for words in {words!r}]\n"
        "print('\\n' + json.dumps(codes))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        encoding="utf-8",
        stdin=subprocess.DEVNULL,
    )
    assert json.loads(done.stdout.splitlines()[-1]) == [code for _, code in IN_A_BARE_INSTALLATION]
    assert done.stderr.count("pip install") == 6


@pytest.mark.parametrize("name", nctakt.__all__)
def test_each_public_name_is_there_with_a_docstring(name: str) -> None:
    """By attribute, in ``dir``, in the package's docstring; what it is says its own docstring."""
    assert getattr(nctakt, name).__doc__
    assert name in dir(nctakt)
    assert f"``{name}``" in (nctakt.__doc__ or "")


def test_an_unknown_name_is_an_attribute_error() -> None:
    """As with any module."""
    with pytest.raises(AttributeError, match="'nctakt' has no attribute 'Controler'"):
        _ = nctakt.Controler
    with pytest.raises(ImportError):
        exec("from nctakt import Controler")


def test_type_checkers_see_what_is_imported() -> None:
    """The names of ``__all__``, of the imports for type checkers and of the lazy table agree."""
    tree = ast.parse(SOURCE.read_text("utf-8"))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    typed = {
        alias.name: node.module
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert typed == nctakt._MODULES
    assert sorted(typed) == sorted(nctakt.__all__)


def test_help_shows_the_names_and_the_example() -> None:
    """``help(nctakt)``."""
    text = pydoc.render_doc(nctakt, renderer=pydoc.plaintext)
    for name in nctakt.__all__:
        assert f"``{name}``" in text
    assert "run = controller.run(program" in text
    assert "class Controller(" in text


def test_the_example_of_the_docstring_runs(capsys: pytest.CaptureFixture[str]) -> None:
    """It shows a reaction."""
    lines = (nctakt.__doc__ or "").split("\n\n", 1)[1].split("\nPrograms and what", 1)[0]
    exec(compile(textwrap.dedent(lines), "help(nctakt)", "exec"), {})
    assert capsys.readouterr().out.startswith("ended ")


@pytest.mark.parametrize("name", nctakt.__all__)
def test_the_example_of_each_public_name_runs(name: str) -> None:
    """Each docstring has an example, which gives what it shows."""
    names = {name: getattr(nctakt, name) for name in nctakt.__all__}
    finder = doctest.DocTestFinder(recurse=False)
    (example,) = finder.find(names[name], name, module=False, globs=names)
    assert example.examples
    assert doctest.DocTestRunner().run(example).failed == 0


def test_a_schedule_is_simulated_for_a_time() -> None:
    """Times of all kinds; at least one NC cycle, and ticks are NC cycles."""
    schedule = nctakt.open_schedule(EXAMPLES / "schedule" / "rtconf.lis")
    cycles = [
        nctakt.simulate_schedule(schedule, until).cycles for until in ("10 ms", 0.01, "7 ticks", 0)
    ]
    assert isinstance(nctakt.simulate_schedule(schedule), Simulation)
    assert cycles == [cycles[0], cycles[0], 7, 1]
    assert cycles[0] == 10_000 // schedule.configuration.cycle_time_us
