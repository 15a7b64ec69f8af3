# SPDX-License-Identifier: MIT
"""``nctakt schedule learn``: execution times from recordings, and what cannot be learnt."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.schedule_examples import EXAMPLE_1, TIGHT, load_text, make, with_line

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.messages import Collector
from nctakt.schedule.learn import learn
from nctakt.schedule.load import read_load
from nctakt.schedule.model import Model
from nctakt.schedule.simulation.simulate import simulate
from nctakt.schedule.simulation.tracebits import trace_bits
from nctakt.schedule.trace_reader import Recording, read_recording

Capture = pytest.CaptureFixture[str]
US = 1000
#: Each function of S1 has a bit.
BITS = with_line(EXAMPLE_1, "thread[2].function[0].trace_bit 3")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The list of S1 with a bit for each function, and its load."""
    (tmp_path / "rtconf.lis").write_text(BITS, "utf-8")
    (tmp_path / "load.toml").write_text(load_text(TIGHT), "utf-8")
    return tmp_path


def run(folder: Path, command: str, *words: str) -> int:
    """The exit code of a command of ``nctakt schedule`` for the list."""
    path = str(folder / "rtconf.lis")
    return main(["schedule", command, path, *words, "--convention", "table", "--quiet"])


def record(folder: Path, option: str, path: Path, load: str = "load.toml") -> None:
    """Simulate the list and write a trace of 30 NC cycles."""
    words = ["--load", str(folder / load), "--drawn", "30", option, str(path)]
    assert run(folder, "simulate", *words) == 0


