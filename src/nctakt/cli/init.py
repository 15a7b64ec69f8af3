# SPDX-License-Identifier: MIT
"""``nctakt init``: a project file, a first test and a CI file for a folder that has lists.

In: a folder. Out: the findings below it (standard output), and the files; existing ones are not
changed. The first test uses a program without errors. No user code is run: PLCs in Python are found
by reading them.
"""

from __future__ import annotations

import ast
import re
import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import click

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Language, Severity, Text
from nctakt.base.failure import Failure
from nctakt.checking.inputs import gather
from nctakt.checking.python_check import check
from nctakt.cli import EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import language_option, table_option
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess
from nctakt.lists.machine.files import LIST_SUFFIX, STARTUP_NAMES
from nctakt.lists.machine.list_kinds import is_startup_list
from nctakt.messages import diagnostic
from nctakt.messages.commands.project import (
    FILE_KEPT,
    NO_LISTS_OR_PROGRAMS,
    NO_STARTUP_LIST,
    TAKEN_AS_STARTUP_LIST,
)
from nctakt.messages.extras import PYTEST, install_command
from nctakt.messages.files import FILE_MISSING, FILE_NOT_WRITABLE
from nctakt.project.project_file import OWN_NAME
from nctakt.run.options import BY_NAME

#: Maximum number of names in a line.
_MAX_NAMED = 5
#: Maximum number of programs checked until one has no errors.
_MAX_CHECKED = 20
_END = re.compile(rb"\bM0*(?:2|30)\b", re.IGNORECASE)
_OTHER_CHANNEL = re.compile(rb"#[ \t]*WAIT\b", re.IGNORECASE)
_FOUND = {
    "machines": Text("machines", "Maschinen"),
    "programs": Text("programs", "Programme"),
    "plcs": Text("PLCs", "SPS"),
}
_NONE = Text("none", "keine")
_WRITTEN = Text("written", "geschrieben")
_NEXT = Text("Next", "Weiter")

#: The folder in which a wheel of nctakt lies for CI.
WHEELS = "wheels"
#: The installation there, and the command for tests.
INSTALL = f'pip install {WHEELS}/nctakt-*.whl "{PYTEST}"'
#: The Python of CI, and the actions of GitHub.
PYTHON = "3.13"
CHECKOUT, SETUP_PYTHON = "actions/checkout@v5", "actions/setup-python@v6"

_GITHUB = f"""\
# Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
name: nctakt
on: [push, pull_request]
jobs:
  nctakt:
    runs-on: ubuntu-latest
    steps:
      - uses: {CHECKOUT}
      - uses: {SETUP_PYTHON}
        with:
          python-version: "{PYTHON}"
      - run: {INSTALL}
      - run: nctakt check . --format github
      - run: pytest
"""

_GITLAB = f"""\
# Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
nctakt:
  image: python:{PYTHON}
  variables:
    # The runner lets everybody write its files otherwise, and code of a PLC is not run then.
    FF_DISABLE_UMASK_FOR_DOCKER_EXECUTOR: "true"
  script:
    - {INSTALL}
    - nctakt check .
    - pytest --junitxml=report.xml
  artifacts:
    when: always
    reports:
      junit: report.xml
"""

_AZURE = f"""\
# Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
trigger:
  - "*"
pool:
  vmImage: ubuntu-latest
steps:
  - task: UsePythonVersion@0
    inputs:
      versionSpec: "{PYTHON}"
  - script: {INSTALL}
  - script: nctakt check .
  - script: pytest --junitxml=report.xml
  - task: PublishTestResults@2
    condition: always()
    inputs:
      testResultsFiles: report.xml
"""

_JENKINS = f"""\
// Checks lists and programs and runs the tests. A wheel of nctakt lies in {WHEELS}.
pipeline {{
  agent {{ docker {{ image 'python:{PYTHON}' }} }}
  stages {{
    stage('nctakt') {{
      steps {{
        sh 'python -m venv .venv'
        sh '.venv/bin/{INSTALL}'
        sh '.venv/bin/nctakt check .'
        sh '.venv/bin/pytest --junitxml=report.xml'
      }}
    }}
  }}
  post {{ always {{ junit 'report.xml' }} }}
}}
"""

#: For each system the name of its file and the text.
CI_FILES: Mapping[str, tuple[str, str]] = {
    "github": (".github/workflows/nctakt.yml", _GITHUB),
    "gitlab": (".gitlab-ci.yml", _GITLAB),
    "azure": ("azure-pipelines.yml", _AZURE),
    "jenkins": ("Jenkinsfile", _JENKINS),
}


_WHEEL = Text(
    f"put a wheel of nctakt into {WHEELS}: CI installs it",
    f"ein Wheel von nctakt nach {WHEELS} legen: die CI installiert es",
)

