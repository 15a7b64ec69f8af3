# SPDX-License-Identifier: MIT
"""The documents against the code: what they show, name and promise is there."""

from __future__ import annotations

import ast
import functools
import importlib
import re
import runpy
import subprocess
import sys
import tomllib
from array import array
from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import takewhile
from pathlib import Path
from types import SimpleNamespace

import click
import pytest

from nctakt import __version__, cli
from nctakt.base.diagnostics import Span
from nctakt.cli import EARLIER_NAMES
from nctakt.kernel import rows
from nctakt.messages import Collector
from nctakt.plc import load_plc
from nctakt.reference.topics import explain, search
from nctakt.results.trace.events import EventDecoder
from nctakt.run.controller import Controller
from nctakt.schedule.load import read_load

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "src" / "nctakt"
DOCUMENTS = [
    ROOT / "README.md",
    ROOT / "CHANGELOG.md",
    *sorted((ROOT / "docs").glob("*.md")),
    *sorted((ROOT / "docs" / "conformance").glob("*.md")),
    ROOT / "examples" / "README.md",
]
README = (ROOT / "README.md").read_text("utf-8")
NAMES = [document.relative_to(ROOT).as_posix() for document in DOCUMENTS]
CONFORMANCE = [name for name in NAMES if name.startswith("docs/conformance/")]

_FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"\[[^\]]*\]\(([^)]+)\)")
_OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
#: Options of what is not ``nctakt``: ``scripts/docs``, pytest with the plugin.
#: Those of pytest and of the scripts beside it.
_OTHER_OPTIONS = {"--check", "--nctakt-coverage", "--nctakt-coverage-file"}
_OTHER_OPTIONS |= {"--budget", "--count", "--dist", "--numbers", "--only", "--rows", "--seed"}
_OTHER_OPTIONS |= {"--tests", "--tool"}


def text_of(name: str) -> str:
    """A document."""
    return (ROOT / name).read_text("utf-8")


def blocks(name: str) -> list[tuple[str, str]]:
    """Language and body of the fenced blocks of a document."""
    return [(language, body) for language, body in _FENCE.findall(text_of(name))]


def fences(name: str, language: str) -> list[str]:
    """The fenced blocks of a document in a language, ``""``: in none."""
    return [body for found, body in blocks(name) if found == language]


def nctakt(*words: str) -> str:
    """What the command line prints to standard output in the project's folder."""
    command = [sys.executable, "-m", "nctakt", *words]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, encoding="utf-8")
    return done.stdout


# --- README ------------------------------------------------------------------------------------


def test_the_program_of_the_readme_is_the_example() -> None:
    """What a newcomer reads first is what the command below it runs."""
    assert fences("README.md", "")[0] == text_of("examples/crossing.nc")


def test_the_readme_shows_what_the_command_prints() -> None:
    """The output is that of the command, letter by letter."""
    command, *_ = fences("README.md", "sh")
    *_, run = command.strip().split(" && ")
    program, *words = run.split()
    assert program == "nctakt"
    assert fences("README.md", "")[1] == nctakt(*words)


def test_the_readme_shows_why_a_reaction_fires() -> None:
    """The report is that of the command, letter by letter."""
    assert fences("README.md", "")[2] == nctakt("why", "examples/crossing.nc", "--line", "4")


def test_the_readme_runs_the_tests_as_the_automatic_check_does() -> None:
    """The extra that is installed and the script that is called are those of ``.ci/run``."""
    command = fences("README.md", "sh")[1].strip()
    assert command == 'pip install -e ".[test]" && python scripts/test'
    automatic = text_of(".ci/run")
    assert 'pip install --quiet -e ".[test]"' in automatic
    assert "python scripts/test" in automatic


