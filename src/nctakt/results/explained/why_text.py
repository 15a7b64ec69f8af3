# SPDX-License-Identifier: MIT
"""The report of ``nctakt why`` as text: each cycle with its conditions and their history.

In: histories, or states at one tick. Out: lines: the position of a cycle and its life; for each
branch its source line, then the ticks in which its condition was evaluated, the compared values at
each change of truth, and the ticks in which the body ran, or the reason why it did not.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nctakt.base.diagnostics import Text
from nctakt.results.explained.reasons import (
    last_change,
    why_branch_idle,
    why_branch_never,
    why_cycle_idle,
    why_cycle_never,
)
from nctakt.results.explained.why_words import Words
from nctakt.results.histories import (
    BranchHistory,
    ConditionHistory,
    CycleHistory,
    LifeEvent,
    Reason,
)
from nctakt.results.trace.events import value_text

#: Maximum length of a source line, in characters.
_WIDTH = 90

_CYCLE = Text("realtime cycle {name}", "Echtzeit-Zyklus {name}")
_UNREACHED = Text("realtime cycle", "Echtzeit-Zyklus")
_LIVING = Text("already existed before the run", "bestand schon vor dem Lauf")
_STEPS = {
    "created": Text("defined", "definiert"),
    "started": Text("started", "gestartet"),
    "held": Text("put on hold", "angehalten"),
    "continued": Text("continued", "fortgesetzt"),
    "ended": Text("ended", "beendet"),
}
_AND_STARTED = Text("defined and started", "definiert und gestartet")
_STEP_AT = Text("{step} at {tick}", "{step} in {tick}")
_RAN_IN = Text("ran in {times}", "gelaufen: {times}")
_NEVER_RAN = Text("never ran: {reason}", "nie gelaufen: {reason}")
_OUTSIDE = Text(
    "statements outside $IF run in every run-through",
    "Anweisungen außerhalb von $IF laufen in jedem Durchlauf",
)
_FROZEN = Text(
    "{name} is {value}, frozen when the definition was decoded",
    "{name} ist {value}, eingefroren, als die Definition dekodiert wurde",
)
_EVALUATED = Text("evaluated in {times}", "ausgewertet: {times}")
_TRUE_FROM = Text("true from {seen}", "wahr ab {seen}")
_FALSE_FROM = Text("false from {seen}", "falsch ab {seen}")
_PART = Text("part {text}", "Teil {text}")
_BECAME_TRUE_ONCE = Text("became true once, ", "wurde einmal wahr, ")
_BECAME_TRUE = Text("became true {count} times, ", "wurde {count}-mal wahr, ")
_BODY_ONCE = Text("ran once, in {times}", "lief einmal: {times}")
_BODY = Text("ran {count} times, in {times}", "lief {count}-mal: {times}")
_BODY_NEVER = Text("never ran: {reason}", "lief nie: {reason}")
_DONE = Text("ONCE: done, no longer evaluated", "ONCE: erledigt, nicht mehr ausgewertet")
_LATCHED = Text(
    "ALWAYS: latched since {tick}, no longer evaluated",
    "ALWAYS: eingerastet seit {tick}, nicht mehr ausgewertet",
)
_NO_CYCLES = Text("no realtime cycles", "keine Echtzeit-Zyklen")
_LEFT_OUT = Text(
    "{count} older realtime cycles are left out", "{count} ältere Echtzeit-Zyklen fehlen hier"
)
_AT_RAN = Text("ran in this tick", "lief in diesem Takt")
_AT_IDLE = Text("did not run in this tick: {reason}", "lief nicht in diesem Takt: {reason}")
_AT_EVALUATED = Text("evaluated in this tick", "in diesem Takt ausgewertet")
_AT_NOT_EVALUATED = Text("not evaluated in this tick", "in diesem Takt nicht ausgewertet")
_AT_TRUE = Text("true since {seen}", "wahr seit {seen}")
_AT_FALSE = Text("false since {seen}", "falsch seit {seen}")
_AT_BODY = Text("ran", "lief")
_AT_NO_BODY_FALSE = Text("did not run", "lief nicht")
_AT_NO_BODY = Text("did not run: {reason}", "lief nicht: {reason}")
_ANSWER_RAN = Text("{line}: ran in {tick}{truth}", "{line}: lief in {tick}{truth}")
_ANSWER_IDLE = Text(
    "{line}: did not run in {tick}: {reason}", "{line}: lief nicht in {tick}: {reason}"
)
_LAST_OF_CYCLE = Text("{tick}, the last one of its cycle", "{tick}, dem letzten seines Zyklus")
_SO_FAR = Text("so far: {text}", "bisher: {text}")
_CYCLE_ENDED = Text("the cycle has ended at {tick}: {how}", "Zyklus beendet in {tick}: {how}")


def render_report(
    cycles: Sequence[CycleHistory], left_out: int, last_tick: int, words: Words
) -> str:
    """Return the report of the whole run, whose last tick is ``last_tick``."""
    lines: list[str] = []
    for cycle in cycles:
        lines += ["", _headline(cycle, words)]
        lines += [f"  {line}" for line in _life(cycle, last_tick, words)]
        if not cycle.runs.ticks:
            continue
        lines += _branches(cycle, lambda branch, of: _history(of, branch, last_tick, words), words)
    return _joined(lines, left_out, words)


def render_answer(cycles: Sequence[CycleHistory], tick: int, words: Words) -> str:
    """Return in a few lines whether selected branches ran in a tick, why, and how often so far.

    If there are several cycles, the one that ran in the tick answers, otherwise the newest. If it
    has ended, its last tick counts.
    """
    ran = [cycle for cycle in cycles if cycle.runs.holds(tick)]
    begun = [cycle for cycle in cycles if cycle.life and cycle.life[0].tick <= tick]
    lines: list[str] = []
    for cycle in (ran or begun or list(cycles))[-1:]:
        end = cycle.life[-1] if cycle.life and cycle.life[-1].kind == "ended" else None
        series = cycle.runs.series
        has_ended = end is not None and end.tick <= tick and bool(series)
        asked = min(tick, series[-1].last_tick) if has_ended else tick
        lines += [
            line
            for index in cycle.shown
            for line in _answer(cycle, cycle.branches[index], asked, asked < tick, words)
        ]
        if end is not None and asked < tick:
            how = words.ended(end.ended_by, end.span, end.number, cycle.span.file)
            lines.append(words.get(_CYCLE_ENDED, tick=words.tick(end.tick), how=how))
    return "".join(f"{line}\n" for line in lines)


def _answer(
    cycle: CycleHistory, branch: BranchHistory, tick: int, is_last: bool, words: Words
) -> list[str]:
    """Return whether a branch ran in a tick, why, and how often until now."""
    line, when = words.line(branch.span), words.tick(tick)
    if is_last:
        when = words.get(_LAST_OF_CYCLE, tick=when)
    chain = _chain(cycle, branch, lambda other: why_branch_idle(cycle, other, tick))
    if chain:
        reason = words.branch_reason(cycle, branch, chain)
        answer = words.get(_ANSWER_IDLE, line=line, tick=when, reason=reason)
    else:
        truth = "".join(f", {text}" for text in _truth(branch.condition, tick, words))
        answer = words.get(_ANSWER_RAN, line=line, tick=when, truth=truth)
    count = branch.bodies.ticks
    if not count:
        never = why_never(cycle, branch, tick, words)
        return [answer, words.get(_SO_FAR, text=words.get(_BODY_NEVER, reason=never))]
    times = words.times(branch.bodies)
    ran = words.get(_BODY_ONCE if count == 1 else _BODY, count=count, times=times)
    return [answer, words.get(_SO_FAR, text=ran)]


def render_state(cycles: Sequence[CycleHistory], left_out: int, tick: int, words: Words) -> str:
    """Return the report of one tick."""
    lines = [words.tick(tick)]
    for cycle in cycles:
        idle = why_cycle_idle(cycle, tick)
        lines += ["", _headline(cycle, words)]
        if idle is not None:
            lines.append(
                f"  {words.get(_AT_IDLE, reason=words.cycle_reason(idle, cycle.span.file))}"
            )
            continue
        lines.append(f"  {words.get(_AT_RAN)}")
        lines += _branches(cycle, lambda branch, of: _state(of, branch, tick, words), words)
    return _joined(lines, left_out, words)


def _joined(lines: list[str], left_out: int, words: Words) -> str:
    if not lines:
        lines = [words.get(_NO_CYCLES)]
    if left_out:
        lines += ["", words.get(_LEFT_OUT, count=left_out)]
    return "\n".join(lines).lstrip("\n") + "\n"


# --- a cycle -------------------------------------------------------------------------------------


def _headline(cycle: CycleHistory, words: Words) -> str:
    name = words.get(_CYCLE, name=cycle.name) if cycle.name else words.get(_UNREACHED)
    return f"{name}  {cycle.span.file}:{cycle.span.line}  {cycle.scope}".rstrip()


def _life(cycle: CycleHistory, last_tick: int, words: Words) -> list[str]:
    """Return the steps of a cycle's life, and the ticks in which it ran."""
    never = why_cycle_never(cycle, last_tick)
    steps = [_step(cycle, index, words) for index in range(len(cycle.life))]
    lines = words.ends([step for step in steps if step], cycle.life_left_out)
    if never is None:
        last = cycle.life[-1].kind == "ended"
        ran = words.get(_RAN_IN, times=words.times(cycle.runs))
        lines.insert(len(lines) - 1 if last else len(lines), ran)
    else:
        lines.append(words.get(_NEVER_RAN, reason=words.cycle_reason(never, cycle.span.file)))
    if not cycle.shown and cycle.branches:
        lines.append(words.get(_OUTSIDE))
    return lines


