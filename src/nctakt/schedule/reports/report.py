# SPDX-License-Identifier: MIT
"""Simulation and analysis as tables of text.

In: ``Simulation``, ``Analysis``, ``Margins``, rows of the effective list. Out: text in the user's
language, times in µs. Every report names the rules that were chosen.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nctakt.base.diagnostics import Language, Text
from nctakt.schedule.analysis.analyse import Analysis, TaskAnalysis
from nctakt.schedule.analysis.findings import culprits, us
from nctakt.schedule.analysis.margins import Margins
from nctakt.schedule.effective_table import EffectiveRow
from nctakt.schedule.model import ANY_CPU, Model, TaskClass
from nctakt.schedule.simulation.interpolation_steps import dead_times
from nctakt.schedule.simulation.responses import PERCENTILES_PER_MILLE
from nctakt.schedule.simulation.results import Simulation, TaskNumbers

NONE = "–"
CLASSES = {
    TaskClass.REALTIME: Text("realtime", "Echtzeit"),
    TaskClass.ASYNCHRONOUS: Text("asynchronous", "asynchron"),
    TaskClass.EXTERNAL: Text("external", "extern"),
}
_SOURCES = {
    "hardware interrupt": Text("hardware interrupt", "Hardware-Interrupt"),
    "timer": Text("timer", "Timer"),
    "semaphore": Text("semaphore", "Semaphor"),
    "external scheduling": Text("external scheduling", "externes Scheduling"),
}

#: The bars of a histogram, and the characters of the longest one.
_MAX_BARS, _BAR_LENGTH = 20, 40
_OVERFLOWS = Text("overflows", "Überläufe")


def table(heads: Sequence[str], rows: Sequence[Sequence[str]], left: int = 1) -> list[str]:
    """Return columns below their heads; the first ``left`` are aligned left, the others right."""
    widths = [max(len(row[i]) for row in (heads, *rows)) for i in range(len(heads))]
    lines = []
    for row in (heads, ["─" * width for width in widths], *rows):
        cells = [
            cell.ljust(width) if i < left else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip())
    return lines


def effective_report(rows: Sequence[EffectiveRow], language: Language) -> str:
    """Return the table of the list as written and as effective."""
    heads = Text(
        "Line|Parameter|Name|Raw|Effective|Unit|Reason",
        "Zeile|Parameter|Name|Roh|Wirksam|Einheit|Grund",
    )
    cells = [
        [
            str(row.line) if row.line else NONE,
            row.id,
            row.key,
            row.raw or NONE,
            row.effective,
            row.unit,
            row.reason,
        ]
        for row in rows
    ]
    names = heads.get(language).split("|")
    return "\n".join(table(names, cells, left=len(names)))


def chosen_report(model: Model, language: Language) -> list[str]:
    """Return the times of the list and the chosen rules."""
    rules = model.rules
    source = _SOURCES[model.source.value].get(language)
    text = Text(
        "NC interrupt: {source}; cycle_time {cycle}, time_slice {slice}, windows_time {windows} µs",
        "NC-Interrupt: {source}; cycle_time {cycle}, time_slice {slice}, windows_time {windows} µs",
    )
    chosen = Text(
        "Rules: overflow '{overflow}', calls '{calls}', suspension by '{suspension}', seed {seed}",
        "Regeln: Überlauf '{overflow}', Aufrufe '{calls}', Suspendierung nach '{suspension}', "
        "Startwert {seed}",
    )
    return [
        text.get(language).format(
            source=source,
            cycle=us(model.cycle),
            slice=us(model.slice),
            windows=us(model.windows),
        ),
        chosen.get(language).format(
            overflow=rules.overflow,
            calls=rules.calls,
            suspension=rules.suspension,
            seed=model.seed,
        ),
    ]


def dead_time_report(model: Model, language: Language) -> list[str]:
    """Return the time from input to output of the interpolation, if the load names it."""
    text = Text(
        "schedule {schedule}: {thread} outputs {time} µs after it starts reading",
        "schedule {schedule}: {thread} gibt {time} µs nach Beginn des Einlesens aus",
    )
    return [
        text.get(language).format(schedule=model.schedule, thread=name, time=us(time))
        for name, time in dead_times(model)
    ]


def simulation_report(
    run: Simulation, worst_phases: Mapping[int, Simulation], language: Language
) -> str:
    """Return all numbers of a simulation; ``worst_phases``: with other phases, by phase in ns."""
    model = run.model
    lines = chosen_report(model, language)
    simulated = Text(
        "Simulated: {cycles} NC cycles, {duration} µs, {jobs} jobs",
        "Simuliert: {cycles} NC-Takte, {duration} µs, {jobs} Aufträge",
    )
    repeats = Text("; repeats exactly after {n} cycles", "; wiederholt sich genau nach {n} Takten")
    line = simulated.get(language).format(
        cycles=run.cycles, duration=us(run.duration), jobs=run.jobs
    )
    if run.repeats_after is not None:
        line += repeats.get(language).format(n=run.repeats_after)
    lines += [line, *dead_time_report(model, language), ""]
    lines += numbers_report(run, language)
    if not model.train.is_phase_known:
        lines += ["", *_phase_report(run, worst_phases, language)]
    return "\n".join(lines) + "\n"


def _phase_report(
    run: Simulation, worst_phases: Mapping[int, Simulation], language: Language
) -> list[str]:
    """Return the numbers of threads and of Windows with the phases that are the worst for them."""
    assumed = Text(
        "The load names no phase of the NC interrupt: {phase} µs is assumed.",
        "Die Last nennt keine Phase des NC-Interrupts: angenommen ist {phase} µs.",
    )
    lines = [assumed.get(language).format(phase=us(run.model.train.phase))]
    if not worst_phases:
        same = Text(
            "In the long run it makes no difference.", "Auf Dauer macht sie keinen Unterschied."
        )
        return [f"{lines[0]} {same.get(language)}"]
    others = [other for phase, other in worst_phases.items() if phase != run.model.train.phase]
    if not others:
        worst = Text("It is the worst one.", "Sie ist die schlechteste.").get(language)
        return [f"{lines[0]} {worst}"]
    runs = [run, *others]
    heads = Text("Phase", "Phase").get(language)
    columns = [us(simulation.model.train.phase) for simulation in runs]
    rows = []
    for i, task in enumerate(run.model.tasks):
        for name, value in (("R max", _longest), (_OVERFLOWS.get(language), _overflows)):
            rows.append([task.name, name, *(value(simulation.tasks[i]) for simulation in runs)])
    minimum = [us(simulation.windows[-1].minimum) for simulation in runs]
    rows.append(["Windows", Text("least", "kleinste").get(language), *minimum])
    return [*lines, *table([heads, "µs", *columns], rows, left=2)]


def _longest(numbers: TaskNumbers) -> str:
    return NONE if numbers.response_max is None else us(numbers.response_max)


def _overflows(numbers: TaskNumbers) -> str:
    return str(numbers.overflows)


def response_report(run: Simulation, language: Language) -> list[str]:
    """Return the percentiles of all responses, and a histogram for each thread."""
    heads = [
        Text("Response, µs", "Antwortzeit, µs").get(language),
        *(f"{_permille(share)} %" for share in PERCENTILES_PER_MILLE),
        "100 %",
    ]
    tasks = list(zip(run.model.tasks, run.tasks, strict=True))
    rows = []
    for task, numbers in tasks:
        longest = numbers.response_max
        shares = [numbers.responses.percentile(share) for share in PERCENTILES_PER_MILLE]
        # A share that covers several responses may end after the longest of them.
        times = [
            share if share is None or longest is None else min(share, longest) for share in shares
        ]
        rows.append(
            [task.name, *(NONE if share is None else us(share) for share in (*times, longest))]
        )
    lines = ["", *table(heads, rows)]
    for task, numbers in tasks:
        bars = numbers.responses.bars(_MAX_BARS)
        if bars:
            lines += ["", task.name, *_histogram(bars)]
    return lines


def _permille(value: int) -> str:
    return f"{value / 10:g}"


def _histogram(bars: list[tuple[int, int, int]]) -> list[str]:
    maximum = max(count for _, _, count in bars)
    names = [f"{us(low)} …" for low, _, _ in bars]
    width = max(len(name) for name in names)
    digits = len(str(maximum))
    return [
        f"  {name:>{width}}  {count:>{digits}}  {'█' * -(-_BAR_LENGTH * count // maximum)}".rstrip()
        for name, (_, _, count) in zip(names, bars, strict=True)
    ]


def numbers_report(run: Simulation, language: Language) -> list[str]:
    """Return the numbers of the threads and of Windows."""
    heads = Text(
        "Thread|Class|CPU|Period|Due|Done|Load %|R min|R mean|R max|Slack|Overflows|Lost|Suspended",
        "Thread|Klasse|CPU|Periode|Fällig|Fertig|Last %|R min|R mittel|R max|Reserve|Überläufe|"
        "Verloren|Suspendiert",
    )
    rows = [_task_row(run, i, language) for i in range(len(run.model.tasks))]
    tasks = table(heads.get(language).split("|"), rows, left=2)
    return [*tasks, "", *_windows_table(run, language)]


def _task_row(run: Simulation, i: int, language: Language) -> list[str]:
    task, numbers = run.model.tasks[i], run.tasks[i]
    period = task.every * run.model.train.distance
    return [
        task.name,
        CLASSES[task.kind].get(language),
        "any" if task.cpu == ANY_CPU else str(task.cpu),
        us(period),
        str(numbers.due),
        str(numbers.completed),
        f"{100 * numbers.busy / run.duration:.2f}",
        *responses(numbers),
        NONE if numbers.response_max is None else us(period - numbers.response_max),
        str(numbers.overflows),
        str(numbers.lost),
        str(numbers.suspensions),
    ]


def rounded_mean(total: int, count: int) -> int:
    """Return the mean in ns, rounded half up."""
    return (2 * total + count) // (2 * count)


def responses(numbers: TaskNumbers) -> list[str]:
    """Return shortest, mean and longest response as texts in µs."""
    if numbers.response_min is None or numbers.response_max is None:
        return [NONE] * 3
    mean = rounded_mean(numbers.response_sum, numbers.completed)
    return [us(numbers.response_min), us(mean), us(numbers.response_max)]


def _windows_table(run: Simulation, language: Language) -> list[str]:
    heads = Text(
        "Windows|Share %|Min|Mean|Max|Cycles below windows_time|Who",
        "Windows|Anteil %|Min|Mittel|Max|Takte unter windows_time|Wer",
    )
    windows = run.windows if len(run.windows) > 2 else run.windows[:-1]
    rows = [
        [
            f"CPU {numbers.cpu}" if numbers.cpu else Text("sum", "Summe").get(language),
            f"{100 * numbers.total / run.duration:.2f}",
            us(numbers.minimum),
            us(rounded_mean(numbers.total, run.cycles)),
            us(numbers.maximum),
            str(numbers.violated) if run.model.windows else NONE,
            culprits(run.model, numbers) or NONE,
        ]
        for numbers in windows
    ]
    return table(heads.get(language).split("|"), rows)


def analysis_report(
    analysis: Analysis, margins: Margins, run: Simulation, language: Language
) -> str:
    """Return response times next to those of a simulation, demand and supply, and the findings."""
    lines = chosen_report(analysis.model, language)
    heads = Text(
        "Thread|C|T|C/T %|R analysed|R simulated|Slack|Overflow",
        "Thread|C|T|C/T %|R berechnet|R simuliert|Reserve|Überlauf",
    )
    rows = []
    for task, bound, numbers in zip(analysis.model.tasks, analysis.tasks, run.tasks, strict=True):
        verdict = Text("possible", "möglich") if bound.can_overflow else Text("no", "nein")
        rows.append(
            [
                task.name,
                us(bound.demand),
                us(bound.period),
                f"{100 * bound.demand / bound.period:.2f}",
                bound_text(bound),
                NONE if numbers.response_max is None else us(numbers.response_max),
                NONE if bound.slack is None else us(bound.slack),
                verdict.get(language),
            ]
        )
    lines += ["", *table(heads.get(language).split("|"), rows), ""]
    lines += [_meaning_of_bounds(analysis).get(language), *_phases(analysis, language), ""]
    return "\n".join([*lines, *_cpus(analysis, language), "", *_margins(margins, language)]) + "\n"


def bound_text(task: TaskAnalysis) -> str:
    """Return a response, marked where it is not exact."""
    if task.response is None:
        return "∞"
    return us(task.response) if task.is_exact else f"≤ {us(task.response)}"


def _meaning_of_bounds(analysis: Analysis) -> Text:
    if analysis.is_exact:
        return Text(
            "The responses are exact: those of the simulation.",
            "Die Antwortzeiten sind genau: die der Simulation.",
        )
    return Text(
        "≤ is an upper bound: no simulation shows more, and many show less. ∞: no bound was "
        "found.\nWithout a sign a response is exact: that of the simulation.",
        "≤ ist eine obere Schranke: keine Simulation zeigt mehr, viele zeigen weniger. ∞: keine\n"
        "Schranke gefunden. Ohne Zeichen ist eine Antwortzeit genau: die der Simulation.",
    )


def _phases(analysis: Analysis, language: Language) -> list[str]:
    """The phase of the NC interrupt for which the bounds hold, if the load names none."""
    if analysis.model.train.is_phase_known:
        return []
    if not analysis.phases:
        text = Text(
            "The load names no phase of the NC interrupt: the bounds hold for all phases.",
            "Die Last nennt keine Phase des NC-Interrupts: die Schranken gelten für alle Phasen.",
        )
        return [text.get(language)]
    threads: dict[int, list[str]] = {}
    for i, phase in analysis.phases.items():
        threads.setdefault(phase, []).append(analysis.model.tasks[i].name)
    text = Text(
        "The load names no phase of the NC interrupt: the worst one is taken, {phases}.",
        "Die Last nennt keine Phase des NC-Interrupts: es gilt die ungünstigste, {phases}.",
    )
    phases = ", ".join(
        f"{us(phase)} µs ({', '.join(names)})" for phase, names in sorted(threads.items())
    )
    return [text.get(language).format(phases=phases)]


def _cpus(analysis: Analysis, language: Language) -> list[str]:
    heads = Text(
        "CPU|Demand %|Supply beside windows_time %", "CPU|Bedarf %|Angebot neben windows_time %"
    )
    rows = [
        [str(cpu.cpu), f"{100 * cpu.demand:.2f}", f"{100 * cpu.suspendable_supply:.2f}"]
        for cpu in analysis.cpus
    ]
    return table(heads.get(language).split("|"), rows)


def _margins(margins: Margins, language: Language) -> list[str]:
    heads = Text(
        "Nothing on its CPU overflows up to (each alone)|Present|Limit|Change",
        "Nichts auf ihrer CPU läuft über bis (jedes für sich)|Jetzt|Grenze|Änderung",
    )
    rows = [
        [
            margin.function,
            us(margin.present),
            NONE if margin.limit is None else us(margin.limit),
            NONE if margin.change is None else _signed(margin.change),
        ]
        for margin in margins.functions
    ]
    lines = table(heads.get(language).split("|"), rows)
    factor = Text(
        "CPU {cpu}: nothing overflows with all execution times × {factor}",
        "CPU {cpu}: mit allen Ausführungszeiten × {factor} läuft nichts über",
    )
    hopeless = Text(
        "CPU {cpu}: something overflows with any execution times",
        "CPU {cpu}: mit allen Ausführungszeiten läuft etwas über",
    )
    for cpu in margins.factors:
        text = hopeless if cpu.factor is None else factor
        lines.append(text.get(language).format(cpu=cpu.cpu, factor=cpu.factor))
    never = Text("none: something overflows with each", "keine: bei jeder läuft etwas über")
    for text, value in (
        (Text("largest windows_time", "größte windows_time"), margins.windows_time),
        (Text("smallest cycle_time", "kleinste cycle_time"), margins.cycle_time),
    ):
        shown = never.get(language) if value is None else f"{us(value)} µs"
        lines.append(f"{text.get(language)}: {shown}")
    return lines


def _signed(time: int) -> str:
    return f"+{us(time)}" if time > 0 else f"−{us(-time)}" if time < 0 else "0"