_MACHINE = Text(
    "the folder or start-up list of the machine, demo or demo5",
    "Ordner oder Hochlaufliste der Maschine, demo oder demo5",
)
_PLC = Text("the PLC of the runs", "die SPS der Läufe")
_UNTIL = Text("the limit of the runs", "die Grenze der Läufe")
_VALUES = Text("values before the first tick", "Werte vor dem ersten Takt")
_TESTS = Text(
    "The programs of this folder: nctakt runs them, pytest checks what comes of them.",
    "Die Programme dieses Ordners: nctakt führt sie aus, pytest prüft, was dabei herauskommt.",
)
_LANGUAGE = Text("language of messages", "Sprache der Meldungen")
_PATHS = Text("what nctakt check checks", "was nctakt check prüft")


@dataclass(frozen=True, slots=True)
class _Content:
    """The content of a folder, with relative paths; ``remarks``: notes on its lists."""

    machines: tuple[str, ...]
    programs: tuple[str, ...]
    plcs: tuple[str, ...]
    main_program: str
    remarks: tuple[Diagnostic, ...]


@described(
    "init",
    summary=Text("Make a project of your folder.", "Aus einem Ordner ein Projekt machen."),
    text=Text(
        "Find lists, programs and PLCs below a folder; write nctakt.toml, a first test and a file "
        "for CI. Files that are there stay as they are.",
        "Listen, Programme und SPS unter einem Ordner finden; nctakt.toml, einen ersten Test und "
        "eine CI-Datei schreiben. Dateien, die es schon gibt, bleiben, wie sie sind.",
    ),
    codes=(Text("the files are there", "die Dateien sind da"), None),
    notes=Text(
        "For a folder without lists: nctakt new. Nothing that is found is run.",
        "Für einen Ordner ohne Listen: nctakt new. Nichts Gefundenes wird ausgeführt.",
    ),
    examples=("nctakt init", "nctakt init cell --ci github"),
)
@click.argument("folder", metavar="[FOLDER]", default=".")
@option(
    "--ci",
    type=click.Choice(list(CI_FILES)),
    text=Text("Write a file for this CI, too.", "Auch eine Datei für diese CI schreiben."),
)
@language_option()
@table_option(BY_NAME["quiet"])
def command(folder: str, ci: str | None, language: Language, quiet: bool) -> int:
    """Make a project of a folder."""
    lines: list[str] = []
    found: Sequence[Diagnostic] = ()
    try:
        for line in _init(Path(folder), ci, language):
            lines.append(line)  # all is written before a reader of the output can end it
    except Failure as failure:
        found = failure.diagnostics
    for line in () if quiet else lines:
        click.echo(line)
    print_diagnostics(found, language)
    return EXIT_USAGE if found else EXIT_RAN


def _init(folder: Path, ci: str | None, language: Language) -> Iterator[str]:
    """Write the files; yield the findings and the files written. Raises ``Failure``."""
    if not folder.is_dir():
        raise Failure(diagnostic(FILE_MISSING, file=str(folder)))
    content = _content(folder)
    if not (content.machines or content.programs):
        lost = content.remarks or (diagnostic(NO_LISTS_OR_PROGRAMS, folder=str(folder)),)
        raise Failure(*lost)
    for one in content.remarks:
        found = replace(one, is_lenient=one.severity is Severity.ERROR)
        print_diagnostics([found], language)
    for name, label in _FOUND.items():
        yield f"{label.get(language)}: {_shown(getattr(content, name), language)}"
    files = {OWN_NAME: _project_text(content, language)}
    if content.main_program:
        files["test_programs.py"] = _test_text(content, language)
    if ci is not None:
        name, text = CI_FILES[ci]
        files[name] = text
    for name, text in files.items():
        if _write(folder / name, text):
            yield f"{_WRITTEN.get(language)}: {(folder / name).as_posix()}"
        else:
            print_diagnostics([diagnostic(FILE_KEPT, file=str(folder / name))], language)
    yield f"{_NEXT.get(language)}:"
    if ci is not None and not any((folder / WHEELS).glob("nctakt-*.whl")):
        yield f"  {_WHEEL.get(language)}"
    yield from (f"  {line}" for line in _next_commands(folder, content))


def _content(folder: Path) -> _Content:
    """Return the content below a folder, in the order of the names."""
    access = FileAccess()
    found = gather([folder], access, [])

    def names(paths: Sequence[Path]) -> tuple[str, ...]:
        return tuple(sorted({path.relative_to(folder).as_posix() for path in paths}))

    plcs = [path for one in found.plc for path in one.paths]
    plcs += [path for path in _python_files(folder) if _is_plc(path)]
    startups = [path for path, _ in found.machines]
    remarks: list[Diagnostic] = []
    if not startups and found.lists:
        startups = [path for path in found.lists if is_startup_list(path, access)]
        remarks = _remarks(folder, startups, len(found.lists))
    machines = names(startups)
    programs = names(found.programs)
    main_program = _main_program(folder, programs, machines)
    return _Content(machines, programs, names(plcs), main_program, tuple(remarks))