def _step(cycle: CycleHistory, index: int, words: Words) -> str:
    """Return the text of a step; a definition that starts the cycle is one step."""
    event = cycle.life[index]
    if event.kind == "living":
        return words.get(_LIVING)
    if event.kind == "started" and index and _starts_at_once(cycle.life[index - 1], event):
        return ""
    following = cycle.life[index + 1] if index + 1 < len(cycle.life) else None
    step = words.get(_STEPS[event.kind])
    if following is not None and _starts_at_once(event, following):
        step = words.get(_AND_STARTED)
    text = words.get(_STEP_AT, step=step, tick=words.tick(event.tick))
    if event.kind == "ended":
        how = words.ended(event.ended_by, event.span, event.number, cycle.span.file)
        return f"{text}: {how}"
    if event.kind in ("started", "held", "continued") and event.span is not None:
        return f"{text}, {words.line(event.span, cycle.span.file)}"
    return text


def _starts_at_once(event: LifeEvent, following: LifeEvent) -> bool:
    return (event.kind, following.kind) == ("created", "started") and (
        (event.tick, event.span) == (following.tick, following.span)
    )


# --- its branches --------------------------------------------------------------------------------


def _branches(
    cycle: CycleHistory,
    lines_of: Callable[[BranchHistory, CycleHistory], list[str]],
    words: Words,
) -> list[str]:
    lines: list[str] = []
    depths = [_depth(cycle, cycle.branches[index]) for index in cycle.shown]
    for index, depth in zip(cycle.shown, depths, strict=True):
        branch = cycle.branches[index]
        indent = "  " * (1 + depth - min(depths))
        lines += ["", f"{indent}{words.line(branch.span)}  {_cut(branch.text)}"]
        lines += [f"{indent}  {line}" for line in lines_of(branch, cycle)]
    return lines


