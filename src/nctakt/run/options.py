# SPDX-License-Identifier: MIT
"""The run options: each is declared here once, and everything that takes options follows.

A row has name, kind of value, default, meaning in both languages, and the front ends that accept
it: commands, Python, tests, the project file, plans of studies, the debugger, tapes. They read,
check, complete and pass on the options by this table; an option that a front end does not accept is
refused by name, with those that do (902380). ``ProgramOptions`` and ``RunKeywords`` give type
checkers and editors the same names with their types; ``tests/run/test_options.py`` compares them.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar, cast

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import Diagnostic, Text
from nctakt.base.failure import Failure
from nctakt.base.misspelling import nearest
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import OPTION_OF_OTHERS
from nctakt.messages.programs.block_search import BOTH_STARTS_GIVEN
from nctakt.run.option_kinds import (
    Assignments,
    Callback,
    ChannelPrograms,
    Flag,
    Folders,
    Instance,
    Instances,
    Kind,
    Moment,
    Names,
    Objects,
    Programs,
    SkipLevels,
    Stimuli,
    Whole,
    Words,
)

if TYPE_CHECKING:
    from nctakt.decoder.cycles.builder import CycleDefinition
    from nctakt.lists.format.times import TimeLike
    from nctakt.results.run import ProgramMessage
    from nctakt.results.trace.sinks import Sink
    from nctakt.run.access.inputs import InputListener
    from nctakt.run.access.stimuli import StimulusLike
    from nctakt.run.access.tape import Tape
    from nctakt.run.plcs.coupling import Coupled
    from nctakt.run.plcs.plc_view import GivenPlc


class UnknownOptionError(TypeError):
    """A function of Python does not accept a keyword."""


class ProgramOptions(TypedDict, total=False):
    """The options that data can say: they are the same for every front end."""

    set: Mapping[str, float | str] | None
    at: Sequence[StimulusLike]
    ticks: int | None
    until: TimeLike | None
    after: TimeLike
    skip: Collection[int]
    wait_for_start: bool
    signals: Sequence[str] | None
    from_line: int | None
    from_block: int | None


class KeywordsOfAnyResult(ProgramOptions, total=False):
    """The options of ``Controller.run`` that the type of its result does not depend on."""

    plc: GivenPlc | Sequence[GivenPlc] | None
    fmu: Coupled | None
    sinks: Sequence[Sink]
    record_writes: bool
    blocks: bool
    condition_signals: bool
    stays: bool
    on_message: Callable[[ProgramMessage], None] | None
    on_progress: Callable[[int, int | None], None] | None
    on_cycle: Callable[[str, CycleDefinition], None] | None
    record: InputListener | None
    replay: Tape | None


class RunKeywords(KeywordsOfAnyResult, total=False):
    """The options of ``Controller.run``."""

    memory_trace: bool
    why: bool


#: Front ends that accept options: commands by their names, all others as named in messages.
FRONT_ENDS: Mapping[str, Text] = {
    **{
        name: Text(f"nctakt {name}", f"nctakt {name}")
        for name in (
            "run", "why", "time", "compare", "disassemble", "coverage", "live", "serve", "study",
            "check", "replay", "fmu",
        )
    },
    "python": Text("Controller.run", "Controller.run"),
    "session": Text("Session", "Session"),
    "test": Text("run_nc", "run_nc"),
    "comment": Text("the comment 'given:'", "der Kommentar 'given:'"),
    "project": Text("the project file", "die Projektdatei"),
    "plan": Text("a plan", "ein Plan"),
    "launch": Text("a launch configuration", "eine Startkonfiguration"),
    "tape": Text("a tape", "ein Band"),
}  # fmt: skip

_RUNS = "run why time compare disassemble coverage"
_SESSIONS = "live serve"
_DATA = "python session test plan launch"


@dataclass(frozen=True, slots=True, kw_only=True)
class RunOption:
    """A run option; ``accepted_by``: the front ends, separated by blanks.

    ``words``: its name among the words of a command and on a tape; ``flag``: its name on the
    command line; ``comment``: in a comment of a program; ``default``: of a value from Python.
    ``metavar``: how help calls the value, if its kind does not say it well enough. ``is_read``: it
    has words that have to be read for ``Controller.run``.
    """

    name: str
    kind: Kind
    help: Text
    accepted_by: str
    default: Any = None
    group: str = "run"
    words: str = ""
    flag: str = ""
    comment: str = ""
    metavar: str = ""

    @property
    def front_ends(self) -> tuple[str, ...]:
        """The front ends that accept it."""
        return tuple(self.accepted_by.split())

    @property
    def word(self) -> str:
        """Its name among the words of a command and on a tape."""
        return self.words or self.name

    @property
    def option(self) -> str:
        """Its name on the command line."""
        return self.flag or f"--{self.name.replace('_', '-')}"

    @property
    def launch_name(self) -> str:
        """Its name in a launch configuration, in camel case."""
        first, *others = self.name.split("_")
        return first + "".join(word.title() for word in others)

    @property
    def comment_name(self) -> str:
        """Its name in a comment ``given:``."""
        return self.comment or self.name.replace("_", " ")

    def name_in(self, front_end: str) -> str:
        """Return how a front end spells it."""
        match front_end:
            case "launch":
                return self.launch_name
            case "comment":
                return self.comment_name
            case "python" | "session" | "test" | "project" | "plan" | "tape":
                return self.name
        return self.option


#: The options, in the order of help, checks and tapes.
OPTIONS: Sequence[RunOption] = (
    RunOption(
        name="programs",
        kind=Programs(),
        help=Text("The programs of channel 1.", "Die Programme von Kanal 1."),
        accepted_by=f"{_RUNS} {_SESSIONS} python session launch tape fmu",
        group="machine",
    ),
    RunOption(
        name="channels",
        kind=ChannelPrograms(),
        help=Text(
            "Run a program in channel N at the same time; may be repeated.",
            "Gleichzeitig ein Programm in Kanal N ausführen; mehrfach möglich.",
        ),
        accepted_by=f"{_RUNS} {_SESSIONS} python session comment launch tape fmu",
        group="machine",
        words="others",
        flag="--channel",
        comment="channel",
    ),
    RunOption(
        name="machine",
        kind=Words("FOLDER"),
        help=Text(
            "Folder with the machine's lists, demo or demo5 [default: the project's, else the one "
            "around the program, else demo].",
            "Ordner mit den Listen der Maschine, demo oder demo5 [Vorgabe: die des Projekts, sonst "
            "die um das Programm, sonst demo].",
        ),
        accepted_by=f"{_RUNS} {_SESSIONS} study check session comment project plan launch tape fmu",
        group="machine",
    ),
    RunOption(
        name="root",
        kind=Words("FOLDER"),
        help=Text(
            "Controller's root folder, where lists name files.",
            "Wurzelordner der Steuerung, in dem Listen Dateien nennen.",
        ),
        accepted_by=f"{_RUNS} check tape",
        group="machine",
    ),
    RunOption(
        name="set",
        kind=Assignments(),
        help=Text(
            "Set a variable before the first tick.", "Eine Variable vor dem ersten Takt setzen."
        ),
        accepted_by=f"{_RUNS} {_SESSIONS} study {_DATA} project tape fmu",
        words="assignments",
    ),
    RunOption(
        name="at",
        kind=Stimuli(),
        help=Text(
            "Set a variable at a time of the run.", "Eine Variable zu einer Zeit des Laufs setzen."
        ),
        accepted_by=f"{_RUNS} {_SESSIONS} study {_DATA}",
        default=(),
        words="stimuli",
    ),
    RunOption(
        name="ticks",
        kind=Whole(checked_from=0),
        help=Text("Run at most N ticks.", "Höchstens N Takte ausführen."),
        accepted_by=f"{_RUNS} study {_DATA} comment tape",
    ),
    RunOption(
        name="until",
        kind=Moment(is_optional=True),
        help=Text(
            "Limit of the run [default: the project's, else 10min; of nctakt live 24h].",
            "Grenze des Laufs [Vorgabe: die des Projekts, sonst 10min; von nctakt live 24h].",
        ),
        accepted_by=f"{_RUNS} live study {_DATA} comment project tape",
    ),
    RunOption(
        name="limit_fails",
        kind=Flag(),
        help=Text(
            "Exit code 1 if that limit ends the run.",
            "Rückgabewert 1, wenn diese Grenze den Lauf beendet.",
        ),
        accepted_by=f"{_RUNS} test",
        default=False,
    ),
    RunOption(
        name="after",
        kind=Moment(),
        help=Text(
            "Continue for this time after the last program.",
            "Nach dem letzten Programm so lange weiterlaufen.",
        ),
        accepted_by=f"{_RUNS} {_DATA} comment tape",
        default=0,
    ),
    RunOption(
        name="skip",
        kind=SkipLevels(),
        help=Text("Skip blocks of these skip levels.", "Sätze dieser Ausblendebenen überspringen."),
        accepted_by=f"{_RUNS} study {_DATA} comment tape fmu",
        default=(),
    ),
    RunOption(
        name="wait_for_start",
        kind=Flag(),
        help=Text(
            "START on the HLI begins each program (HLI.START).",
            "START am HLI beginnt jedes Programm (HLI.START).",
        ),
        accepted_by=f"run {_SESSIONS} {_DATA} comment tape",
        default=False,
        comment="start",
    ),
    RunOption(
        name="blocks",
        kind=Flag(),
        help=Text(
            "Record when each block is decoded and run.",
            "Aufzeichnen, wann jeder Satz dekodiert und ausgeführt wird.",
        ),
        accepted_by="run python tape",
        default=False,
        group="files",
    ),
    RunOption(
        name="stays",
        kind=Flag(),
        help=Text(
            "Go on after the programs, for those that are selected, without a limit.",
            "Nach den Programmen für angewählte weiterlaufen, ohne Grenze.",
        ),
        accepted_by="python session tape",
        default=False,
    ),
    RunOption(
        name="rtconf",
        kind=Words("FILE"),
        help=Text(
            "Scheduling list that allots time to decoder, interpolation and PLC.",
            "Liste der Echtzeitkonfiguration, die Dekoder, Interpolation und SPS Zeit zuteilt.",
        ),
        accepted_by=f"{_RUNS} serve plan tape",
        group="schedule",
    ),
    RunOption(
        name="load",
        kind=Words("FILE.toml"),
        help=Text(
            "Execution times of the functions of --rtconf.",
            "Ausführungszeiten der Funktionen von --rtconf.",
        ),
        accepted_by=f"{_RUNS} serve plan tape",
        group="schedule",
    ),
    RunOption(
        name="os",
        kind=Words(choices=("rtx", "vxworks", "intime", "linux")),
        help=Text(
            "Operating system of --rtconf [default: rtx].",
            "Betriebssystem von --rtconf [Vorgabe: rtx].",
        ),
        accepted_by=f"{_RUNS} serve plan tape",
        group="schedule",
        words="system",
    ),
    RunOption(
        name="confine",
        kind=Folders(),
        help=Text(
            "Read programs and lists only from this folder; may be repeated.",
            "Programme und Listen nur aus diesem Ordner lesen; mehrfach möglich.",
        ),
        accepted_by=f"{_RUNS} {_SESSIONS} check tape fmu",
        group="general",
        words="confined",
    ),
    RunOption(
        name="from_line",
        kind=Whole(),
        help=Text(
            "Begin the first program at the block in this line (block search).",
            "Das erste Programm am Satz in dieser Zeile beginnen (Satzvorlauf).",
        ),
        accepted_by=f"run {_SESSIONS} {_DATA} comment tape",
    ),
    RunOption(
        name="from_block",
        kind=Whole(),
        help=Text("The same, by the block's N number.", "Dasselbe über die N-Nummer des Satzes."),
        accepted_by=f"run {_SESSIONS} {_DATA} comment tape",
    ),
    RunOption(
        name="plc",
        kind=Instances(
            "cycle",
            Text(
                "a Plc (nctakt.plc.load_plc makes one of a file)",
                "eine Plc (nctakt.plc.load_plc macht eine aus einer Datei)",
            ),
        ),
        help=Text(
            "Your own PLC; several run in this order [default: the project's, else built in].",
            "Eine eigene SPS; mehrere laufen in dieser Folge [Vorgabe: die des Projekts, sonst die "
            "eingebaute].",
        ),
        accepted_by=f"{_RUNS} {_SESSIONS} study {_DATA} comment project fmu",
        group="machine",
        metavar="FILE",
    ),
    RunOption(
        name="fmu",
        kind=Instance("next_tick", Text("an Fmu", "eine Fmu")),
        help=Text(
            "A simulation model (FMI 2.0, 3.0) beside the PLC.",
            "Ein Simulationsmodell (FMI 2.0, 3.0) neben der SPS.",
        ),
        accepted_by=f"{_RUNS} python project",
        group="machine",
        metavar="FILE.fmu",
    ),
    RunOption(
        name="acknowledge",
        kind=Flag(),
        help=Text(
            "M and H functions wait until someone acknowledges them.",
            "M- und H-Funktionen warten, bis jemand sie quittiert.",
        ),
        accepted_by=f"{_SESSIONS} launch",
        default=False,
        group="machine",
    ),
    RunOption(
        name="signals",
        kind=Names(),
        help=Text(
            "The signals to record and to draw.", "Die Signale zum Aufzeichnen und Zeichnen."
        ),
        accepted_by="run replay python session test project",
        group="files",
    ),
    RunOption(
        name="sinks",
        kind=Objects(),
        help=Text("What receives the trace.", "Was die Aufzeichnung erhält."),
        accepted_by="python",
        default=(),
    ),
    RunOption(
        name="memory_trace",
        kind=Flag(),
        help=Text("Keep the trace in the result.", "Die Aufzeichnung im Ergebnis behalten."),
        accepted_by="python",
        default=True,
    ),
    RunOption(
        name="record_writes",
        kind=Flag(),
        help=Text(
            "Record each new value that a cycle assigns to a variable as an event.",
            "Jeden neuen Wert, den ein Zyklus einer Variable zuweist, als Ereignis aufzeichnen.",
        ),
        accepted_by="python",
        default=True,
    ),
    RunOption(
        name="why",
        kind=Flag(),
        help=Text(
            "Record the history of each condition of the realtime cycles.",
            "Den Verlauf jeder Bedingung der Echtzeit-Zyklen aufzeichnen.",
        ),
        accepted_by="python test",
        default=False,
    ),
    RunOption(
        name="condition_signals",
        kind=Flag(),
        help=Text(
            "Record the signals, too, that conditions of the realtime cycles read.",
            "Auch die Signale aufzeichnen, die Bedingungen der Echtzeit-Zyklen lesen.",
        ),
        accepted_by="python",
        default=False,
    ),
    RunOption(
        name="on_message",
        kind=Callback(),
        help=Text("Called with each message of a program.", "Erhält jede Meldung eines Programms."),
        accepted_by="python",
    ),
    RunOption(
        name="on_progress",
        kind=Callback(),
        help=Text(
            "Called with the ticks so far and of the whole run.",
            "Erhält die bisherigen Takte und die des ganzen Laufs.",
        ),
        accepted_by="python",
    ),
    RunOption(
        name="on_cycle",
        kind=Callback(),
        help=Text(
            "Called with name and definition of each realtime cycle when it is decoded.",
            "Erhält Namen und Definition jedes Echtzeit-Zyklus, wenn er dekodiert wird.",
        ),
        accepted_by="python",
    ),
    RunOption(
        name="record",
        kind=Callback(),
        help=Text(
            "Called with the inputs from outside, after set.",
            "Erhält die Eingaben von außen, nach set.",
        ),
        accepted_by="python",
    ),
    RunOption(
        name="replay",
        kind=Instance("inputs", Text("a tape", "ein Band")),
        help=Text(
            "Take the inputs of a recorded run instead of at and plc.",
            "Statt at und plc die Eingaben eines aufgezeichneten Laufs nehmen.",
        ),
        accepted_by="python",
    ),
    RunOption(
        name="language",
        kind=Words(choices=("en", "de")),
        help=Text(
            "Language of texts and messages [default: the project's, else the locale's].",
            "Sprache der Texte und Meldungen [Vorgabe: die des Projekts, sonst der Umgebung].",
        ),
        accepted_by=f"{_RUNS} {_SESSIONS} study check replay project launch fmu",
        group="general",
        flag="--lang",
    ),
    RunOption(
        name="quiet",
        kind=Flag(),
        help=Text("Less output; errors are always shown.", "Weniger Ausgabe; Fehler immer."),
        accepted_by=f"{_RUNS} {_SESSIONS} study check replay fmu",
        default=False,
        group="general",
    ),
)

#: The options by name.
BY_NAME: Mapping[str, RunOption] = {option.name: option for option in OPTIONS}

#: The options of ``Controller.run`` besides the programs.
RUN_OPTIONS = tuple(
    option
    for option in OPTIONS
    if "python" in option.front_ends and option.name not in ("programs", "channels")
)

#: The names of those that data can express, and of those among them whose words a command reads.
DATA_NAMES = tuple(ProgramOptions.__annotations__)
READ_NAMES = tuple(name for name in DATA_NAMES if name != "signals")

_DEFAULTS: Mapping[str, Any] = {option.name: option.default for option in RUN_OPTIONS}

_Function = TypeVar("_Function", bound=Callable[..., Any])


def accepted_by(front_end: str) -> tuple[RunOption, ...]:
    """Return the options that a front end accepts."""
    return tuple(option for option in OPTIONS if front_end in option.front_ends)


def completed(given: RunKeywords) -> RunKeywords:
    """Return all options of a run, checked; raises ``Failure`` for wrong values."""
    options = cast("RunKeywords", {**_DEFAULTS, **given})
    for option in RUN_OPTIONS:
        option.kind.check(option.name, cast("Mapping[str, Any]", options)[option.name])
    if options["from_line"] is not None and options["from_block"] is not None:
        raise Failure(diagnostic(BOTH_STARTS_GIVEN))
    return options


def with_further(options: RunKeywords, given: RunKeywords) -> RunKeywords:
    """Return complete options with others, which are checked; raises as ``completed``."""
    for name, value in given.items():
        BY_NAME[name].kind.check(name, value)
    return cast("RunKeywords", {**options, **given})


def merged(options: ProgramOptions, further: RunKeywords) -> RunKeywords:
    """Return the options of both; ``further`` wins if both have one."""
    return cast("RunKeywords", {**options, **further})


def check_keywords(function: str, front_end: str, given: Mapping[str, Any]) -> None:
    """Raise ``UnknownOptionError`` for a keyword that a function of Python does not accept."""
    accepted = [option.name for option in accepted_by(front_end)]
    for name in given:
        if name not in accepted:
            reason = refusal(name, front_end)
            near = nearest(name, accepted)
            hint = f": {reason.get('en')}" if reason else f": did you mean {near}?" if near else ""
            raise UnknownOptionError(
                f"{function}() got an unexpected keyword argument '{name}'{hint}"
            )


def with_keywords(front_end: str, keywords: type) -> Callable[[_Function], _Function]:
    """Let ``help`` and completion see the options in ``**options`` of a function.

    Its signature gets each with type and default, its docstring each with its meaning.
    """
    names = [name for base in (ProgramOptions, RunKeywords) for name in base.__annotations__]
    named = [name for name in dict.fromkeys(names) if name in keywords.__annotations__]

    def decorate(function: _Function) -> _Function:
        signature = inspect.signature(function)
        kept = [one for one in signature.parameters.values() if one.kind is not one.VAR_KEYWORD]
        own = {one.name for one in kept}
        options = [BY_NAME[name] for name in named if name not in own]
        keyword_only = inspect.Parameter.KEYWORD_ONLY
        added = [
            inspect.Parameter(
                option.name,
                keyword_only,
                default=option.default,
                annotation=_annotation(keywords, option.name),
            )
            for option in options
            if front_end in option.front_ends
        ]
        function.__signature__ = signature.replace(parameters=[*kept, *added])  # type: ignore[attr-defined]
        lines = [f"    {parameter.name}: {BY_NAME[parameter.name].help.en}" for parameter in added]
        function.__doc__ = "\n".join([(function.__doc__ or "").rstrip(), "", *lines, ""])
        return function

    return decorate


def _annotation(keywords: type, name: str) -> str:
    """Return the type of an option as written."""
    annotation = keywords.__annotations__[name]
    return str(getattr(annotation, "__forward_arg__", annotation))


def refused(name: str, front_end: str) -> Diagnostic | None:
    """Return the diagnostic of an option that a front end does not accept (902380).

    ``None`` for a name that is not an option. ``name``: as in ``refusal``.
    """
    others = refusal(name, front_end)
    if others is None:
        return None
    return diagnostic(OPTION_OF_OTHERS, option=name, front_end=FRONT_ENDS[front_end], others=others)


def refusal(name: str, front_end: str) -> Text | None:
    """Return the front ends that accept an option refused by this one; ``None`` for an unknown one.

    ``name``: as in Python, on the command line or in a launch configuration.
    """
    for option in OPTIONS:
        spelt = name in (option.name, option.option, option.launch_name)
        if spelt and front_end not in option.front_ends:
            ends = [one for one in option.front_ends if one != "tape"]
            return Text(*(_listed(option, ends, language) for language in ("en", "de")))
    return None


def _listed(option: RunOption, ends: Sequence[str], language: Any) -> str:
    """Return the front ends, each with the spelling of the option there."""
    return ", ".join(f"{FRONT_ENDS[end].get(language)} ({option.name_in(end)})" for end in ends)


def command_words(row: RunOption, words: Any) -> Iterator[str]:
    """Yield the words of the command line for the words of an option."""
    match row.kind:
        case Flag():
            if words:
                yield row.option
        case Stimuli() | ChannelPrograms():
            for pair in words:
                yield from (row.option, *pair)
        case Assignments() | Folders() | Instances():
            for word in words:
                yield from (row.option, word)
        case _:
            if words not in (None, ""):
                yield from (row.option, str(words))