def _remarks(folder: Path, startups: Sequence[Path], count: int) -> list[Diagnostic]:
    """Return the note for lists none of which has the name of a start-up list."""
    usual = ", ".join(name for name in STARTUP_NAMES if name.endswith(LIST_SUFFIX))
    if not startups:
        return [diagnostic(NO_STARTUP_LIST, folder=str(folder), count=count, names=usual)]
    return [
        diagnostic(TAKEN_AS_STARTUP_LIST, file=path.as_posix(), names=usual) for path in startups
    ]


def _main_program(folder: Path, programs: Sequence[str], machines: Sequence[str]) -> str:
    """Return the first program with M2 or M30 and without errors, else the first with M2 or M30.

    A single machine counts for all programs, as the project file then says. Those of the folder
    itself come first, those that wait for another channel last.
    """
    texts = {name: FileAccess().read_bytes(folder / name) for name in programs}
    ends = sorted(
        (name for name in programs if _END.search(texts[name])),
        key=lambda name: (bool(_OTHER_CHANNEL.search(texts[name])), name.count("/")),
    )
    machine = folder / machines[0] if len(machines) == 1 else None
    for name in ends[:_MAX_CHECKED]:
        findings = check(folder / name, machine=machine)
        if all(one.severity is not Severity.ERROR for one in findings):
            return name
    return next(iter(ends or programs), "")


def _python_files(folder: Path) -> Iterator[Path]:
    """Yield the Python files below a folder, without hidden folders and environments."""
    for path in sorted(folder.iterdir()):
        if path.name.startswith(".") or path.is_symlink():
            continue
        if path.is_dir() and not (path / "pyvenv.cfg").exists():
            yield from _python_files(path)
        elif path.suffix == ".py":
            yield path


def _is_plc(path: Path) -> bool:
    """Return whether a Python file has a class that plays a PLC; it is read, not run."""
    try:
        tree = ast.parse(path.read_bytes())
    except (SyntaxError, ValueError, OSError):
        return False
    return any(isinstance(node, ast.ClassDef) and _plays_plc(node) for node in tree.body)


def _plays_plc(node: ast.ClassDef) -> bool:
    bases = {ast.unparse(base).rpartition(".")[2] for base in node.bases}
    methods = {one.name for one in node.body if isinstance(one, ast.FunctionDef)}
    return "Plc" in bases or bool({"cycle", "each_tick"} & methods)


def _project_text(content: _Content, language: Language) -> str:
    """Return the project file; an ambiguous entry is a comment with the candidates."""
    rows = [
        _row("machine", content.machines, "demo", _MACHINE.get(language)),
        _row("plc", content.plcs, "cell_plc.py", _PLC.get(language)),
        ('# until = "60 s"', _UNTIL.get(language)),
        ('# set = {"V.E.VALUE" = 5}', _VALUES.get(language)),
        (f'language = "{language}"', _LANGUAGE.get(language)),
        ('paths = ["."]', _PATHS.get(language)),
    ]
    width = max(len(entry) for entry, _ in rows)
    return "".join(f"{entry.ljust(width)}  # {comment}\n" for entry, comment in rows)


def _row(key: str, names: Sequence[str], example: str, comment: str) -> tuple[str, str]:
    """Return an entry and its comment; several or no values make it a comment."""
    if len(names) == 1:
        return f'{key} = "{names[0]}"', comment
    others = f": {', '.join(names[1:])}" if names else ""
    return f'# {key} = "{names[0] if names else example}"', comment + others


def _test_text(content: _Content, language: Language) -> str:
    """Return the first test: the program comes to its end without errors."""
    return (
        f'"""{_TESTS.get(language)}"""\n'
        f"\n\n"
        f"def test_the_program_ends(run_nc):\n"
        f'    run = run_nc("{content.main_program}")\n'
        f"    assert run.ended\n"
        f"    assert run.errors == []\n"
    )


def _write(path: Path, text: str) -> bool:
    """Write a new file; return whether there was none. Raises ``Failure`` if it cannot be."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("x", encoding="utf-8", newline="\n") as file:
            file.write(text)
    except FileExistsError:
        return False
    except OSError as error:
        reason = error.strerror or str(error)
        raise Failure(diagnostic(FILE_NOT_WRITABLE, file=str(path), reason=reason)) from error
    return True


def _next_commands(folder: Path, content: _Content) -> Iterator[str]:
    """Yield the commands from here on, with the folder's files; missing parts come before."""
    named = shlex.quote(folder.as_posix())
    yield f"nctakt check {named}"
    if not content.main_program:
        return
    program = shlex.quote((folder / content.main_program).as_posix())
    yield f"nctakt run {program}"
    for line, extra, library in (
        (f"nctakt live {program} --open", "live", "nicegui"),
        (f"nctakt test {named}", "pytest", "pytest"),
    ):
        if find_spec(library) is None:
            yield install_command(extra)
        yield line


def _shown(names: Sequence[str], language: Language) -> str:
    """Return names on a line, those beyond the first few as a number."""
    if not names:
        return _NONE.get(language)
    further = f" … (+{len(names) - _MAX_NAMED})" if len(names) > _MAX_NAMED else ""
    return ", ".join(names[:_MAX_NAMED]) + further