def _depth(cycle: CycleHistory, branch: BranchHistory) -> int:
    depth = 0
    while branch.outer is not None:
        branch = cycle.branches[branch.outer]
        depth += 1
    return depth


def _history(cycle: CycleHistory, branch: BranchHistory, last_tick: int, words: Words) -> list[str]:
    """Return the history of a branch in the run."""
    lines = _frozen(branch, words)
    if branch.evaluated.ticks:
        lines.append(words.get(_EVALUATED, times=words.times(branch.evaluated)))
        for part in branch.parts:
            lines.append(words.get(_PART, text=part.text))
            lines += [f"  {line}" for line in _truths(part, words)]
    if branch.bodies.ticks:
        lines += _changes(branch.condition, words)
        count = branch.bodies.ticks
        times = words.times(branch.bodies)
        ran = words.get(_BODY_ONCE if count == 1 else _BODY, count=count, times=times)
        lines.append(_became_true(branch, words) + ran + _commands(branch))
        return [*lines, *_frequency(branch, words)]
    chain = _never_chain(cycle, branch, last_tick)
    if chain[0].kind != "false":
        lines += _changes(branch.condition, words)
    reason = words.branch_reason(cycle, branch, chain)
    return [*lines, words.get(_BODY_NEVER, reason=reason)]


