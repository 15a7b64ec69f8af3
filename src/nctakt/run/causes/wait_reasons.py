# SPDX-License-Identifier: MIT
"""The reasons why a program waits, and what would release it.

In: a channel of the realtime part (``kernel.tick.wait_reasons.WaitReasons.reason``), its living
realtime cycles. Out: at the limit of a run a note or an error with the block, its line, the reason
and the remedy, or nothing if the program is at work.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from nctakt.base.dataclass import dataclass
from nctakt.base.diagnostics import NOTHING, Diagnostic, Span, Text
from nctakt.base.failure import Failure
from nctakt.base.source_ids import statement_span
from nctakt.decoder.cycles.builder import CycleDefinition
from nctakt.hli.function_codes import function_name
from nctakt.hli.layout import spindle_value_name
from nctakt.messages import diagnostic
from nctakt.messages.commands.command_line import WAITING_AT_RUN_LIMIT, WAITS_FOREVER
from nctakt.nc import tree
from nctakt.nc.check.cycles.branches import BranchOutline, branch_outlines
from nctakt.nc.parse.printer import format_expression
from nctakt.nc.vocabulary.variables.resolution import indices_of, path_text, variables_in
from nctakt.results.trace.events import value_text
from nctakt.run.causes.deadlocks import awaited_text
from nctakt.run.realtime.assembly import AssembledMachine

if TYPE_CHECKING:
    from nctakt.run.channel_run import ChannelRun

_START = Text("--at TIME {hli}START=1 continues", "--at ZEIT {hli}START=1 setzt fort")
_PLC = Text(
    "The PLC has to acknowledge it: your own Plc (--plc) with acknowledge = ALL does, so "
    "does the built-in one",
    "Die SPS muss quittieren: das tut eine eigene Plc (--plc) mit acknowledge = ALL und auch die "
    "eingebaute",
)
_SPINDLE_OVERRIDE = Text(
    "Its override is 0 %: --at TIME HLI.{name}.OVERRIDE=100",
    "Ihr Override ist 0 %: --at ZEIT HLI.{name}.OVERRIDE=100",
)


@dataclass(frozen=True, slots=True)
class Reason:
    """The reason why a program waits, and its release (empty: it continues unaided)."""

    awaited: Text
    freed_by: Text


#: The reasons by the words of the realtime part.
_REASONS = {
    "program start": Reason(
        Text("START of the selected program", "START des angewählten Programms"),
        Text("--at TIME {hli}START=1 begins it", "--at ZEIT {hli}START=1 beginnt es"),
    ),
    "programmed stop": Reason(
        Text("START after M00 or M01", "START nach M00 oder M01"),
        _START,
    ),
    "single block": Reason(
        Text("START in single block mode", "START im Einzelsatzbetrieb"),
        Text(
            "--at TIME {hli}START=1 runs a block, --at TIME {hli}SINGLE_BLOCK=0 and a START all",
            "--at ZEIT {hli}START=1 fährt einen Satz, --at ZEIT {hli}SINGLE_BLOCK=0 und ein START "
            "alle",
        ),
    ),
    "reset": Reason(
        Text("RESET: the channel is in error state", "RESET: der Kanal ist im Fehlerzustand"),
        Text("--at TIME {hli}RESET=1 clears the error", "--at ZEIT {hli}RESET=1 löscht den Fehler"),
    ),
    "forward": Reason(
        Text(
            "forward: backward motion is commanded",
            "Vorwärtsfahren: Rückwärtsfahren ist befohlen",
        ),
        Text(
            "--at TIME {hli}BACKWARD_MOTION=0 goes forward",
            "--at ZEIT {hli}BACKWARD_MOTION=0 fährt vorwärts",
        ),
    ),
    "feed hold": Reason(
        Text("the end of the feed hold", "das Ende des Vorschubhalts"),
        Text("--at TIME {hli}FEED_HOLD=0 ends it", "--at ZEIT {hli}FEED_HOLD=0 beendet ihn"),
    ),
    "release": Reason(
        Text(
            "the releases of axis {name}: drive_on, torque_permission, release_feedhold",
            "die Freigaben der Achse {name}: drive_on, torque_permission, release_feedhold",
        ),
        Text(
            "The PLC has to set command_w and enable_w of each in gpAx[]^.lr_mc_control",
            "Die SPS muss bei jeder command_w und enable_w in gpAx[]^.lr_mc_control setzen",
        ),
    ),
    "override": Reason(
        Text(
            "an override above 0: the operator's override is 0 %",
            "einen Override über 0: der Override des Bedieners ist 0 %",
        ),
        Text("--at TIME {hli}OVERRIDE=100 raises it", "--at ZEIT {hli}OVERRIDE=100 hebt ihn an"),
    ),
    "cycle override": Reason(
        Text(
            "an override above 0: a realtime cycle sets V.RTG.OVERRIDE.VEL.CYCLE to 0 %{where}",
            "einen Override über 0: ein Echtzeit-Zyklus setzt V.RTG.OVERRIDE.VEL.CYCLE auf "
            "0 %{where}",
        ),
        Text("", ""),
    ),
    "spindle turns": Reason(
        Text(
            "spindle {name} to turn: feed per revolution (G95)",
            "die Drehung der Spindel {name}: Vorschub je Umdrehung (G95)",
        ),
        Text(
            "Let it turn (M3 or M4 with S), or feed per minute (G94)",
            "Sie drehen lassen (M3 oder M4 mit S) oder Vorschub je Minute (G94)",
        ),
    ),
    "spindle": Reason(
        Text("speed or position of spindle {name}", "Drehzahl oder Position der Spindel {name}"),
        Text("", ""),
    ),
    "spindle acknowledged": Reason(
        Text(
            "the PLC's acknowledgement of the job of spindle {name}",
            "die Quittung der SPS für den Auftrag der Spindel {name}",
        ),
        Text(
            "The PLC has to acknowledge it: your own Plc (--plc) with spindles = ALL does",
            "Die SPS muss quittieren: das tut eine eigene Plc (--plc) mit spindles = ALL",
        ),
    ),
    "free place": Reason(
        Text(
            "a free slot in the HLI for {name}: the PLC has not acknowledged earlier functions",
            "einen freien Platz im HLI für {name}: die SPS hat frühere Funktionen nicht quittiert",
        ),
        _PLC,
    ),
    "acknowledgement": Reason(
        Text("the PLC's acknowledgement of {name}", "die Quittung der SPS für {name}"), _PLC
    ),
    "condition": Reason(
        Text("the condition of #WAIT FOR to be true", "eine wahre Bedingung von #WAIT FOR"),
        Text(
            "Give a variable of the condition another value (--at TIME NAME=VALUE), or let a "
            "realtime cycle or the PLC do so",
            "Einer Variablen der Bedingung einen anderen Wert geben (--at ZEIT NAME=WERT), oder "
            "ein Echtzeit-Zyklus oder die SPS tut es",
        ),
    ),
    "tool manager": Reason(
        Text(
            "the tool manager of the PLC (HLI.TOOL_REQUEST)",
            "die Werkzeugverwaltung der SPS (HLI.TOOL_REQUEST)",
        ),
        Text(
            "The PLC has to answer the request by its number in {hli}TOOL_ANSWER",
            "Die SPS muss die Anfrage mit deren Nummer in {hli}TOOL_ANSWER beantworten",
        ),
    ),
    "signal": Reason(
        Text("{name}", "{name}"),
        Text(
            "A program of the other channel has to send it (#SIGNAL)",
            "Ein Programm des anderen Kanals muss es senden (#SIGNAL)",
        ),
    ),
    "exchange": Reason(
        Text("{name}", "{name}"),
        Text(
            "The channel that has the axis has to give it (#PUT AX; a spindle: PUTAX)",
            "Der Kanal, der die Achse hat, muss sie abgeben (#PUT AX; eine Spindel: PUTAX)",
        ),
    ),
    "axis": Reason(
        Text("axis {name}, which moves independently", "Achse {name}, die sich unabhängig bewegt"),
        Text("", ""),
    ),
}


_AT = Text(" in {line} of cycle {cycle}", " in {line} von Zyklus {cycle}")
_UNDER = Text(", under {branches}", ", unter {branches}")
_AND = Text(" and ", " und ")
_IN = Text("{text} in {line}", "{text} in {line}")
_WHILE_LINES_RUN = Text(
    "It is held as long as {lines} runs{values}",
    "Es wird gehalten, solange {lines} läuft{values}",
)
_LINE = Text("line {line}", "Zeile {line}")
_NOW = Text("; now {values}", "; jetzt {values}")
_FROM_OUTSIDE = Text("; from outside: --at TIME {name}=VALUE", "; von außen: --at ZEIT {name}=WERT")
_WHILE_CYCLE_RUNS = Text(
    "It is held as long as cycle {cycle} runs: nothing in it ends what {line} does",
    "Es wird gehalten, solange Zyklus {cycle} läuft: nichts in ihm beendet, was {line} tut",
)
_AXIS_OVERRIDE = Text(
    "axis {name}, stopped by an override of 0 %{where}",
    "Achse {name}, die bei einem Override von 0 % steht{where}",
)


def wait_reasons(
    machine: AssembledMachine, channels: Sequence[ChannelRun], limit: Text | None
) -> list[Diagnostic]:
    """Return a note for each program that is waiting for something at the limit.

    With ``limit``, the default limit of a run, it is an error unless the program continues unaided.
    """
    reasons = [
        _wait_reason(machine, index, channel, limit)
        for index, channel in enumerate(channels)
        if channel.result is None
    ]
    return [reason for reason in reasons if reason is not None]


def _wait_reason(
    machine: AssembledMachine, index: int, channel: ChannelRun, limit: Text | None
) -> Diagnostic | None:
    """Return a diagnostic with the reason why a channel's program waits, ``None`` without one."""
    word, source, detail = _found(machine, index, channel)
    if not word:
        return None
    span = machine.files.span(source)
    line = "" if span is None else machine.files.line_at(span)
    reason = _reason(machine, index, word, detail, "" if span is None else span.file)
    values: dict[str, object] = {"awaited": reason.awaited, "freed_by": reason.freed_by}
    message = WAITING_AT_RUN_LIMIT
    if not reason.freed_by.en:
        values["freed_by"] = NOTHING
    elif limit is not None:
        message = WAITS_FOREVER
        values["limit"] = limit
    return diagnostic(message, statement_span(span, line), line, **values)


