# SPDX-License-Identifier: MIT
"""A launch configuration -> the session that it asks for.

In: the arguments of ``launch``. Out: ``Configuration``, which opens the session as often as the
debugger restarts; what it leaves out comes from the project, as on the command line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Language
from nctakt.base.failure import Failure
from nctakt.debugger.arguments import Arguments
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import Time, read_time
from nctakt.messages import diagnostic
from nctakt.messages.debugger import WRONG_ARGUMENT
from nctakt.messages.files import FILE_MISSING
from nctakt.project.run_settings import Named, RunSettings, run_settings
from nctakt.run.stimuli import Stimulus, parse_stimulus
from nctakt.session.session import Session


@dataclass(frozen=True, slots=True)
class Configuration:
    """What is run, and where the debugger stops by itself.

    ``stops_at_end``: the run stands at its end until it is left; else the debugger ends with it.
    """

    channels: Mapping[int, Sequence[Path]]
    settings: RunSettings
    set: Mapping[str, float | str]
    at: Sequence[Stimulus]
    after: Time
    skip: Sequence[int]
    waits_for_start: bool
    acknowledges: bool
    stops_on_entry: bool
    stops_at_end: bool
    has_breakpoints: bool
    language: Language | None
    folders: Sequence[str]
    from_line: int | None = None
    from_block: int | None = None

    def open(self) -> Session:
        """Return the session before its first tick; raises ``Failure``."""
        try:
            return Session(
                *self.channels.get(1, ()),
                channels={number: own for number, own in self.channels.items() if number != 1},
                machine=self.settings.machine,
                plc=self.settings.plc,
                set={**self.settings.values, **self.set},
                at=self.at,
                until=self.settings.until,
                after=self.after,
                wait_for_start=self.waits_for_start,
                skip=self.skip,
                acknowledges=self.acknowledges,
                folders=self.folders,
                from_line=self.from_line,
                from_block=self.from_block,
            )
        except Failure as failure:
            raise self.settings.placed(failure) from failure

    @property
    def program(self) -> str:
        """The name of the first program."""
        return next((str(own[0]) for own in self.channels.values() if own), "")


def read_configuration(arguments: Arguments, folders: Sequence[str]) -> Configuration:
    """Return the configuration of a launch; ``folders``: the only ones that may be read.

    Raises ``Failure`` for what cannot be used.
    """
    base = Path(arguments.text("cwd", ""))
    access = FileAccess(folders)
    channels = {1: _paths(arguments.texts("program"), base, access)}
    for name, value in arguments.entries("channels").items():
        if not name.isdecimal() or len(name) > 4:
            raise Failure(diagnostic(WRONG_ARGUMENT, name="channels", expected='{"2": "b.nc"}'))
        own = Arguments({"program": value}, f"channels.{name}").texts("program")
        channels[int(name)] = _paths(own, base, access)
    first = next((own[0] for own in channels.values() if own), None)
    if first is None:
        raise Failure(diagnostic(WRONG_ARGUMENT, name="program", expected="the path of a program"))
    own_values = _assignments(arguments)
    machine, plc, until = (arguments.optional_text(name) for name in ("machine", "plc", "until"))
    named = Named(machine=machine, plc=plc, values=own_values, until=until, base=base)
    settings = run_settings([one for own in channels.values() for one in own], access, named)
    if until is not None:
        read_time(until)
    if machine is not None and settings.machine is not None:
        access.check_admitted(settings.machine)
    if plc is not None and settings.plc is not None:
        _paths([plc], base, access)
    has_breakpoints = not arguments.flag("noDebug")
    return Configuration(
        channels,
        settings,
        own_values,
        [_stimulus(item) for item in arguments.items("at")],
        read_time(arguments.text("after", "0")),
        _levels(arguments.items("skip")),
        arguments.flag("waitForStart"),
        not arguments.flag("acknowledge"),
        arguments.flag("stopOnEntry") and has_breakpoints,
        arguments.flag("stopAtEnd", True) and has_breakpoints,
        has_breakpoints,
        _language(arguments.optional_text("language")),
        folders,
        *(arguments.number(name, 0) or None for name in ("fromLine", "fromBlock")),
    )


def _paths(names: Sequence[str], base: Path, access: FileAccess) -> list[Path]:
    """Return files that exist and may be read."""
    paths = [base / name for name in names]
    for path in paths:
        access.check_admitted(path)
        if not path.is_file():
            raise Failure(diagnostic(FILE_MISSING, file=str(path)))
    return paths


def _assignments(arguments: Arguments) -> dict[str, float | str]:
    """Return the values before the first tick."""
    values: dict[str, float | str] = {}
    for name, value in arguments.entries("set").items():
        if isinstance(value, bool | int | float):
            values[name] = float(value)
        elif isinstance(value, str):
            values[name] = value
        else:
            expected = "a number or a text"
            raise Failure(diagnostic(WRONG_ARGUMENT, name=f"set.{name}", expected=expected))
    return values


def _stimulus(item: Any) -> Stimulus:
    """Return a value at a time, from ``["20 ms", "V.E.X=1"]``."""
    if isinstance(item, list) and len(item) == 2 and all(isinstance(one, str) for one in item):
        return parse_stimulus(item[0], item[1])
    raise Failure(diagnostic(WRONG_ARGUMENT, name="at", expected='[["20 ms", "V.E.X=1"], …]'))


def _levels(items: Sequence[Any]) -> list[int]:
    if not all(isinstance(item, int) and 1 <= item <= 10 for item in items):
        raise Failure(diagnostic(WRONG_ARGUMENT, name="skip", expected="[1, …, 10]"))
    return list(items)


def _language(word: str | None) -> Language | None:
    if word is None:
        return None
    if word not in ("en", "de"):
        raise Failure(diagnostic(WRONG_ARGUMENT, name="language", expected="en, de"))
    return "de" if word == "de" else "en"
