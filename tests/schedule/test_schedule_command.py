# SPDX-License-Identifier: MIT
"""``nctakt schedule``: tables, files, diagnostics and exit codes."""

from __future__ import annotations

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest
from support.schedule_examples import EXAMPLE_1, EXAMPLE_2, TIGHT, german, load_text, with_line

from nctakt.cli import main
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.messages import Collector

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Both example lists and a load."""
    (tmp_path / "rtconf.lis").write_text(EXAMPLE_1, "utf-8")
    (tmp_path / "rtconf2.lis").write_text(EXAMPLE_2, "utf-8")
    (tmp_path / "load.toml").write_text(load_text(TIGHT), "utf-8")
    return tmp_path


def run(*words: object) -> int:
    """The exit code of ``nctakt schedule``."""
    return main(["schedule", *(str(word) for word in words)])


@pytest.mark.parametrize("text", [EXAMPLE_1, EXAMPLE_2])
def test_example_lists_of_both_manuals(text: str) -> None:
    """A3 75, 78: the examples give one warning and notes; both languages the same values."""
    found = []
    for one in (text, german(text)):
        assert one.endswith(("End\n", "Ende\n"))
        collector = Collector()
        configuration = load_rtconf("rtconf.lis", one.encode(), collector)
        found.append((configuration, [item.id for item in collector.diagnostics]))
    assert found[0] == found[1]
    assert [number for number in found[0][1] if number not in (900600, 900608)] == []


def test_show(folder: Path, capsys: Capture) -> None:
    """Each parameter raw and effective with the reason; warnings alone are exit code 0."""
    assert run("show", folder / "rtconf.lis") == 0
    out = capsys.readouterr().out.splitlines()
    row = next(line for line in out if " cycle_time " in line)
    assert row.split() == ["9", "P-RTCF-00002", "cycle_time", "2000", "2000", "µs", "as", "written"]
    row = next(line for line in out if "thread[0].cpu" in line)
    assert row.split() == ["–", "P-RTCF-00015", "thread[0].cpu", "–", "1", "default"]
    assert len(out) == 2 + 6 + 4 * 9 + 2


@pytest.mark.parametrize("command", ["show", "simulate", "analyse"])
def test_a_program_is_no_list(tmp_path: Path, capsys: Capture, command: str) -> None:
    """It would have an error in each of its lines; a newcomer means the run of the program."""
    program = tmp_path / "part.nc"
    program.write_text("G01 X10 F600\nM30\n", "utf-8")
    assert run(command, program) == 2
    reported = capsys.readouterr().err
    assert "902983" in reported
    assert "nctakt run" in reported
    assert "900008" not in reported


def test_show_corrected_values(folder: Path, capsys: Capture) -> None:
    """Corrected and defaulted values name their diagnostic; errors in the list are exit code 2."""
    text = EXAMPLE_1.replace("cycle_time 2000", "cycle_time 1750").replace(
        "windows_time 500", "windows_time 499"
    )
    text = with_line(text, "thread[0].cpu 9", "thread[1].function[0].trace_bit x", "bogus 1")
    (folder / "rtconf.lis").write_text(text, "utf-8")
    assert run("show", folder / "rtconf.lis", "--lang", "de") == 2
    out = capsys.readouterr().out.splitlines()

    def row(name: str) -> list[str]:
        return next(line for line in out if f" {name} " in line).split()

    assert row("cycle_time")[2:8] == ["cycle_time", "1750", "2000", "µs", "1000153:", "cycle_time:"]
    assert row("windows_time")[3:7] == ["499", "500", "µs", "900036:"]
    assert row("thread[0].cpu")[3:6] == ["9", "1", "1000180:"]
    assert row("thread[1].function[0].trace_bit")[3:5] == ["x", "0"]
    assert "2022:" in row("thread[1].function[0].trace_bit")


def test_strict(folder: Path) -> None:
    """With --strict warnings are exit code 1."""
    assert run("show", folder / "rtconf.lis", "--strict") == 1


def test_lenient(folder: Path) -> None:
    """With --lenient missing values are warnings."""
    text = EXAMPLE_1.replace("windows_time 500", "# windows_time 500")
    (folder / "rtconf.lis").write_text(text, "utf-8")
    assert run("show", folder / "rtconf.lis") == 2
    assert run("show", folder / "rtconf.lis", "--lenient") == 0


def simulate(folder: Path, *words: object) -> int:
    """``simulate`` with the load and the table's convention."""
    common = ["--load", folder / "load.toml", "--convention", "table"]
    return run("simulate", folder / "rtconf.lis", *common, *words)