def awaited(machine: AssembledMachine, index: int, channel: ChannelRun) -> Text | None:
    """Return why a channel's program waits, ``None`` if it is working."""
    word, source, detail = _found(machine, index, channel)
    span = machine.files.span(source)
    file = "" if span is None else span.file
    return _reason(machine, index, word, detail, file).awaited if word else None


def _found(machine: AssembledMachine, index: int, channel: ChannelRun) -> tuple[str, int, int]:
    """Return word, source and detail of the reason; between two ticks the decoder knows more.

    A condition of ``#WAIT FOR`` may be read there, or have been false in the tick that has passed.
    """
    word, source, detail = machine.channels[index].waits.reason()
    condition = 0 if channel.feeder is None else channel.feeder.condition
    if not word and condition and not machine.channels[index].path.is_active:
        word, source, detail = "condition", condition, 0
    if word == "condition" and channel.feeder is not None and channel.feeder.awaits_tools:
        word = "tool manager"
    return word, source, detail


def _reason(machine: AssembledMachine, index: int, word: str, detail: int, file: str) -> Reason:
    """Return the reason with its names, for a reader who looks at ``file``."""
    reason = _REASONS[word]
    name = _name(machine, index, word, detail)
    values: dict[str, object] = {"name": name, "hli": f"{_prefix(machine, index)}HLI."}
    variable, held = "", reason.awaited
    if word == "cycle override":
        variable = "V.RTG.OVERRIDE.VEL.CYCLE"
    elif word == "axis" and _override_of_axis(machine, index, name.en) == 0.0:
        variable, held = f"V.RTA.OVERRIDE.VEL.CYCLE.{name.en}", _AXIS_OVERRIDE
    if variable:
        where, freed_by = _held_by_cycle(machine, index, variable, file)
        return Reason(_filled(held, name=name, where=where), freed_by)
    freed_by = reason.freed_by
    if word in ("spindle", "spindle turns"):
        if machine.read(spindle_value_name(name.en)) == 0.0:
            freed_by = _SPINDLE_OVERRIDE
    return Reason(_filled(reason.awaited, **values), _filled(freed_by, **values))