def test_the_python_of_the_readme_runs(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The example of the API runs as it is, and prints what a reader expects."""
    monkeypatch.chdir(ROOT)
    code = fences("README.md", "python")[0]
    exec(compile(code, "README.md", "exec"), {})
    printed = capsys.readouterr().out.splitlines()
    assert printed[0] == "ended 1306 [(100, 463)]"
    assert printed[1] == "500.0 created 17 PROG"
    assert printed[2].startswith("1356 running 496.25")


def test_the_plc_of_the_documents_is_the_example_and_slows_the_path() -> None:
    """The class runs as it is; the run takes longer than without it."""
    shown = fences("docs/plc.md", "python")[1]
    assert text_of("examples/slow_plc.py").endswith(f'"""\n\n{shown}')
    program = ROOT / "examples" / "crossing.nc"
    slow = Controller().run(program, plc=load_plc(ROOT / "examples" / "slow_plc.py"))
    assert slow.state == "ended"
    assert slow.ticks > Controller().run(program).ticks


def test_each_dependency_has_its_reason() -> None:
    """A document names the dependencies of pyproject.toml, of extras and groups too, no other."""
    settings = tomllib.loads(text_of("pyproject.toml"))
    project, groups = settings["project"], settings["dependency-groups"]
    lists = (*project["optional-dependencies"].values(), *groups.values())
    extras = [one for entries in lists for one in entries]
    needed = [one for one in (*project["dependencies"], *extras) if not one.startswith("nctakt[")]
    section = text_of("docs/dependencies.md")
    rows = re.findall(r"^\| ([a-z*].+?) \|", section, re.MULTILINE)
    named = [name for row in rows for name in re.sub(r"\*\w+:\* ", "", row).split(", ")]
    assert sorted(named) == sorted(re.split(r"[><=]", one)[0] for one in needed)


def test_the_readme_is_short_and_leads_to_the_index() -> None:
    """At most 900 words, and the way to all the others."""
    assert len(README.split()) <= 900
    assert "(docs/index.md)" in README and "(docs/tutorial.md)" in README


@pytest.mark.slow
@pytest.mark.parametrize(
    "page",
    ["en", *(pytest.param(page, marks=pytest.mark.nightly) for page in ("de", "plc"))],
)
def test_the_tutorial_shows_what_happens(page: str) -> None:
    """Followed step by step in an empty folder, each command prints what the page shows."""
    command = [sys.executable, "scripts/tutorial", "--check", page]
    done = subprocess.run(command, cwd=ROOT, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


# --- commands ----------------------------------------------------------------------------------


def options_of(command: click.Command) -> set[str]:
    """All spellings of a command's options."""
    spellings = {"--help", "--version"}
    for parameter in command.params:
        spellings.update((*parameter.opts, *parameter.secondary_opts))
    return spellings


def commands(group: click.Group = cli.group) -> dict[str, click.Command]:
    """The subcommands by name, those of a subcommand as ``schedule show``."""
    context = click.Context(group)
    found: dict[str, click.Command] = {}
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        assert command is not None
        found[name] = command
        if isinstance(command, click.Group):
            found |= {f"{name} {inner}": one for inner, one in commands(command).items()}
    return found


@pytest.mark.parametrize("name", NAMES)
def test_options_and_subcommands_that_a_document_names_exist(name: str) -> None:
    """No document promises an option or a subcommand that the command line lacks."""
    known = commands()
    options = _OTHER_OPTIONS.union(*(options_of(command) for command in known.values()))
    assert set(_OPTION.findall(text_of(name))) <= options
    code = [*re.findall(r"`([^`\n]+)`", text_of(name)), *(body for _, body in blocks(name))]
    called = re.findall(r"(?:^|/|\\)nctakt ((?:schedule )?[a-z]+)", "\n".join(code), re.MULTILINE)
    assert set(called) <= {*known, *EARLIER_NAMES}


def test_the_table_of_what_is_simulated_is_current() -> None:
    """``docs/support.md`` is what ``scripts/docs`` writes."""
    command = [sys.executable, "scripts/docs", "--check"]
    done = subprocess.run(command, cwd=ROOT, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


@pytest.mark.slow
def test_the_picture_of_motions_is_what_the_runs_give() -> None:
    """Those of ``docs/pictures`` that ``scripts/pictures`` draws are what it draws."""
    command = [sys.executable, "scripts/pictures", "--check"]
    done = subprocess.run(command, cwd=ROOT, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


# --- names and places --------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_links_lead_somewhere(name: str) -> None:
    """Each link inside the project names a file that exists, and a heading of it.

    The reference is built with the site, whose builder looks at the links that lead there.
    """
    broken = []
    for target in _LINK.findall(_FENCE.sub("", text_of(name))):
        if "://" in target or target.startswith(("reference/", "../reference/")):
            continue
        path, _, heading = target.partition("#")
        file = (ROOT / name).parent / path if path else ROOT / name
        if not file.exists() or (heading and heading not in anchors(file)):
            broken.append(target)
    assert broken == []


def anchors(file: Path) -> set[str]:
    """The anchors of a document's headings, as code hosts make them."""
    headings = re.findall(r"^#+ (.+)$", file.read_text("utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", one.lower()).replace(" ", "-") for one in headings}


def test_the_python_names_of_the_readme_exist() -> None:
    """What the README names with its module can be imported."""
    for named in re.findall(r"`(nctakt\.[\w.]+)`", text_of("README.md")):
        module, _, name = named.rpartition(".")
        assert hasattr(importlib.import_module(module), name), named
    assert hasattr(Controller, "interface_image")


def test_the_index_leads_to_each_document() -> None:
    """No document is where nobody finds it: a folder's pages are in the index of the folder."""
    missing = []
    for name in (Path(name) for name in NAMES if name.startswith("docs/")):
        index = name.parent if name.stem != "index" else name.parent.parent
        link = f"({name.relative_to(index).as_posix()})"
        if index.name and link not in text_of(f"{index.as_posix()}/index.md"):
            missing.append(name)
    assert missing == []


def navigation() -> dict[str, list[str]]:
    """The groups of the site, each with the lines of its entries; those of pages end in ``.md``."""
    groups: dict[str, list[str]] = {}
    for line in text_of("mkdocs.yml").partition("\nnav:\n")[2].splitlines():
        if line.startswith("  - ") and line.endswith(":"):
            entries = groups.setdefault(line.strip("- :"), [])
        elif line.startswith("      "):
            entries.append(line)
    return groups


def pages(entries: Iterable[str]) -> list[str]:
    """The pages in the lines of a group."""
    return [line.split()[-1] for line in entries if line.endswith(".md")]


def test_the_site_has_a_search_and_the_version() -> None:
    """The hook writes it below each page."""
    assert "plugins: [search]" in text_of("mkdocs.yml")
    assert "hooks: [scripts/site_hooks.py]" in text_of("mkdocs.yml")
    config = SimpleNamespace(copyright="")
    runpy.run_path(str(ROOT / "scripts" / "site_hooks.py"))["on_config"](config)
    assert config.copyright == f"nctakt {__version__}"


def test_reports_of_faults_ask_for_the_version_with_all_that_belongs_to_it() -> None:
    """Each template asks for what ``nctakt --version --verbose`` prints."""
    for template in (ROOT / ".github" / "ISSUE_TEMPLATE").iterdir():
        assert "`nctakt --version --verbose`" in template.read_text("utf-8"), template.name


def test_the_site_has_five_groups_of_at_most_eight_entries() -> None:
    """Each page of docs is in one of them; what is built from the code is beside them."""
    groups = navigation()
    assert list(groups) == ["Start", "Test", "Look", "Connect", "Look up"]
    for entries in groups.values():
        assert sum(line.startswith("      - ") for line in entries) <= 8
    named = [page for entries in groups.values() for page in pages(entries) if "/" not in page]
    assert sorted([*named, "index.md"]) == sorted(one.name for one in (ROOT / "docs").glob("*.md"))


def test_guides_are_short() -> None:
    """At most 900 words beside what commands print; what is looked up may be longer."""
    groups = [entries for title, entries in navigation().items() if title != "Look up"]
    guides = [page for entries in groups for page in pages(entries)]
    words = {one: len(_FENCE.sub("", text_of(f"docs/{one}")).split()) for one in guides}
    assert {one: count for one, count in words.items() if count > 900} == {}


#: The guides that are there in German, too.
GERMAN = ("tutorial", "running", "checking", "why", "machine-folders")


@pytest.mark.parametrize("guide", GERMAN)
def test_the_german_guides_say_what_the_english_ones_do(guide: str) -> None:
    """The same headings in number and level, commands, files and programs, tables and lists."""
    english, german = (text_of(f"docs/{name}.md") for name in (guide, f"{guide}.de"))

    def outline(text: str) -> list[str]:
        """The beginnings of headings, rows and items, in their order."""
        return re.findall(r"^(?:#+|\||-|\d+\.)(?= )", _FENCE.sub("", text), re.MULTILINE)

    def commands_and_files(name: str) -> list[tuple[str, str]]:
        found = re.findall(r"^```([^\n]*)\n(.*?)^```$", text_of(name), re.MULTILINE | re.DOTALL)
        return [(head, body if head not in ("", "text") else "") for head, body in found]

    assert outline(german) == outline(english)
    assert commands_and_files(f"docs/{guide}.de.md") == commands_and_files(f"docs/{guide}.md")


def test_each_german_guide_is_compared() -> None:
    """No guide in German is without its English one."""
    found = {one.name.removesuffix(".de.md") for one in (ROOT / "docs").glob("*.de.md")}
    assert found == set(GERMAN)


@functools.cache
def members(path: Path) -> set[str]:
    """The classes and functions of a module: ``Name``, ``Name.method``."""
    found: set[str] = set()
    for node in ast.parse(path.read_text("utf-8")).body:
        if isinstance(node, ast.ClassDef):
            found.add(node.name)
            inner = (one for one in node.body if isinstance(one, ast.FunctionDef))
            found.update(f"{node.name}.{one.name}" for one in inner)
        elif isinstance(node, ast.FunctionDef):
            found.add(node.name)
    return found


def exists(dotted: str) -> bool:
    """Whether ``folder.module.Class.method`` is in the package."""
    parts = dotted.split(".")
    for count in range(len(parts), 0, -1):
        module = PACKAGE.joinpath(*parts[:count]).with_suffix(".py")
        if module.exists():
            rest = ".".join(parts[count:])
            return not rest or rest in members(module)
    return False


#: The pages that describe the code by the names of its functions.
ARCHITECTURE = ("docs/architecture.md", "docs/architecture-subsystems.md")


def walked() -> list[str]:
    """The names of code in the pages about the architecture, in their order, each once."""
    text = _FENCE.sub("", "\n".join(map(text_of, ARCHITECTURE)))
    found = re.findall(r"`([a-z_]+(?:\.[A-Za-z_]\w*)+)`", text)
    modules = {path.stem for path in PACKAGE.iterdir() if not path.name.startswith("__")}
    names = [one for one in found if one.split(".")[0] in modules and not one.endswith(".py")]
    return list(dict.fromkeys(names))


def test_the_walks_name_what_exists() -> None:
    """Each function, method and class of the two walks, and of the boundaries, is in the code."""
    names = walked()
    assert len(names) > 100  # the notation is still what this test understands
    assert [one for one in names if not exists(one)] == []


def test_the_map_can_be_read_at_once() -> None:
    """``docs/architecture.md`` has at most 250 lines."""
    assert len(text_of("docs/architecture.md").splitlines()) <= 250


def test_the_list_of_packages_is_complete() -> None:
    """The tree of ``docs/architecture.md`` has each package and subpackage, and no other one."""
    (tree,) = fences("docs/architecture.md", "")
    named: list[str] = []
    around: list[str] = []
    for line in tree.splitlines()[1:]:
        depth = (len(line) - len(line.lstrip())) // 2
        around = [*around[: depth - 1], line.split()[0]]
        named.append("".join(around))
    packages = {path.parent for path in PACKAGE.rglob("__init__.py")} - {PACKAGE}
    assert sorted(named) == sorted(f"{path.relative_to(PACKAGE).as_posix()}/" for path in packages)


@pytest.mark.parametrize("name", [*ARCHITECTURE, "README.md", *CONFORMANCE])
def test_tests_and_files_that_a_document_names_exist(name: str) -> None:
    """``tests/…::name`` is a test, ``tests/…``, ``scripts/…``, ``src/…`` are files or folders."""
    missing = []
    text = _FENCE.sub("", text_of(name))
    for named in re.findall(r"`((?:tests|scripts|src|examples|benchmarks)/[^`]+)`", text):
        path, _, function = named.partition("::")
        file = ROOT / path
        if not file.exists() or (function and function not in members(file)):
            missing.append(named)
    assert missing == []


def decisions() -> Iterator[list[str]]:
    """The rows of ``docs/conformance``: question, decision, reason, test."""
    for name in CONFORMANCE:
        for line in text_of(name).splitlines() if not name.endswith("index.md") else ():
            if line.startswith("| ") and not line.startswith("| question"):
                yield re.split(r"(?<!\\) \| ", line.removeprefix("| ").removesuffix(" |"))


def test_each_decision_has_its_reason_and_its_test() -> None:
    """Every row of ``docs/conformance`` has four cells, the last one with a test or "none"."""
    rows = list(decisions())
    assert rows
    assert [row for row in rows if len(row) != 4 or not all(map(str.strip, row))] == []
    assert [row for row in rows if "`tests/" not in row[3] and row[3] != "no test yet"] == []


def test_no_question_is_decided_twice() -> None:
    """Two rows with one question, whatever number it names, would contradict each other one day."""
    questions = [re.sub(r" \(\d+\)", "", row[0]).casefold() for row in decisions()]
    assert [one for one, count in Counter(questions).items() if count > 1] == []


def test_each_number_in_the_decisions_is_explained() -> None:
    """``nctakt explain`` has an article for each message that a decision names, or about it."""
    named = re.compile(r"(?<![\w.,-])\d{5,6}(?![\w,.]*\d)")
    text = " ".join(" ".join(row[:3]) for row in decisions())
    numbers = set(named.findall(text))
    assert len(numbers) > 100
    assert (
        sorted(number for number in numbers if not (explain(number) or search(number, "en"))) == []
    )


def test_what_chance_tries_can_be_tried_as_often_as_wanted() -> None:
    """Each test that ``docs/reliability.md`` names takes its number from ``NCTAKT_SEEDS``."""
    files = re.findall(r"^\| `(tests/\S+)` \|", text_of("docs/reliability.md"), re.M)
    assert len(files) > 10
    assert [file for file in files if "from support.random_seeds import" not in text_of(file)] == []


# --- scheduling --------------------------------------------------------------------------------


def test_the_load_file_of_the_documents_is_read() -> None:
    """The example of a load file has nothing that ``nctakt schedule`` would refuse."""
    (shown,) = fences("docs/scheduling.md", "toml")
    collector = Collector()
    load = read_load("load.toml", shown, collector)
    assert collector.diagnostics == []
    assert load.seed == 1


# --- traces ------------------------------------------------------------------------------------


@pytest.mark.nightly
@pytest.mark.slow
def test_the_traces_in_the_documents_are_real(tmp_path: Path) -> None:
    """The lines of both formats are in the files written by the example's run."""
    csv, jsonl, blocks = fences("docs/traces.md", "")
    for shown, file, words in (
        (csv, tmp_path / "part.csv", ["X.ACS.ACT_POS,V.E.COUNT"]),
        (jsonl, tmp_path / "part.jsonl", ["X.ACS.ACT_POS"]),
        (blocks, tmp_path / "part.csv", ["BLOCK", "--blocks"]),
    ):
        nctakt("run", "examples/crossing.nc", "--trace", str(file), "--signals", *words)
        lines = file.read_text("utf-8").splitlines()
        assert [line for line in shown.splitlines() if line not in lines] == []


def test_the_signals_in_the_documents_can_be_recorded() -> None:
    """Each name of the table of signals is known to the demo machine."""
    section = text_of("docs/traces.md").split("## Signals")[1].split("\n## ")[0]
    names = re.findall(
        r"`((?:X|PATH|OVERRIDE|CYCLES|LOOP|V)\.[\w.\[\]]+|BLOCK|MEAS_DELTA)`", section
    )
    assert len(names) > 15
    run = Controller().run(ROOT / "examples" / "crossing.nc", ticks=1, signals=names)
    assert run.trace is not None
    assert list(run.trace) == list(dict.fromkeys(names))


class _Names:
    """Any name for any number."""

    def cycle(self, serial: int) -> str:
        return str(serial)

    def variable(self, cell: int) -> str:
        return str(cell)

    def axis(self, index: int) -> str:
        return str(index)

    def message(self, number: int) -> str:
        return str(number)

    def spindle(self, number: int) -> str:
        return f"S{number + 1}"

    def user_text(self, number: int) -> str:
        return ""

    def variable_text(self, number: int) -> str:
        return str(number)

    def thread(self, number: int) -> str:
        """The name of a thread."""
        return f"T{number}"

    def program(self, number: int) -> str:
        return str(number)

    def span(self, source: int) -> Span | None:
        return None


def test_the_kinds_of_events_are_those_of_the_code() -> None:
    """The table of events has each kind that a run can record, and no other."""
    section = text_of("docs/traces.md").split("## Events")[1]
    lines = re.findall(r"^\| (`.+?) \|", section, re.MULTILINE)
    named = [kind for line in lines for kind in re.findall(r"`(\w+)`", line)]
    names = list(vars(rows))
    behind = names[names.index("EVENT_CREATED") :]
    kinds = [getattr(rows, name) for name in takewhile(re.compile("EVENT_").match, behind)]
    decoder = EventDecoder(1000, _Names())
    with_choices = (rows.EVENT_CREATED, rows.EVENT_ENDED)
    with_choices += (rows.EVENT_USER_VALUE, rows.EVENT_USER_TEXT)
    with_choices += (rows.EVENT_AXIS_ENDED, rows.EVENT_AXIS_CHANGED, rows.EVENT_AXIS_EXCHANGED)
    numbers = (0.0, -1.0, 50900.0, 20824.0)  # an M and an H function, an error and a warning
    reported = {
        event.kind
        for kind in kinds
        for number in (numbers if kind not in with_choices else (0.0,))
        for event in decoder.decode(
            array("d", (0.0, kind, 0.0, 0.0, 1.0, number, 1.0, 0.0)).tobytes()
        )
    }
    assert sorted(named) == sorted(reported)


# --- version -----------------------------------------------------------------------------------


def test_the_newest_version_of_the_changelog_is_the_package() -> None:
    """pyproject.toml, the package and the changelog agree."""
    project = tomllib.loads(text_of("pyproject.toml"))["project"]
    newest = re.findall(r"^## \[(.+?)\]", text_of("CHANGELOG.md"), re.MULTILINE)[0]
    assert project["version"] == __version__ == newest


def test_the_changelog_says_each_thing_once() -> None:
    """The newest version has Added, Changed and Fixed; all lines are short, none is there twice."""
    text = text_of("CHANGELOG.md")
    newest = text.split("\n## [")[1]
    assert re.findall(r"^### (.+)$", newest, re.MULTILINE) == ["Added", "Changed", "Fixed"]
    lines = re.findall(r"^- .+$", text, re.MULTILINE)
    assert [line for line in lines if len(line) > 200] == []
    assert [line for line, count in Counter(lines).items() if count > 1] == []
