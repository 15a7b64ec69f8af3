# SPDX-License-Identifier: MIT
"""The table of run options: each front end accepts an option or refuses it by name."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Any

import click
import pytest

from nctakt.base.failure import Failure
from nctakt.cli import group, main
from nctakt.debugger.arguments import Arguments
from nctakt.debugger.launch import read_configuration
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import Time
from nctakt.project.project_file import find_project
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.option_kinds import Whole
from nctakt.run.options import (
    BY_NAME,
    DATA_NAMES,
    FRONT_ENDS,
    OPTIONS,
    RUN_OPTIONS,
    ProgramOptions,
    RunKeywords,
    RunOption,
)
from nctakt.run.tape_words import KEPT, options_of_words, words_of_run
from nctakt.session.session import Session
from nctakt.studies.study import Study
from nctakt.testing.expectations import read_script
from nctakt.testing.queries import run_program

PROGRAM = "G01 X1 F6000\nM30\n"

#: A value of each option that data can say: words of the command line, data, Python's value.
VALUES: dict[str, tuple[list[str], Any, Any]] = {
    "set": (["V.E.VALUE=5"], {"V.E.VALUE": 5}, {"V.E.VALUE": 5.0}),
    "at": (
        ["2ms", "V.E.VALUE=5"],
        [["2ms", "V.E.VALUE=5"]],
        (Stimulus("2ms", "V.E.VALUE", 5.0),),
    ),
    "ticks": (["7"], 7, 7),
    "until": (["8ms"], "8ms", Time(8000)),
    "after": (["3ms"], "3ms", Time(3000)),
    "skip": (["1,3"], [1, 3], (1, 3)),
    "wait_for_start": ([], True, True),
    "signals": (["TIME,BLOCK"], ["TIME", "BLOCK"], ("TIME", "BLOCK")),
    "from_line": (["2"], 2, 2),
    "from_block": (["2"], 2, 2),
}

COMMANDS = ("run", "why", "disassemble", "coverage", "live", "serve", "study", "check", "replay")


def test_the_types_are_those_of_the_table() -> None:
    """Each option of ``Controller.run`` has a type for checkers, and a value above."""
    assert set(RunKeywords.__annotations__) == {option.name for option in RUN_OPTIONS}
    assert set(VALUES) == set(ProgramOptions.__annotations__) == set(DATA_NAMES)
    assert {end for option in OPTIONS for end in option.front_ends} == set(FRONT_ENDS)


@pytest.mark.parametrize(
    ("function", "end"), [(Controller.run, "python"), (Session.__init__, "session")]
)
def test_help_and_completion_see_each_option(function: Any, end: str) -> None:
    """``inspect.signature``, from which ``help`` and shells complete, has them with defaults."""
    parameters = inspect.signature(function).parameters
    for option in RUN_OPTIONS:
        assert (option.name in parameters) == (end in option.front_ends), option.name
        if end in option.front_ends and option.name not in ("stays", "plc"):
            assert parameters[option.name].default == option.default
            assert f"{option.name}: {option.help.en}" in function.__doc__


@pytest.mark.parametrize("command", COMMANDS)
def test_commands(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    """A command has the option with the words of the table, or says who accepts it (902380)."""
    found = group.get_command(click.Context(group), command)
    assert found is not None
    parameters = {one.name: one for one in found.params}
    for option in OPTIONS:
        parameter = parameters.get(option.word)
        if command in option.front_ends:
            assert parameter is not None, option.name
            if isinstance(parameter, click.Option):
                assert option.option in parameter.opts
                assert parameter.help == option.help.en
        elif not any(option.option in one.opts for one in found.params):
            assert main([command, option.option, "x"]) == 2
            reported = capsys.readouterr().err
            assert "error 902380: " in reported
            assert option.option in reported


@pytest.mark.parametrize("name", DATA_NAMES)
def test_words_and_data_mean_the_same(name: str) -> None:
    """The words of a command, of a tape and the data of plans and launches give one value."""
    words, data, value = VALUES[name]
    kind = BY_NAME[name].kind
    read = kind.from_data(data)
    assert (tuple(read) if name == "at" else read) == value
    given: Any = words[0] if words else True
    if name in ("set", "at"):
        given = [words[0]] if name == "set" else [tuple(words)]
    elif isinstance(kind, Whole):
        given = value  # click has read it
    assert kind.from_words(given) == value
    if name != "signals":  # no tape keeps them
        assert kind.from_words(kind.to_words(value)) == value


def options_of(end: str) -> list[RunOption]:
    """The options with a value above that a front end accepts."""
    return [one for one in RUN_OPTIONS if one.name in VALUES and end in one.front_ends]


def others_of(end: str) -> list[RunOption]:
    """The options that it does not accept."""
    return [one for one in OPTIONS if end not in one.front_ends]


def test_python_refuses_by_name() -> None:
    """``Controller.run``, ``Session`` and ``run_nc``: a TypeError names who accepts the option."""
    controller = Controller()
    program = NcText("p.nc", PROGRAM)
    calls: dict[str, Any] = {
        "python": lambda **options: controller.run(program, **options),
        "session": lambda **options: Session(program, **options),
        "test": lambda **options: run_program(controller, PROGRAM, Path(), **options),
    }
    for end, call in calls.items():
        for option in others_of(end):
            if option.name not in ("programs", "channels", "machine"):
                with pytest.raises(TypeError, match=f"'{option.name}': nctakt|: Controller"):
                    call(**{option.name: None})
    with pytest.raises(TypeError, match="did you mean until"):
        calls["python"](untill="1 s")


def test_a_launch(tmp_path: Path) -> None:
    """Each option that data can say reaches the session; others are refused (902380)."""
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, "utf-8")
    for option in options_of("launch"):
        _, data, value = VALUES[option.name]
        arguments = {"program": str(path), option.launch_name: data}
        found: Any = read_configuration(Arguments(arguments), ()).options.get(option.name)
        assert (tuple(found) if option.name == "at" else found) == value
    for option in others_of("launch"):
        with pytest.raises(Failure, match="902380"):
            read_configuration(Arguments({"program": str(path), option.launch_name: 1}), ())


def test_a_plan() -> None:
    """Each option that data can say reaches the runs of a study; others are refused (902380)."""
    program = NcText("part.nc", PROGRAM)
    for option in options_of("plan"):
        _, data, value = VALUES[option.name]
        entries = {option.name: data, "vary": [{"variable": "HLI.OVERRIDE", "values": [50]}]}
        plan = Study(program=program, **entries).plan
        own = {"set": dict(plan.assignments), "at": tuple(Stimulus(*one) for one in plan.stimuli)}
        assert own.get(option.name, plan.options.get(option.name)) == value
    for option in others_of("plan"):
        with pytest.raises(Failure, match="902380"):
            Study(program=program, **{option.name: 1})


def test_a_project_file(tmp_path: Path) -> None:
    """An option that is no setting of a project is refused (902380)."""
    file = tmp_path / "nctakt.toml"
    for option in others_of("project"):
        file.write_text(f"{option.name} = 1\n", "utf-8")
        with pytest.raises(Failure, match="902380"):
            find_project(tmp_path, FileAccess())


def test_a_comment(tmp_path: Path) -> None:
    """``given:`` says each option that the table admits there."""
    for option in options_of("comment"):
        words, _, value = VALUES[option.name]
        text = f"; given: {option.comment_name} {' '.join(words)}\nM30\n"
        script = read_script(tmp_path / "p.nc", text)
        assert {**script.options, "until": script.until}[option.name] == value, option.name


def test_a_tape() -> None:
    """What a tape keeps comes back as it was; it has a word for each option."""
    given: Any = {option.name: VALUES[option.name][2] for option in KEPT if option.name in VALUES}
    words = words_of_run(given, programs=["p.nc"])
    assert set(words) == {option.word for option in KEPT}
    read: Any = options_of_words(words)
    assert {name: read[name] for name in given} == given