def test_simulate(folder: Path, capsys: Capture) -> None:
    """The tables per thread and of Windows, and the rules that were chosen."""
    assert simulate(folder, "--cycles", 60) == 0
    out = capsys.readouterr().out
    assert "overflow 'skip', calls 'block', suspension by 'ticks'" in out
    row = next(line for line in out.splitlines() if line.startswith("COM"))
    words = "COM asynchronous 1 4000 30 20 4.17 3450 4450 5450 -1450 10 10 30"
    assert row.split() == words.split()
    row = next(line for line in out.splitlines() if line.startswith("CPU 1"))
    assert row.split() == ["CPU", "1", "25.83", "500", "516.667", "550", "0", "–"]


def test_simulate_an_hour(folder: Path, capsys: Capture) -> None:
    """An hour of the example takes no time."""
    assert simulate(folder, "--duration", "60min") == 0
    assert "1800000 NC cycles, 3600000000 µs" in capsys.readouterr().out


def test_overflow_that_is_to_be_reported(folder: Path, capsys: Capture) -> None:
    """error_on_overflow 1: an error with thread, count and time; exit code 1."""
    (folder / "load.toml").write_text(load_text(TIGHT | {"task_int": 2100}), "utf-8")
    assert simulate(folder, "--cycles", 60, "--quiet") == 1
    err = capsys.readouterr().err
    assert "error 900630: GEO was" in err
    assert "overflows: 30, the first at 2000 µs" in err
    assert "warning 900632" in err


def test_processor_that_does_not_exist(folder: Path, capsys: Capture) -> None:
    """1000180 is an error of the schedule: it is simulated, exit code 1."""
    text = load_text(TIGHT, extra="[machine]\ncpus = 1\n")
    (folder / "load.toml").write_text(text, "utf-8")
    (folder / "rtconf.lis").write_text(with_line(EXAMPLE_1, "thread[0].cpu 2"), "utf-8")
    assert simulate(folder) == 1
    captured = capsys.readouterr()
    assert "error 1000180: GEO: CPU 2" in captured.err
    assert "Simulated" in captured.out


def test_rules_can_be_chosen(folder: Path, capsys: Capture) -> None:
    """Each choice shows in the report."""
    words = ["--overflow", "pend", "--calls", "interleave", "--suspend", "elapsed"]
    assert simulate(folder, "--cycles", 60, *words) == 0
    out = capsys.readouterr().out
    assert "overflow 'pend', calls 'interleave', suspension by 'elapsed'" in out
    assert "25.00" in out


@pytest.mark.parametrize(
    ("words", "keys"),
    [
        (["show"], {"parameters"}),
        (["simulate"], {"schedule", "cycles", "threads", "windows", "worst_phases"}),
        (["analyse"], {"schedule", "threads", "cpus", "margins"}),
    ],
)
def test_json(folder: Path, capsys: Capture, words: list[str], keys: set[str]) -> None:
    """--format json: one object on standard output with the findings in it."""
    load = [] if words == ["show"] else ["--load", folder / "load.toml"]
    assert run(*words, folder / "rtconf.lis", *load, "--format", "json") == 0
    captured = capsys.readouterr()
    assert captured.err == ""
    document = json.loads(captured.out)
    assert keys <= set(document)
    assert document["diagnostics"][0]["id"] == 900600
    assert document["diagnostics"][0]["line"] == 8
    if words == ["simulate"]:
        names = [thread["name"] for thread in document["threads"]]
        assert names == ["GEO", "BACKGROUND_", "MMI_DRIVER", "COM", "external_sps"]
        assert document["threads"][3]["response_max_us"] == 5450
        assert [one["phase_us"] for one in document["worst_phases"]] == [499.999]
    if words == ["analyse"]:
        assert document["threads"][1]["worst_phase_us"] == 499.999