def _override_of_axis(machine: AssembledMachine, index: int, axis: str) -> float:
    """Return the override of an axis in percent, 100 if the channel does not have it now."""
    try:
        return float(machine.read(f"{_prefix(machine, index)}V.RTA.OVERRIDE.VEL.TOTAL.{axis}"))
    except Failure:
        return 100.0


def _prefix(machine: AssembledMachine, index: int) -> str:
    """Return the prefix of a channel's names, empty on a machine with one channel."""
    return machine.assembled[index].prefix if machine.number_in_names(index) else ""


def _name(machine: AssembledMachine, index: int, word: str, detail: int) -> Text:
    """Return the name of the spindle, axis, signal or function that the program waits for."""
    if word in ("signal", "exchange"):
        return awaited_text(machine, index)
    if word.startswith("spindle"):
        name = machine.registry.spindle(detail)
    else:
        name = (
            machine.registry.axis(detail) if word in ("axis", "release") else function_name(detail)
        )
    return Text(name, name)


# --- overrides of realtime cycles ----------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Write:
    """The assignment that a cycle has run last, and the branches around it, the outermost first."""

    definition: CycleDefinition
    cycle: str
    span: Span
    branches: tuple[BranchOutline, ...]


def _held_by_cycle(
    machine: AssembledMachine, index: int, variable: str, file: str
) -> tuple[Text, Text]:
    """Return where a cycle sets an override to 0, and the release; empty if none does."""
    write = _last_write(machine, index, variable)
    if write is None:
        return Text("", ""), Text("", "")
    line = _line_text(write.span, file)
    where = _filled(_AT, line=line, cycle=write.cycle)
    if write.branches:
        lines = [
            _filled(_IN, text=_branch_text(branch), line=_line_text(branch.span, file))
            for branch in write.branches
        ]
        where = _joined(where, _filled(_UNDER, branches=_separated(lines, _AND)))
    freeing = [branch for branch in write.branches if branch.frequency != "ALWAYS"]
    if not freeing:
        return where, _filled(_WHILE_CYCLE_RUNS, cycle=write.cycle, line=line)
    lines = [_line_text(branch.span, file) for branch in freeing]
    values = _values(machine, index, freeing)
    return where, _filled(_WHILE_LINES_RUN, lines=_separated(lines, _AND), values=values)


