# SPDX-License-Identifier: MIT
"""``nctakt test``: expectations of NC files, suites in Structured Text, and Python tests.

In: files and folders, the selected tests. Out: the output of pytest with the plugins of nctakt, a
JUnit file if asked for, and the exit code as that of ``nctakt check``.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from importlib.metadata import entry_points
from itertools import takewhile
from pathlib import Path

import click

from nctakt.base.diagnostics import LANGUAGE_VARIABLE, Language, Text
from nctakt.base.failure import Failure
from nctakt.cli import EXIT_INTERNAL, EXIT_NC_ERROR, EXIT_RAN, EXIT_USAGE
from nctakt.cli.common.help import described, option
from nctakt.cli.common.options import TRUST_OPTION, language_option
from nctakt.cli.common.terminal import print_diagnostics
from nctakt.files.access import FileAccess, missing_file
from nctakt.files.output import OutputFile
from nctakt.messages import diagnostic
from nctakt.messages.commands.project import TESTS_NOT_TRUSTED
from nctakt.messages.plcs.unit_tests import NOTHING_CHOSEN, NOTHING_TESTED, PYTEST_MISSING
from nctakt.project.trust import list_of_trusted, why_distrusted
from nctakt.testing.language import language_of_tests

#: The plugins of nctakt, where the installation does not announce them.
_PLUGINS = ("nctakt.testing.plugin", "nctakt.studies.fixture")
#: Exit codes of pytest: all passed, failed, interrupted or not read, internal error, wrong usage.
_CODES = {
    0: EXIT_RAN,
    1: EXIT_NC_ERROR,
    2: EXIT_NC_ERROR,
    3: EXIT_INTERNAL,
    4: EXIT_USAGE,
    5: EXIT_USAGE,
}
_NO_TESTS = 5
#: Files that pytest reads from parent folders, and runs in named ones.
_SETTINGS = (
    "conftest.py",
    *(f"{dot}pytest.{kind}" for dot in ("", ".") for kind in ("ini", "toml")),
    *("pyproject.toml", "tox.ini", "setup.cfg"),
)
_TESTS = ("conftest.py", "test_*.py", "*_test.py")


@described(
    "test",
    summary=Text("Run tests of programs and of the PLC.", "Programme und SPS testen."),
    text=Text(
        "Run the tests of a project: expectations in NC files, suites of the PLC, Python tests.",
        "Die Tests eines Projekts ausführen: Erwartungen in NC-Dateien, Suiten der SPS, "
        "Tests in Python.",
    ),
    codes=(
        Text("all tests passed", "alle Tests bestanden"),
        Text(
            "a test failed, or a file has errors", "ein Test scheitert oder eine Datei hat Fehler"
        ),
    ),
    notes=Text(
        "It is pytest with the plugins of nctakt; further words after -- go to pytest. Times in "
        "the JUnit file are those of the machine.",
        "Es ist pytest mit den Plugins von nctakt; weitere Wörter nach -- gehen an pytest. Zeiten "
        "in der JUnit-Datei sind die der Maschine.",
    ),
    examples=(
        "nctakt test plc/",
        'nctakt test -x -k "gate and not open"',
        "nctakt test . --junit report.xml -- -n 2",
    ),
)
@click.argument("paths", metavar="[FILE|FOLDER...]", nargs=-1)
@option(
    "-k",
    "expression",
    metavar="EXPRESSION",
    text=Text(
        "Only tests whose names match: 'gate and not open'.",
        "Nur Tests, deren Namen passen: 'gate and not open'.",
    ),
)
@option(
    "-x",
    "at_first",
    is_flag=True,
    text=Text("End at the first failure.", "Beim ersten Fehler enden."),
)
@option(
    "-j",
    "--processes",
    type=click.IntRange(1),
    default=1,
    metavar="N",
    text=Text(
        "Suites of how many files run at the same time [default: 1].",
        "Suiten von wie vielen Dateien gleichzeitig laufen [Vorgabe: 1].",
    ),
)
@option(
    "--junit",
    metavar="FILE",
    group="files",
    text=Text("Write the results as JUnit XML.", "Die Ergebnisse als JUnit-XML schreiben."),
)
@TRUST_OPTION
@language_option()
def command(
    paths: tuple[str, ...],
    expression: str | None,
    at_first: bool,
    processes: int,
    junit: str | None,
    language: Language,
) -> int:
    """Run tests."""
    words = [*(["-k", expression] if expression else ()), *(["-x"] if at_first else ())]
    words.append(f"--nctakt-processes={processes}")
    try:
        with _telling_in(language):
            return _tested([*paths], words, junit, language)
    except Failure as failure:
        print_diagnostics(failure.diagnostics, language)
        return EXIT_USAGE


@contextlib.contextmanager
def _telling_in(language: Language) -> Iterator[None]:
    """Make tests report mistakes in a language, also in the processes that they start."""
    before = os.environ.get(LANGUAGE_VARIABLE)
    if language == language_of_tests():
        yield
        return
    os.environ[LANGUAGE_VARIABLE] = language
    try:
        yield
    finally:
        del os.environ[LANGUAGE_VARIABLE]
        if before is not None:
            os.environ[LANGUAGE_VARIABLE] = before


def _tested(paths: list[str], words: list[str], junit: str | None, language: Language) -> int:
    """Run pytest; raises ``Failure`` without it, and for a file that is not there or written."""
    try:
        import pytest  # noqa: PLC0415 - only this command needs it
    except ImportError as error:
        raise Failure(diagnostic(PYTEST_MISSING)) from error
    _check_there(paths)
    _check_trusted(paths)
    known = {one.name for one in entry_points(group="pytest11")}
    plugins = [] if "nctakt" in known else [part for name in _PLUGINS for part in ("-p", name)]
    # This process has imported modules that pytest would rewrite: nctakt's asserts are not tests.
    plugins += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]
    if _is_parallel(paths):
        plugins += ["--dist", "loadfile"]  # the suites of a file run together
    code = _NO_TESTS
    if junit is None:
        code = int(pytest.main([*plugins, *words, *paths]))
    else:
        access = FileAccess()
        for path in filter(Path.is_file, map(Path, paths)):
            access.note(path)

        def write(report: Path) -> None:
            nonlocal code
            from nctakt.testing.junit import ReportName, group_suites  # noqa: PLC0415 - imports pytest

            own = [ReportName(report, Path(junit))]
            files = [f"--junitxml={report}", "-o", "junit_family=xunit1"]  # with file and line
            code = int(pytest.main([*plugins, *words, *files, *paths], own))
            if report.exists() and report.stat().st_size:
                group_suites(report)

        with OutputFile(junit, "--junit", access) as output:
            output.fill(write)
    if code == _NO_TESTS:
        named = ", ".join(path for path in paths if Path(path).exists()) or "."
        found = diagnostic(NOTHING_TESTED, paths=named)
        if words[:1] == ["-k"]:
            found = diagnostic(NOTHING_CHOSEN, paths=named, expression=words[1])
        print_diagnostics([found], language)
    return _CODES.get(code, EXIT_INTERNAL)


def _check_trusted(words: list[str]) -> None:
    """Raise ``Failure`` (902971) if pytest would run code that may be somebody else's.

    It takes settings and ``conftest.py`` from the folders of the tests and all above.
    """
    for path in [Path(word.partition("::")[0]) for word in _paths(words)] or [Path()]:
        folder = path.absolute() if path.is_dir() else path.absolute().parent
        files = [one / name for one in (folder, *folder.parents) for name in _SETTINGS]
        files += [path] if path.suffix == ".py" else []
        files += [one for pattern in _TESTS for one in sorted(path.rglob(pattern))]
        for file in filter(Path.is_file, files):
            beside = file.absolute().parent
            reason = why_distrusted([file], beside)
            if reason is not None:
                raise Failure(
                    diagnostic(
                        TESTS_NOT_TRUSTED,
                        file=str(file),
                        reason=reason,
                        folder=str(beside),
                        list=str(list_of_trusted()),
                    )
                )


def _paths(words: list[str]) -> Iterator[str]:
    """Return an iterator over the words before pytest's options."""
    return takewhile(lambda one: not one.startswith("-"), words)


def _is_parallel(words: list[str]) -> bool:
    """Return whether words for pytest want several processes, and leave open how tests share."""
    wants = any(word[:2] == "-n" or word.startswith("--numprocesses") for word in words)
    return wants and not any(word.startswith("--dist") for word in words)


def _check_there(words: list[str]) -> None:
    """Raise ``Failure`` for a file or folder that is not there; what follows an option is pytest's.

    The name of a test within a file comes after ``::``.
    """
    for word in _paths(words):
        path = Path(word.partition("::")[0])
        if path.exists():
            continue
        raise Failure(missing_file(path))