def test_fix(folder: Path, capsys: Capture) -> None:
    """--fix writes what counts into the list, --output into another file; the result is shown."""
    path = folder / "rtconf.lis"
    text = EXAMPLE_1.replace("cycle_time 2000", "cycle_time 1750")
    path.write_text(text, "utf-8")
    anew = folder / "anew.lis"
    assert run("show", path, "--output", anew, "--convention", "field") == 0
    captured = capsys.readouterr()
    assert "note 900619" in captured.err and "1 entries corrected" in captured.err
    assert "1000153" not in captured.err
    assert path.read_text("utf-8") == text
    assert anew.read_text("utf-8") == EXAMPLE_1
    assert run("show", path, "--fix", "--quiet") == 0
    assert path.read_text("utf-8") == EXAMPLE_1
    capsys.readouterr()
    assert run("show", path, "--fix", "--format", "json") == 0
    found = json.loads(capsys.readouterr().out)["diagnostics"]
    assert "0 entries corrected, 0 commented out, 0 lines added" in found[-1]["text"]


def test_fix_never_takes_another_input(folder: Path, capsys: Capture) -> None:
    """--output onto the list itself is refused: that is what --fix is for."""
    path = folder / "rtconf.lis"
    assert run("show", path, "--output", path) == 2
    assert "error 900913" in capsys.readouterr().err
    assert path.read_text("utf-8") == EXAMPLE_1


def test_ignored_messages(folder: Path, capsys: Capture) -> None:
    """--ignore: neither shown nor counted."""
    words = ["show", folder / "rtconf.lis", "--strict"]
    assert run(*words) == 1
    assert run(*words, "--ignore", "900600") == 0
    assert run(*words, "--convention", "field") == 0
    assert run(*words, "--ignore", "x") == 2
    assert "error 900586" in capsys.readouterr().err


def test_check_reads_a_list_as_schedule_does(folder: Path, capsys: Capture) -> None:
    """--os, --convention and --function of ``nctakt check``."""
    text = with_line(EXAMPLE_1, "thread[1].function[1].name my_task")
    (folder / "rtconf.lis").write_text(text, "utf-8")
    words = ["check", str(folder / "rtconf.lis")]
    assert main(words) == 0
    out = capsys.readouterr().out
    assert "900600" in out and "900048" in out
    assert main([*words, "--convention", "field", "--function", "my_task", "--strict"]) == 0
    out = capsys.readouterr().out
    assert "900600" not in out and "900048" not in out
    assert main([*words, "--os", "vxworks", "--strict"]) == 1
    assert "900607" in capsys.readouterr().out


def test_starving_threads(folder: Path, capsys: Capture) -> None:
    """A thread that never finishes is a warning whatever error_on_overflow says."""
    (folder / "load.toml").write_text(load_text(TIGHT | {"task_int": 1700}), "utf-8")
    words = [folder / "rtconf.lis", "--load", folder / "load.toml", "--convention", "table"]
    for command in ("simulate", "analyse"):
        run(command, *words)
        err = capsys.readouterr().err
        for name, due in (("BACKGROUND_", 500), ("MMI_DRIVER", 167), ("COM", 250)):
            reported = next(line for line in err.splitlines() if f"warning 900636: {name} " in line)
            assert ": 0 times" in reported and f" {due} times" in reported


