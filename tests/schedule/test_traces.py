# SPDX-License-Identifier: MIT
"""Pictures and traces of S1: what they hold."""

from __future__ import annotations

import csv
import itertools
import json
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.random_models import random_model
from support.schedule_examples import EXAMPLE_1, TIGHT, change, load_text, make, with_line

from nctakt.schedule.model import Model
from nctakt.schedule.pictures.figure import Box, Label, Stroke, label_left, text_width
from nctakt.schedule.pictures.gantt import PictureTitle, gantt
from nctakt.schedule.pictures.gantt_layout import rows_of, strips_of
from nctakt.schedule.pictures.traces import write_csv, write_perfetto, write_vcd
from nctakt.schedule.simulation.results import EventKind, Simulation
from nctakt.schedule.simulation.simulate import simulate
from nctakt.schedule.simulation.timeline import tick_times, windows_times
from nctakt.schedule.simulation.tracebits import calls_of, trace_bits

US = 1000


def s1() -> Simulation:
    """Three cycles of S1."""
    return simulate(make(EXAMPLE_1, load_text(TIGHT))[0], 3, record=3)


def changes(path: Path) -> dict[str, list[tuple[int, object]]]:
    """The changes of each variable of a VCD file, times in µs."""
    reader = pytest.importorskip("vcd.reader")
    names: dict[str, str] = {}
    found: dict[str, list[tuple[int, object]]] = {}
    now = 0
    with path.open("rb") as file:
        for token in reader.tokenize(file):
            kind = token.kind.name
            if kind == "VAR":
                names[token.data.id_code] = token.data.reference
                found.setdefault(token.data.reference, [])
            elif kind == "CHANGE_TIME":
                now = token.data
            elif kind in ("CHANGE_SCALAR", "CHANGE_STRING"):
                name = names[token.data.id_code]
                found[name].append((now // US, token.data.value))
    return found


def test_vcd_of_s1(tmp_path: Path) -> None:
    """The trace bits of S1, the processor's task, interrupts and suspensions."""
    pytest.importorskip("vcd")
    write_vcd(s1(), tmp_path / "a.vcd")
    found = changes(tmp_path / "a.vcd")
    high = [(time, value) for time, value in found["bit4_task_com"] if value in ("0", "1")]
    assert high == [(0, "0"), (3400, "1"), (5450, "0")]
    ran = found["cpu1"]
    assert (1500, "Windows") in ran
    assert (400, "external_sps") in ran
    assert [time for time, value in found["NC"] if value == "1"] == [0, 2000, 4000]
    assert "date" not in (tmp_path / "a.vcd").read_text("utf-8").split("$end")[0]


def test_calls_that_touch_are_shown_apart(tmp_path: Path) -> None:
    """Four calls back to back are four pulses."""
    pytest.importorskip("vcd")
    text = with_line(EXAMPLE_1, "thread[1].function[0].calls_per_cycle 4")
    model, _ = make(text, load_text(TIGHT | {"task_rnd": 100}))
    run = simulate(model, 1, record=1)
    assert len(trace_bits(model, run.record)[2]) == 4
    write_vcd(run, tmp_path / "a.vcd")
    high = [time for time, value in changes(tmp_path / "a.vcd")["bit2_task_rnd"] if value == "1"]
    assert high == [600, 701, 801, 901]


def test_two_functions_on_one_bit() -> None:
    """A bit is high while either of its functions runs."""
    text = with_line(EXAMPLE_1, "thread[3].function[0].trace_bit 2")
    model, _ = make(text, load_text(TIGHT))
    high = trace_bits(model, simulate(model, 3, record=3).record)[2]
    assert [(a // US, b // US) for a, b in high] == [(600, 1300), (2600, 3300), (3400, 5450)]


def test_calls_of_jobs_with_overheads() -> None:
    """Overheads come before the calls, empty calls end where they begin."""
    text = with_line(
        EXAMPLE_1,
        "thread[1].function[0].calls_per_cycle 2",
        "thread[1].function[1].name task_com",
    )
    load = load_text(
        TIGHT | {"task_rnd": 0, "task_com": 50}, extra="[overheads]\nswitch = 2\nactivation = 3\n"
    )
    model, _ = make(text, load)
    calls = [one for one in calls_of(model, simulate(model, 1, record=1).record) if one.task == 1]
    begin = 405 + 205 + 5
    assert [(one.begin // US, (one.end or 0) // US) for one in calls] == [
        (begin, begin),
        (begin, begin),
        (begin, begin + 50),
    ]


def test_call_that_does_not_end() -> None:
    """A call that still runs at the end of the record has no end."""
    model, _ = make(EXAMPLE_1, load_text(TIGHT | {"task_int": 2100}))
    first = calls_of(model, simulate(model, 1, record=1).record)[0]
    assert (first.begin, first.end) == (0, None)


def test_csv_of_s1(tmp_path: Path) -> None:
    """All events with their times in µs."""
    write_csv(s1(), tmp_path / "a.csv")
    with (tmp_path / "a.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    found = [(row["time_us"], row["event"], row["thread"], row["value"]) for row in rows]
    assert ("1500", "SUSPEND", "MMI_DRIVER", "100") in found
    assert ("2000", "RESUME", "COM", "250") in found
    assert ("4000", "OVERFLOW", "COM", "150") in found
    assert ("5450", "END", "COM", "5450") in found
    assert ("3400", "RUN", "COM", "100") in found
    assert found[0] == ("0", "NC", "", "0")
    shares = [(row["time_us"], row["value"]) for row in rows if row["event"] == "WINDOWS"]
    assert shares == [("0", "500"), ("2000", "500"), ("4000", "550")]
    assert sum(row["event"] == "TICK" for row in rows) == 13
    assert [float(row["time_us"]) for row in rows] == sorted(float(row["time_us"]) for row in rows)


def test_perfetto_of_s1(tmp_path: Path) -> None:
    """Slices, instants and counters; slices of one track never overlap."""
    write_perfetto(s1(), tmp_path / "a.json")
    events = json.loads((tmp_path / "a.json").read_text("utf-8"))["traceEvents"]
    slices = [one for one in events if one["ph"] == "X"]
    tracks: dict[tuple[int, int], list[tuple[float, float]]] = {}
    for one in slices:
        track = tracks.setdefault((one["pid"], one["tid"]), [])
        track.append((one["ts"], one["ts"] + one["dur"]))
    for spans in tracks.values():
        spans.sort()
        assert all(a[1] <= b[0] for a, b in itertools.pairwise(spans))
    assert {one["name"] for one in events if one["ph"] == "i"} >= {"NC", "OVERFLOW", "SUSPEND"}
    assert any(one["name"] == "trace bit 4" for one in events if one["ph"] == "C")


def shapes_of(model: Model, cycles: int = 6) -> list[Box | Stroke | Label]:
    """The shapes of a picture."""
    title = PictureTitle("rtconf.lis", "load.toml")
    return list(gantt(simulate(model, cycles, record=cycles), title, "en").shapes)


def test_picture_of_s1() -> None:
    """F9: bars, suspensions, the overflow, Windows, dimensions, arrows and trace bits."""
    shapes = shapes_of(make(EXAMPLE_1, load_text(TIGHT))[0])
    boxes = [one for one in shapes if isinstance(one, Box) and one.tip]
    assert sum(one.hatched for one in boxes) == 5
    assert sum(one.tip.startswith("Windows") for one in boxes) == 6
    strokes = [one for one in shapes if isinstance(one, Stroke)]
    assert sum(one.arrows == "end" for one in strokes) == 6 + 1  # one in the legend
    assert sum(one.arrows == "both" for one in strokes) == 3
    assert sum(one.tip == "COM: 4000 µs, 150 µs" for one in strokes) == 2
    texts = [one.text for one in shapes if isinstance(one, Label)]
    assert "cycle_time 2000" in texts
    assert "windows_time 500" in texts
    assert "task_com  4" in texts
    assert "12000" in texts
    assert "rtconf.lis · load.toml" in texts
    assert "NC cycles 0 … 5" in texts
    assert any("overflow 'skip'" in text for text in texts)
    assert any("windows_time 500 µs" in text for text in texts)
    assert {"overflow", "suspended", "timer interrupt", "due, does not run"} <= set(texts)


def test_rows_of_a_picture() -> None:
    """Rows by processor, then by urgency; only trace bits that a function has."""
    text = with_line(EXAMPLE_1, "thread[1].cpu 2", "thread[1].priority 120")
    rows = rows_of(make(text, load_text(TIGHT))[0], "en")
    assert [row.name for row in rows] == [
        "CPU 1",
        "GEO",
        "external_sps",
        "MMI_DRIVER",
        "COM",
        "Windows",
        "CPU 2",
        "BACKGROUND_",
        "Windows",
        "Trace bits",
        "task_int  1",
        "task_rnd  2",
        "task_com  4",
    ]
    silent = EXAMPLE_1
    for bit in (1, 2, 4):
        silent = silent.replace(f"trace_bit {bit}", "trace_bit 0")
    assert "Trace bits" not in [row.name for row in rows_of(make(silent, None)[0], "en")]


@pytest.mark.nightly
@pytest.mark.slow
@given(st.integers(0, 5000), st.sampled_from(["en", "de"]))
@settings(max_examples=80, deadline=None)
def test_no_label_lies_over_another(seed: int, language: str) -> None:
    """Whatever the list: labels lie inside the picture and apart; it is no wider than a page."""
    model = in_microseconds(random_model(seed))
    title = PictureTitle("a" * (seed % 90) + ".lis", None)
    figure = gantt(simulate(model, 90, record=90), title, "de" if language == "de" else "en")
    assert figure.width <= 1800
    labels = [one for one in figure.shapes if isinstance(one, Label)]
    rectangles = []
    for label in labels:
        left = label_left(label)
        rectangles.append((left, label.y - 0.75 * label.size, left + text_width(label), label.y))
    for left, top, right, bottom in rectangles:
        assert 0 <= left and right <= figure.width and 0 <= top and bottom <= figure.height
    for one, other in itertools.combinations(rectangles, 2):
        apart = one[2] <= other[0] or other[2] <= one[0]
        assert apart or one[3] <= other[1] or other[3] <= one[1]


@pytest.mark.parametrize("bold", [False, True])
def test_labels_are_not_wider_than_they_count(bold: bool) -> None:
    """The estimated width of a text is not below that of the font."""
    text_path = pytest.importorskip("matplotlib.textpath").TextPath
    weight = "bold" if bold else "normal"
    properties = pytest.importorskip("matplotlib.font_manager").FontProperties(
        family="DejaVu Sans", weight=weight
    )
    for text in (
        "NC interrupt: hardware interrupt; cycle_time 2000, time_slice 500, windows_time 500 µs",
        "GEO_INTERPOLATION_CHANNEL_1",
        "wakes an external thread",
        "12000",
        "WWWW mmmm MMMM",
        "Regeln: Überlauf 'skip', Aufrufe 'block', Suspendierung nach 'ticks', Startwert 0",
        "task_mmi_driver  3",
        "illicit till fjord",
    ):
        width = text_path((0, 0), text, size=10, prop=properties).get_extents().width
        assert text_width(Label(0, 0, text, 10, bold=bold)) >= width


def in_microseconds(model: Model) -> Model:
    """A model of nanoseconds a thousand times as slow, with long names."""
    return replace(
        model,
        cycle=model.cycle * US,
        slice=model.slice * US,
        windows=model.windows * US,
        train=replace(
            model.train,
            period=model.train.period * US,
            phase=model.train.phase * US,
            drift=model.train.drift * US,
            jitter=model.train.jitter * US,
        ),
        tasks=tuple(
            replace(
                task,
                name=task.name * (3 * i + 1) * 4,
                calls=tuple(
                    replace(
                        call,
                        trace_bit=i % 4,
                        execution=replace(
                            call.execution, values=tuple(one * US for one in call.execution.values)
                        ),
                    )
                    for call in task.calls
                ),
            )
            for i, task in enumerate(model.tasks)
        ),
    )


def test_interesting_cycles_of_a_long_record() -> None:
    """A record that is too long for the strips shows overflows and the longest responses."""
    load = load_text(TIGHT).replace(
        "task_com = 250", f"task_com = {[50] * 300 + [900] + [50] * 99}"
    )
    model, _ = make(EXAMPLE_1, load)
    run = simulate(model, 800, record=800)
    strips = strips_of(run)
    assert len(strips) == 12
    late = [one.time for one in run.record.events if one.kind is EventKind.OVERFLOW]
    assert late and any(strip.begin <= late[0] < strip.end for strip in strips)
    assert strips[0].first == 0
    texts = [one.text for one in shapes_of(model, 800) if isinstance(one, Label)]
    assert any(text.startswith("96 of 800 NC cycles") for text in texts)


def test_pictures_of_odd_models() -> None:
    """Without guarantee, with late interrupts, with many cycles: still a picture."""
    for text, load in (
        (EXAMPLE_1.replace("windows_time 500", "windows_time 0"), load_text(TIGHT)),
        (EXAMPLE_1, load_text(TIGHT, extra="[interrupt]\nperiod = 2003\nphase = 137\n")),
        (EXAMPLE_1, load_text(TIGHT | {"task_int": 1700})),
    ):
        model, _ = make(text, load, convention="field")
        assert len(shapes_of(model, 200)) > 100


def test_ticks_and_windows_of_the_record() -> None:
    """Timer interrupts at multiples of time_slice, Windows between the tasks."""
    run = s1()
    assert list(tick_times(run.model, 0, 2000 * US)) == [
        0,
        500_000,
        1_000_000,
        1_500_000,
        2_000_000,
    ]
    free = [(begin // US, end // US) for begin, end in windows_times(run, 1)]
    assert free == [(1500, 2000), (3500, 4000), (5450, 6000)]


def test_too_many_ticks_are_left_out(tmp_path: Path) -> None:
    """A timer of 1 µs in a cycle of an hour would fill the disk: its ticks are not written."""
    text = change(EXAMPLE_1, cycle_time=3_600_000_000, time_slice=1, windows_time=1)
    model, _ = make(text, load_text(TIGHT))
    write_csv(simulate(model, 1, record=1), tmp_path / "a.csv")
    assert "TICK" not in (tmp_path / "a.csv").read_text("utf-8")
    assert len(shapes_of(model, 1)) < 200