@pytest.mark.parametrize(("option", "name"), [("--vcd", "a.vcd"), ("--csv", "a.csv")])
def test_a_trace_of_a_simulation_gives_its_load(
    folder: Path, capsys: Capture, option: str, name: str
) -> None:
    """What was simulated is learnt, through preemptions and suspensions."""
    if option == "--vcd":
        pytest.importorskip("vcd")
    record(folder, option, folder / name)
    capsys.readouterr()
    assert run(folder, "learn", str(folder / name)) == 0
    load = read_load("learnt.toml", capsys.readouterr().out, Collector())
    times = {key: one.values[0] // US for key, one in load.functions.items()}
    assert times == {key: time for key, time in TIGHT.items() if key != "external_sps"}
    if option == "--csv":
        execution = load.external["external_sps"].execution
        assert execution is not None and execution.values == (200 * US,)


@pytest.mark.parametrize("form", ["uniform", "list", "longest"])
def test_how_times_are_written(folder: Path, capsys: Capture, form: str) -> None:
    """--as: the range, all in turn, the longest; the file is a load."""
    text = load_text(TIGHT).replace("task_rnd = 700", "task_rnd = [500, 600, 700]")
    (folder / "varied.toml").write_text(text, "utf-8")
    record(folder, "--csv", folder / "a.csv", "varied.toml")
    output = folder / "learnt.toml"
    capsys.readouterr()
    assert run(folder, "learn", str(folder / "a.csv"), "--as", form, "--output", str(output)) == 0
    assert capsys.readouterr().out == ""
    collector = Collector()
    execution = read_load("l", output.read_text("utf-8"), collector).functions["task_rnd"]
    assert collector.diagnostics == []
    assert execution.longest == 700 * US
    assert execution.spread is (form == "uniform")
    if form == "list":
        assert execution.values[:4] == (500 * US, 600 * US, 700 * US, 500 * US)


def bits_only(model: Model, cycles: int) -> Recording:
    """What an oscilloscope sees of a simulation: the bits, and nothing else."""
    record = simulate(model, cycles, record=cycles).record
    # It is switched on before the first call and off after the last one.
    return Recording(record.begin - US, record.end + US, trace_bits(model, record))


def test_bits_alone() -> None:
    """Without anything else the suspension is that of the list: COM is high from 3400 to 5450."""
    model, _ = make(BITS, load_text(TIGHT))
    recording = bits_only(model, 12)
    assert (3400 * US, 5450 * US) in recording.bits[4]
    learnt = learn(model, recording)
    assert {name: set(times) for (_, name), times in learnt.calls.items()} == {
        "task_int": {400 * US},
        "task_rnd": {700 * US},
        # The external thread has no bit: the 200 µs in which it interrupts these count as theirs.
        "task_mmi_driver": {500 * US},
        "task_com": {450 * US},
    }
    assert [one.id for one in learnt.diagnostics] == [900645, 900644]
    assert learnt.diagnostics[1].values["names"] == "external_sps"


@given(st.integers(50, 700), st.integers(50, 600), st.integers(50, 600), st.integers(50, 600))
@settings(max_examples=60, deadline=None)
def test_bits_of_all_threads_are_enough(geo: int, rnd: int, mmi: int, com: int) -> None:
    """Where each thread has its own bit the times come out to the nanosecond."""
    text = "\n".join(line for line in BITS.splitlines() if not line.startswith("external_thread"))
    times = {"task_int": geo, "task_rnd": rnd, "task_mmi_driver": mmi, "task_com": com}
    load = "[functions]\n" + "".join(f"{name} = {time}\n" for name, time in times.items())
    model, _ = make(text + "\n", load)
    for (_, name), found in learn(model, bits_only(model, 24)).calls.items():
        assert set(found) == {times[name] * US}


def test_suspension_that_cannot_be_known() -> None:
    """An interrupt from outside: the timer's phase is not in the recording."""
    model, _ = make(BITS, load_text(TIGHT), convention="field")
    learnt = learn(model, bits_only(model, 12))
    assert [one.id for one in learnt.diagnostics] == [900645, 900646, 900644]


def test_bits_of_several_functions() -> None:
    """They are distinguished by nobody."""
    text = with_line(EXAMPLE_1, "thread[3].function[0].trace_bit 2")
    model, _ = make(text, load_text(TIGHT))
    learnt = learn(model, bits_only(model, 12))
    assert 900643 in [one.id for one in learnt.diagnostics]
    assert [name for _, name in learnt.calls] == ["task_int"]


def test_calls_that_the_recording_cuts() -> None:
    """A call that is high at the begin or at the end of the recording does not count."""
    model, _ = make(BITS, load_text(TIGHT))
    bits = {1: [(0, 300 * US), (2000 * US, 2400 * US), (4000 * US, 4100 * US)]}
    learnt = learn(model, Recording(0, 4100 * US, bits))
    assert learnt.calls == {(0, "task_int"): (400 * US,)}


def test_one_function_in_two_threads(folder: Path, capsys: Capture) -> None:
    """Each place in the list has its own times."""
    text = BITS.replace("task_mmi_driver", "task_rnd")
    (folder / "rtconf.lis").write_text(text, "utf-8")
    sampled = "time_us,bit2,bit3\n0,0,0\n100,1,0\n200,0,1\n350,0,0\n1000,0,0\n"
    (folder / "a.csv").write_text(sampled, "utf-8")
    assert run(folder, "learn", str(folder / "a.csv")) == 0
    out = capsys.readouterr().out
    assert '"thread[1].function[0]" = 100' in out
    assert '"thread[2].function[0]" = 150' in out


@pytest.mark.parametrize(
    ("head", "factor"), [("time_s", "e-6"), ("time_ms", "e-3"), ("time_us", ""), ("time_ns", "e3")]
)
def test_units_of_samples(head: str, factor: str) -> None:
    """Levels may be volts, times in any unit."""
    text = f"{head},Bit1\n0{factor},0.1\n100{factor},3.3\n400{factor},0.2\n900{factor},0\n"
    recording = read_recording("a.csv", text)
    assert recording.bits == {1: [(100 * US, 400 * US)]}
    assert (recording.begin, recording.end) == (0, 900 * US)


VCD = """\
$timescale 10 us $end
$scope module top $end
$var wire 1 ! bit1 $end
$var wire 8 " bus $end
$upscope $end
$enddefinitions $end
#0
$dumpvars
0!
b00000000 "
$end
#10
1!
b10000001 "
#50
0!
#90
x!
"""


def test_vcd_of_another_tool() -> None:
    """Timescale, vectors and unknown levels."""
    recording = read_recording("a.vcd", VCD)
    assert recording.bits == {1: [(100 * US, 500 * US)]}
    assert recording.end == 900 * US


@pytest.mark.parametrize(
    "text",
    [
        "",
        "\n",
        "a,b\n1,2\n",
        "time_us\n1\n",
        "time_us,bit1\n1,x\n",
        "time_us,bit1\n1\n",
        "time_us,bit1\n2,0\n1,0\n",
        "time_us,bit1\nnan,0\n",
        "time_us,bit1\n1e400,0\n",
        f"time_us,bit1\n{'1' * 200_000},0\n",
        "time_us,event,thread,cpu,job,value\n0,RUN,GEO,1,0,x\n",
        "$timescale 3 us $end\n",
        "$timescale 1 us",
        "$end\n#2\n#1\n",
        "$end\n#x\n",
        "a\rb\r1\r",
    ],
)
def test_recordings_that_cannot_be_read(text: str) -> None:
    """900641 says why."""
    with pytest.raises(Failure) as raised:
        read_recording("a", text)
    assert [one.id for one in raised.value.diagnostics] == [900641]
    assert raised.value.diagnostics[0].render("en") and raised.value.diagnostics[0].render("de")


@given(st.text(alphabet='$#01x!b \n\r",.-etimeubd_sw\0\x85é', max_size=80))
@settings(max_examples=300, deadline=None)
def test_no_text_is_too_odd(text: str) -> None:
    """It is read or refused."""
    for one in (text, f"$timescale 1 us $end {text}", f"time_us,bit1\n{text}"):
        try:
            read_recording("a", one)
        except Failure as failure:
            assert [found.id for found in failure.diagnostics] == [900641]


def test_nothing_to_learn(folder: Path, capsys: Capture) -> None:
    """900642: none of the list's bits is in the recording; the file is not written."""
    (folder / "a.csv").write_text("time_us,bit7\n0,0\n1,1\n2,0\n3,0\n", "utf-8")
    output = folder / "learnt.toml"
    assert run(folder, "learn", str(folder / "a.csv"), "--output", str(output)) == 2
    assert "error 900642" in capsys.readouterr().err
    assert not output.exists()


def test_json(folder: Path, capsys: Capture) -> None:
    """All times for other programs."""
    (folder / "a.csv").write_text("time_us,bit1\n0,0\n1,1\n2.5,0\n3,0\n", "utf-8")
    run(folder, "learn", str(folder / "a.csv"), "--format", "json")
    document = json.loads(capsys.readouterr().out)
    assert document["functions"] == [
        {"thread": "thread[0]", "function": "task_int", "times_us": [1.5]}
    ]


def test_a_load_never_takes_the_recording(folder: Path, capsys: Capture) -> None:
    """--output onto an input is refused."""
    path = folder / "a.csv"
    path.write_text("time_us,bit1\n0,0\n1,1\n2,0\n3,0\n", "utf-8")
    assert run(folder, "learn", str(path), "--output", str(path)) == 2
    assert "error 900913" in capsys.readouterr().err