def why_never(cycle: CycleHistory, branch: BranchHistory, last_tick: int, words: Words) -> str:
    """Return why the body of a branch never ran, with the parts of its condition; or nothing."""
    chain = _never_chain(cycle, branch, last_tick)
    if not chain:
        return ""
    reasons = [words.branch_reason(cycle, branch, chain)]
    for part in branch.parts:
        if part.nearest is not None:
            reasons.append(f"{part.text}: {words.nearest(part, part.nearest)}")
    return "; ".join(reasons)


def _never_chain(cycle: CycleHistory, branch: BranchHistory, last_tick: int) -> list[Reason]:
    return _chain(cycle, branch, lambda other: why_branch_never(cycle, other, last_tick))


def _became_true(branch: BranchHistory, words: Words) -> str:
    """Return how often a branch became true; nothing where it was so from before the run on."""
    if not branch.became_true:
        return ""
    once = branch.became_true == 1
    return words.get(_BECAME_TRUE_ONCE if once else _BECAME_TRUE, count=branch.became_true)


def _commands(branch: BranchHistory) -> str:
    """Return the statements of the body, cut at the length of a line."""
    text = _cut("; ".join(branch.commands))
    return f": {text}" if text else ""


def _cut(text: str) -> str:
    return text if len(text) <= _WIDTH else f"{text[: _WIDTH - 1]}…"


def _frozen(branch: BranchHistory, words: Words) -> list[str]:
    """Return the values in the condition that are the same in each tick (RC-302)."""
    values = {value.name: value_text(value.value) for value in branch.frozen}
    return [words.get(_FROZEN, name=name, value=value) for name, value in values.items()]


def _truths(part: ConditionHistory, words: Words) -> list[str]:
    """Return the changes of a part, or how near to true it came."""
    if part.nearest is not None:
        return [words.nearest(part, part.nearest)]
    return _changes(part, words)


def _changes(condition: ConditionHistory, words: Words) -> list[str]:
    texts = [
        words.get(_TRUE_FROM if change.truth else _FALSE_FROM, seen=words.seen(condition, change))
        for change in condition.changes
    ]
    return words.ends(texts, condition.changes_left_out)


def _frequency(branch: BranchHistory, words: Words) -> list[str]:
    """Return from when on a condition is no longer evaluated, since its body has run."""
    if branch.frequency == "ONCE":
        return [words.get(_DONE)]
    true = [change.tick for change in branch.condition.changes if change.truth]
    if branch.frequency == "ALWAYS" and true:
        return [words.get(_LATCHED, tick=words.tick(true[-1]))]
    return []


def _chain(
    cycle: CycleHistory,
    branch: BranchHistory,
    why: Callable[[BranchHistory], Reason | None],
) -> list[Reason]:
    """Return the reason, then that of the responsible branch, and so on outwards."""
    reasons: list[Reason] = []
    reason = why(branch)
    while reason is not None:
        reasons.append(reason)
        if reason.kind != "outer" or reason.branch is None:
            break
        reason = why(cycle.branches[reason.branch])
    return reasons


def _state(cycle: CycleHistory, branch: BranchHistory, tick: int, words: Words) -> list[str]:
    """Return the state of a branch in one tick."""
    lines = _frozen(branch, words)
    if branch.word != "$ELSE":
        evaluated = branch.evaluated.holds(tick)
        lines.append(words.get(_AT_EVALUATED if evaluated else _AT_NOT_EVALUATED))
    lines += _truth(branch.condition, tick, words)
    for part in branch.parts:
        lines.append(words.get(_PART, text=part.text))
        lines += [f"  {line}" for line in _truth(part, tick, words)]
    chain = _chain(cycle, branch, lambda other: why_branch_idle(cycle, other, tick))
    if not chain:
        return [*lines, words.get(_AT_BODY) + _commands(branch)]
    if chain[0].kind == "false" and chain[0].change is not None:
        return [*lines, words.get(_AT_NO_BODY_FALSE)]
    reason = words.branch_reason(cycle, branch, chain)
    return [*lines, words.get(_AT_NO_BODY, reason=reason)]


def _truth(condition: ConditionHistory, tick: int, words: Words) -> list[str]:
    """Return since when a condition is true or false; empty if that is unknown."""
    change = last_change(condition, tick)
    if change is None:
        return []
    return [words.get(_AT_TRUE if change.truth else _AT_FALSE, seen=words.seen(condition, change))]