def test_a_mistake_of_the_load_is_shown_as_it_is_written(folder: Path, capsys: Capture) -> None:
    """As TOML; --quiet leaves the notes about the list out where the load is refused, too."""
    text = "[functions]\ntask_int = { uniform = [5, 1] }\n"
    (folder / "load.toml").write_text(text, "utf-8")
    words = ["simulate", folder / "rtconf.lis", "--load", folder / "load.toml"]
    assert run(*words, "--quiet") == 2
    err = capsys.readouterr().err
    assert "functions.task_int: { uniform = [5, 1] } is not" in err
    assert "note" not in err
    assert run(*words) == 2
    assert "note" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["simulate", "analyse"])
def test_a_thread_that_falls_behind(folder: Path, capsys: Capture, command: str) -> None:
    """Wake-ups of an external thread queue up: it ends each time, ever later."""
    text = load_text(TIGHT | {"external_sps": 1900})
    (folder / "load.toml").write_text(text, "utf-8")
    run(command, folder / "rtconf.lis", "--load", folder / "load.toml", "--convention", "table")
    err = capsys.readouterr().err
    assert "warning 901471: external_sps cannot keep up" in err
    assert "of 500 activations still wait at the end" in err


def test_phase_that_the_load_does_not_name(folder: Path, capsys: Capture) -> None:
    """3.1: the simulation assumes a phase and shows what the worst one would do."""
    words = ["simulate", folder / "rtconf.lis", "--convention", "field"]
    run(*words, "--load", folder / "load.toml")
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["BACKGROUND_", "R", "max", "1300", "2899.999"] in rows
    assert ["Windows", "least", "500", "999.999"] in rows
    named = folder / "named.toml"
    named.write_text(
        (folder / "load.toml").read_text("utf-8") + "[interrupt]\nphase = 0\n", "utf-8"
    )
    run(*words, "--load", named)
    assert "Phase" not in capsys.readouterr().out