def _line_text(span: Span, file: str) -> Text:
    """Return a line as a reader of ``file`` finds it: with the name of another file."""
    if span.file == file:
        return _filled(_LINE, line=span.line)
    return Text(f"{span.file}:{span.line}", f"{span.file}:{span.line}")


def cycle_that_writes(
    machine: AssembledMachine, index: int, variable: str
) -> tuple[str, int] | None:
    """Return cycle and line of the last write to a variable in the last tick, if there was any."""
    write = _last_write(machine, index, variable)
    return None if write is None else (write.cycle, write.span.line)


def _last_write(machine: AssembledMachine, index: int, variable: str) -> _Write | None:
    """Return the last write to a variable in the last tick, which counts (RC-305)."""
    found = None
    tick = machine.kernel.tick
    for cycle in machine.channels[index].manager.loaded:
        if cycle.next_tick != tick:
            continue
        definition = machine.registry.definition(cycle.serial)
        ran = {branch.span for branch in definition.reactions if branch.node.next_tick == tick}
        outlines = {one.span: one for one in branch_outlines(definition.statement)}
        for statement, spans in _assignments(definition.statement.body, ()):
            target = statement.target
            if isinstance(target, tree.Variable) and path_text(target).upper() == variable:
                if ran.issuperset(spans):
                    branches = tuple(outlines[span] for span in spans)
                    name = machine.registry.cycle(cycle.serial)
                    found = _Write(definition, name, statement.span, branches)
    return found


def _assignments(
    body: Sequence[tree.Statement], spans: tuple[Span, ...]
) -> Iterator[tuple[tree.Assignment, tuple[Span, ...]]]:
    """Yield the assignments of a cycle with the spans of the branches around them."""
    for statement in body:
        if isinstance(statement, tree.Assignment):
            yield statement, spans
        elif isinstance(statement, tree.If):
            yield from _assignments(statement.body, (*spans, statement.span))
            for elseif in statement.elseifs:
                yield from _assignments(elseif.body, (*spans, elseif.span))
            if statement.else_span is not None:
                yield from _assignments(statement.else_body or (), (*spans, statement.else_span))


def _branch_text(branch: BranchOutline) -> Text:
    condition = "" if branch.condition is None else format_expression(branch.condition)
    text = " ".join(filter(None, (branch.word, branch.frequency, condition)))
    return Text(text, text)


def _values(machine: AssembledMachine, index: int, branches: Sequence[BranchOutline]) -> Text:
    """Return the values that the conditions read, and which of them can come from outside."""
    names = dict.fromkeys(
        path_text(variable)
        for branch in branches
        if branch.condition is not None
        for variable in variables_in(branch.condition)
        if not list(indices_of(variable))
    )
    prefix = _prefix(machine, index)
    shown: dict[str, str] = {}
    for name in names:
        try:
            value = machine.read(f"{prefix}{name}")
        except Failure:
            continue  # a variable of the program alone
        shown[name] = value_text(value) if isinstance(value, str) else f"{value:.10g}"
    if not shown:
        return Text("", "")
    listed = ", ".join(f"{name} = {value}" for name, value in shown.items())
    text = _filled(_NOW, values=listed)
    outside = next((name for name in shown if name.upper().startswith(("V.E.", "V.CH."))), None)
    if outside is None:
        return text
    return _joined(text, _filled(_FROM_OUTSIDE, name=f"{prefix}{outside}"))


# --- texts ---------------------------------------------------------------------------------------


def _filled(text: Text, /, **values: object) -> Text:
    """Return a text with its values, those that are texts in its language."""
    english = {name: one.en if isinstance(one, Text) else one for name, one in values.items()}
    german = {name: one.de if isinstance(one, Text) else one for name, one in values.items()}
    return Text(text.en.format(**english), text.de.format(**german))


def _joined(*texts: Text) -> Text:
    return Text("".join(text.en for text in texts), "".join(text.de for text in texts))


def _separated(texts: Sequence[Text], by: Text) -> Text:
    return Text(by.en.join(text.en for text in texts), by.de.join(text.de for text in texts))
