# SPDX-License-Identifier: MIT
"""A launch configuration -> the session that it asks for.

In: the arguments of ``launch``. Out: ``Configuration``, which opens the session as often as the
debugger restarts; missing values come from the project, as on the command line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.debugger.arguments import Arguments
from nctakt.files.access import FileAccess
from nctakt.messages import diagnostic
from nctakt.messages.connections.debugger import WRONG_ARGUMENT
from nctakt.messages.files import FILE_MISSING
from nctakt.project.run_settings import Named, RunSettings, run_settings
from nctakt.run.option_kinds import UnfitDataError
from nctakt.run.options import DATA_NAMES, ProgramOptions, accepted_by, refused
from nctakt.session.session import Session


@dataclass(frozen=True, slots=True)
class Configuration:
    """What is run, and where the debugger stops unasked.

    ``stops_at_end``: the run stays at its end until it is left; else the debugger ends with it.
    """

    channels: Mapping[int, Sequence[Path]]
    settings: RunSettings
    options: ProgramOptions
    acknowledges: bool
    stops_on_entry: bool
    stops_at_end: bool
    has_breakpoints: bool
    language: Language | None
    folders: Sequence[str]

    def open(self) -> Session:
        """Return the session before its first tick; raises ``Failure``."""
        own_values = self.options.get("set") or {}
        options: ProgramOptions = {
            **self.options,
            "set": {**self.settings.values, **own_values},
            "until": self.settings.until,
        }
        try:
            return Session(
                *self.channels.get(1, ()),
                channels={
                    number: programs for number, programs in self.channels.items() if number != 1
                },
                machine=self.settings.machine,
                plc=self.settings.plcs,
                acknowledges=self.acknowledges,
                folders=self.folders,
                **options,
            )
        except Failure as failure:
            raise self.settings.placed(failure) from failure

    def at_line(self, line: int) -> Configuration:
        """Return the same, whose first program begins at the block of a line."""
        options = cast("ProgramOptions", {**self.options, "from_line": line, "from_block": None})
        return replace(self, options=options)

    @property
    def program(self) -> str:
        """The name of the first program."""
        return next((str(programs[0]) for programs in self.channels.values() if programs), "")


def read_configuration(arguments: Arguments, folders: Sequence[str]) -> Configuration:
    """Return the configuration of a launch; ``folders``: the only ones that may be read.

    Raises ``Failure`` for unusable arguments.
    """
    base = Path(arguments.text("cwd", ""))
    access = FileAccess(folders)
    channels = {1: _paths(arguments.texts("program"), base, access)}
    for name, value in arguments.entries("channels").items():
        if not name.isdecimal() or len(name) > 4:
            raise Failure(diagnostic(WRONG_ARGUMENT, name="channels", expected='{"2": "b.nc"}'))
        programs = Arguments({"program": value}, f"channels.{name}").texts("program")
        channels[int(name)] = _paths(programs, base, access)
    first = next((programs[0] for programs in channels.values() if programs), None)
    if first is None:
        raise Failure(diagnostic(WRONG_ARGUMENT, name="program", expected="the path of a program"))
    options = _options(arguments)
    until = arguments.optional_text("until")
    machine = arguments.optional_text("machine")
    plcs = tuple(arguments.texts("plc")) if arguments.has("plc") else ()
    values = options.get("set") or {}
    named = Named(machine=machine, plcs=plcs, values=values, until=until, base=base)
    settings = run_settings(
        [one for programs in channels.values() for one in programs], access, named
    )
    if machine is not None and settings.machine is not None:
        access.check_admitted(settings.machine)
    if settings.plcs:
        _paths(plcs, base, access)
    has_breakpoints = not arguments.flag("noDebug")
    return Configuration(
        channels,
        settings,
        options,
        not arguments.flag("acknowledge"),
        arguments.flag("stopOnEntry") and has_breakpoints,
        arguments.flag("stopAtEnd", True) and has_breakpoints,
        has_breakpoints,
        _language(arguments.optional_text("language")),
        folders,
    )


def _paths(names: Sequence[str], base: Path, access: FileAccess) -> list[Path]:
    """Return files that exist and may be read."""
    paths = [base / name for name in names]
    for path in paths:
        access.check_admitted(path)
        if not path.is_file():
            raise Failure(diagnostic(FILE_MISSING, file=str(path)))
    return paths


def _options(arguments: Arguments) -> ProgramOptions:
    """Return the run options of a launch; raises ``Failure`` (901224, 902380)."""
    for name in arguments.names():
        found = refused(name, "launch")
        if found is not None:
            raise Failure(found)
    options: dict[str, Any] = {}
    for option in accepted_by("launch"):
        name = option.launch_name
        if option.name not in DATA_NAMES or not arguments.has(name):
            continue
        try:
            options[option.name] = option.kind.from_data(arguments.value(name))
        except UnfitDataError as error:
            found = diagnostic(WRONG_ARGUMENT, name=name + error.path, expected=error.expected)
            raise Failure(found) from error
    return cast("ProgramOptions", options)


def _language(word: str | None) -> Language | None:
    if word is None:
        return None
    if word not in ("en", "de"):
        raise Failure(diagnostic(WRONG_ARGUMENT, name="language", expected="en, de"))
    return "de" if word == "de" else "en"