def test_analysis_that_contradicts_the_simulation(
    folder: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A response above its bound is an internal error that names the thread."""
    monkeypatch.setattr(
        "nctakt.schedule.analysis.response._BusyTime.longest_response", lambda busy: 1
    )
    assert run("analyse", folder / "rtconf.lis", "--load", folder / "load.toml") == 3
    assert "GEO: response 400000 ns, bound 1 ns" in capsys.readouterr().err


def test_analyse(folder: Path, capsys: Capture) -> None:
    """Responses, load against supply, and the limits."""
    words = ["--load", folder / "load.toml", "--convention", "table"]
    assert run("analyse", folder / "rtconf.lis", *words, "--lang", "de") == 0
    captured = capsys.readouterr()
    row = next(line for line in captured.out.splitlines() if line.startswith("COM"))
    expected = ["COM", "250", "4000", "6.25", "≤", "5450", "5450", "-1450", "möglich"]
    assert row.split() == expected
    assert "kleinste cycle_time: 2500 µs" in captured.out
    assert "größte windows_time: 0 µs" in captured.out
    assert "Warnung 900637" in captured.err
    assert "Warnung 900638: COM" in captured.err


def test_both_examples_are_simulated_without_a_load(folder: Path, capsys: Capture) -> None:
    """The assumed times are reported in a note."""
    for name in ("rtconf.lis", "rtconf2.lis"):
        assert run("simulate", folder / name) == 0
        assert "note 900625" in capsys.readouterr().err


def test_pictures_and_traces(folder: Path) -> None:
    """Each file is what its format says, and the same each time."""
    pytest.importorskip("vcd")
    names = ("a.svg", "a.html", "a.vcd", "a.json", "a.csv")
    texts = []
    for _ in range(2):
        options = ["--vcd", folder / "a.vcd", "--perfetto", folder / "a.json"]
        options += ["--csv", folder / "a.csv"]
        assert simulate(folder, "--plot", folder / "a.svg", *options) == 0
        assert simulate(folder, "--plot", folder / "a.html") == 0
        texts.append([(folder / name).read_text("utf-8") for name in names])
    assert texts[0] == texts[1]
    root = ElementTree.fromstring(texts[0][0])
    assert root.tag.endswith("svg")
    assert "<svg" in texts[0][1] and "COM" in texts[0][1]
    assert json.loads(texts[0][3])["traceEvents"]
    assert texts[0][4].startswith("time_us,event,thread,cpu,job,value\n0,NC,,,,0\n")


@pytest.mark.slow
def test_png(folder: Path) -> None:
    """A picture as PNG."""
    pytest.importorskip("matplotlib")
    assert simulate(folder, "--plot", folder / "a.PNG") == 0
    assert (folder / "a.PNG").read_bytes().startswith(b"\x89PNG")


def test_more_cycles_in_the_picture(folder: Path) -> None:
    """--drawn says how many cycles pictures and traces show."""
    assert simulate(folder, "--csv", folder / "a.csv", "--drawn", 9, "--cycles", 2) == 0
    text = (folder / "a.csv").read_text("utf-8")
    assert sum(line.split(",")[1] == "NC" for line in text.splitlines()) == 9


BAD = [
    (["show", "missing.lis"], 900500),
    (["show", "."], 900501),
    (["simulate", "rtconf.lis", "--load", "missing.toml"], 900500),
    (["simulate", "rtconf.lis", "--load", "bad.toml"], 900623),
    (["simulate", "rtconf.lis", "--load", "no.toml"], 900620),
    (["simulate", "empty.lis"], 900612),
    (["analyse", "empty.lis"], 900612),
    (["show", "empty.lis"], 900612),
    (["simulate", "nothread.lis"], 900612),
    (["simulate", "rtconf.lis", "--duration", "long"], 900510),
    (["simulate", "rtconf.lis", "--plot", "a.pdf"], 900635),
    (["simulate", "rtconf.lis", "--plot", "missing/a.svg"], 900507),
    (["simulate", "rtconf.lis", "--csv", "missing/a.csv"], 900507),
]


@pytest.mark.parametrize(("words", "number"), BAD)
def test_bad_input(
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: Capture,
    words: list[str],
    number: int,
) -> None:
    """What cannot be used has its diagnostic and exit code 2, and no traceback."""
    monkeypatch.chdir(folder)
    Path("bad.toml").write_text("[functions]\ntask_int = -1\n", "utf-8")
    Path("no.toml").write_text("[functions\n", "utf-8")
    Path("empty.lis").write_text("", "utf-8")
    Path("nothread.lis").write_text(
        "interrupt_source 2\ncycle_time 2000\ntime_slice 500\nwindows_time 500\nEnd\n", "utf-8"
    )
    assert run(*words) == 2
    assert f" {number}: " in " " + capsys.readouterr().err


def test_all_time_for_windows(folder: Path, capsys: Capture) -> None:
    """A windows_time of the whole cycle is simulated with a warning; threads get nothing."""
    text = EXAMPLE_1.replace("windows_time 500", "windows_time 2000")
    (folder / "rtconf.lis").write_text(text, "utf-8")
    assert simulate(folder, "--cycles", 6) == 0
    captured = capsys.readouterr()
    assert "warning 900038" in captured.err
    row = next(line for line in captured.out.splitlines() if line.startswith("COM"))
    assert row.split()[5] == "0"


def test_libraries_are_optional(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    """Without pyvcd or matplotlib only their own option fails, with what to install."""
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert simulate(folder, "--vcd", folder / "a.vcd") == 2
    assert simulate(folder, "--plot", folder / "a.png") == 2
    assert capsys.readouterr().err.count('pip install "matplotlib>=3.8" "pyvcd>=0.4"') == 2
    assert simulate(folder, "--plot", folder / "a.svg") == 0
