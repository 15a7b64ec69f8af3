# SPDX-License-Identifier: MIT
"""A controller that a schedule gives its time: P-RTCF-00001 … 00018 in a run."""

from __future__ import annotations

import io
import shutil
from pathlib import Path

import pytest

import nctakt
from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions
from nctakt.results.run import Run
from nctakt.results.summary import print_summary
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView
from nctakt.schedule.open_schedule import RunSchedule, open_schedule

pytestmark = pytest.mark.slow

EXAMPLES = Path(__file__).parents[2] / "examples"
LIST = """\
interrupt_source 3
external_object_name nctakt
cycle_time 1000
time_slice 250
windows_time 250
schedule SWITCHED
thread[0].name GEO
thread[0].cycle 1000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[1].name BACKGROUND
thread[1].cycle 1000
thread[1].priority 105
thread[1].function[0].name task_rnd
End
"""
LOAD = "[functions]\ntask_int = 100\ntask_rnd = 600\n[controller]\nblock = 1\n"
DEMO = Path(nctakt.__file__).parent / "machines" / "demo"
PLC = "external_thread[0].semaphore_name plc\nexternal_thread[0].cycle 2000\n"
PLC_LOAD = "[external.plc]\ntime = 50\n"


def schedule(
    folder: Path, text: str = LIST, load: str = LOAD, options: RtconfOptions | None = None
) -> RunSchedule:
    """A list and a load as files, opened."""
    (folder / "rtconf.lis").write_text(text, "utf-8")
    (folder / "load.toml").write_text(load, "utf-8")
    return open_schedule(folder / "rtconf.lis", folder / "load.toml", options)


def with_lines(text: str, *lines: str) -> str:
    """A list with other lines for the same entries, or further ones."""
    names = {line.split()[0] for line in lines}
    kept = [line for line in text.splitlines() if line.split()[0] not in names]
    return "\n".join([*lines, *kept, ""])


def run(given: RunSchedule | None, program: str | Path, **further: object) -> Run:
    """A program on the demo machine."""
    text = program if isinstance(program, Path) else NcText("program.nc", program)
    return Controller(None, given).run(text, **further)  # type: ignore[arg-type]


def events(one: Run, *kinds: str) -> list[str]:
    """The events of these kinds as ``tick kind text``."""
    return [f"{event.tick} {event}" for event in one.events if event.kind in kinds]


def rows(one: Run, *, without: str = "") -> dict[str, list[float]]:
    """The values of all signals but those whose name ends so."""
    assert one.trace is not None
    names = [signal.name for signal in one.trace.signals]
    wanted = [name for name in names if not without or not name.endswith(without)]
    return {name: list(one.trace[name]) for name in wanted}


#: The examples for the built-in machine.
PROGRAMS = [
    one for one in sorted(EXAMPLES.glob("*.nc")) if "--machine" not in one.read_text("utf-8")
]


@pytest.mark.parametrize("program", PROGRAMS, ids=[one.stem for one in PROGRAMS])
def test_time_enough_changes_nothing(program: Path, tmp_path: Path) -> None:
    """With time enough for the decoder, and the order SWITCHED, a run is as without a list."""
    plain = run(None, program)
    paced = run(schedule(tmp_path), program)
    assert [str(event) for event in paced.events] == [str(event) for event in plain.events]
    assert rows(paced) == rows(plain)
    assert (paced.state, paced.ticks, paced.starved) == (plain.state, plain.ticks, ())


@pytest.mark.parametrize("program", PROGRAMS, ids=[one.stem for one in PROGRAMS])
def test_starved_programs_do_the_same_later(program: Path, tmp_path: Path) -> None:
    """A decoder without time enough delays a program, and changes nothing else of its path."""
    slow = LIST.replace("thread[1].cycle 1000", "thread[1].cycle 7000")
    plain = run(None, program)
    paced = run(schedule(tmp_path, slow, LOAD.replace("block = 1", "block = 500")), program)
    assert paced.state == plain.state
    assert paced.ticks >= plain.ticks
    assert paced.trace is not None
    assert plain.trace is not None
    for name in rows(plain):
        if name.endswith("ACS.ACT_POS"):
            assert paced.trace[name][-1] == pytest.approx(plain.trace[name][-1], abs=1e-9)
    kinds = ("output", "message")
    said = [[f"{e.kind} {e.text}" for e in one.events if e.kind in kinds] for one in (plain, paced)]
    assert said[0] == said[1]


def test_blocks_of_a_compensated_contour_take_their_time(tmp_path: Path) -> None:
    """P-RTCF-00012: a contour under G41, whose blocks go on late (MO-9), is not decoded faster."""
    blocks = [f"V.E.COUNT = 1\nX{place} Y{place}" for place in range(20, 60)]
    moves = "\n".join(["G01 F60000 X0 Y0", "{}", "X10 Y10", *blocks, "{}", "X0 Y0", "M30"])
    given = schedule(tmp_path, load=LOAD.replace("block = 1", "block = 100"))
    decoded = []
    for begin, end in (("F60000", "F60000"), ("V.G.WZ_AKT.R = 1\nG41", "G40")):
        paced = run(given, moves.format(begin, end), blocks=True)
        assert paced.state == "ended"
        ticks = [str(event).split()[3] for event in paced.events if event.kind == "block"]
        decoded.append(max(ticks.count(str(tick)) for tick in range(1, 10)))
    assert decoded == [6, 6]


def test_standard_puts_out_one_tick_later(tmp_path: Path) -> None:
    """P-RTCF-00018: STANDARD puts out what the call before has computed; nothing else differs."""
    program = "N10 G01 X1 F6000\nN20 G01 X3 Y1\nN30 G04 X0.01\nM30\n"
    plain = run(None, program)
    late = run(schedule(tmp_path, LIST.replace("SWITCHED", "STANDARD")), program)
    assert rows(late, without="CUR_POS") == rows(plain, without="CUR_POS")
    assert plain.trace is not None
    assert late.trace is not None
    for axis in "XY":
        before = [0.0, *plain.trace[f"{axis}.ACS.CUR_POS"][:-1]]
        assert list(late.trace[f"{axis}.ACS.CUR_POS"]) == pytest.approx(before, abs=1e-9)


def test_complete_needs_axes_that_allow_it(tmp_path: Path) -> None:
    """COMPLETE is STANDARD unless all axes have P-AXIS-00276, which the demo machine has not."""
    program = "N10 G01 X1 F6000\nM30\n"
    standard = run(schedule(tmp_path, LIST.replace("SWITCHED", "STANDARD")), program)
    complete = run(schedule(tmp_path, LIST.replace("SWITCHED", "COMPLETE")), program)
    assert rows(complete) == rows(standard)


def test_complete_where_all_axes_allow_it(tmp_path: Path) -> None:
    """P-AXIS-00276 in the defaults list of the axes: COMPLETE puts out in the tick, as SWITCHED."""
    machine = tmp_path / "machine"
    shutil.copytree(DEMO, machine)
    defaults = machine / "default_achs.lis"
    allowed = "lr_param.field_bus_allows_optimized_schedule 1\n"
    defaults.write_text(allowed + defaults.read_text("utf-8"), "utf-8")
    program = NcText("program.nc", "N10 G01 X1 F6000\nM30\n")
    complete = schedule(tmp_path, LIST.replace("SWITCHED", "COMPLETE"))
    one = Controller(machine, complete).run(program)
    other = Controller(machine, schedule(tmp_path)).run(program)
    assert rows(one) == rows(other)


def test_the_tick_is_the_cycle_of_the_interpolation(tmp_path: Path) -> None:
    """P-RTCF-00002 and 00009: cycle_time, or a multiple where GEO's thread has one."""
    two = with_lines(LIST, "cycle_time 2000", "thread[0].cycle 2000", "thread[1].cycle 2000")
    one = run(schedule(tmp_path, two), "N10 G04 X0.008\nM30\n")
    assert (one.cycle_time_us, one.ticks) == (2000, 5)
    assert [found.id for found in one.diagnostics] == [900730]
    slow = with_lines(LIST, "thread[0].cycle 4000")
    other = run(schedule(tmp_path, slow), "N10 G04 X0.008\nM30\n")
    assert (other.cycle_time_us, other.ticks) == (4000, 3)


class Listener:
    """A PLC that only notes when it was called."""

    def __init__(self) -> None:
        self.ticks: list[int] = []

    def cycle(self, hli: PlcView) -> None:
        """One call."""
        self.ticks.append(hli.tick)


def test_the_plc_runs_when_its_thread_ends(tmp_path: Path) -> None:
    """P-RTCF-00006: the external thread of each second NC cycle, the cycles 2, 4 …

    Tick k is the call of GEO in NC cycle k + 1, so the PLC comes after the ticks 1, 3, 5.
    """
    given = schedule(tmp_path, LIST.replace("End", PLC + "End"), LOAD + PLC_LOAD)
    listener = Listener()
    run(given, "N10 G04 X0.006\nM30\n", plc=listener)
    every = Listener()
    run(schedule(tmp_path), "N10 G04 X0.006\nM30\n", plc=every)
    assert [tick - every.ticks[0] for tick in listener.ticks] == [1, 3, 5]
    assert [tick - every.ticks[0] for tick in every.ticks] == [0, 1, 2, 3, 4, 5, 6]


def test_a_plc_before_the_interpolation(tmp_path: Path) -> None:
    """A PLC that is more urgent than GEO ends its call in NC cycle 2 before tick 1 begins."""
    load = LOAD + PLC_LOAD + "priority = 120\n"
    given = schedule(tmp_path, LIST.replace("End", PLC + "End"), load)
    listener, every = Listener(), Listener()
    run(given, "N10 G04 X0.006\nM30\n", plc=listener)
    run(schedule(tmp_path), "N10 G04 X0.006\nM30\n", plc=every)
    assert [tick - every.ticks[0] for tick in listener.ticks] == [0, 2, 4, 6]


def test_the_default_plc_acknowledges_in_its_thread(tmp_path: Path) -> None:
    """Without a script the PLC acknowledges when its thread ends: after tick 3, not tick 2.

    M100 goes out in tick 2, after a dwell of two ticks; the block after it waits for it.
    """
    program = "N10 G04 X0.002\nN20 M111\nN30 G04 X0.001\nM30\n"
    given = schedule(tmp_path, LIST.replace("End", PLC + "End"), LOAD + PLC_LOAD)
    plain, paced = run(None, program), run(given, program)
    assert events(plain, "output") == events(paced, "output") == ["2 output M 111"]
    assert events(plain, "end") == ["4 end program.nc"]
    assert events(paced, "end") == ["5 end program.nc"]


def test_a_plc_that_gets_no_time(tmp_path: Path) -> None:
    """A PLC below a thread that takes all never answers, and the program waits for it."""
    hungry = LOAD.replace("task_rnd = 600", "task_rnd = 900") + PLC_LOAD + "priority = 1\n"
    text = with_lines(LIST.replace("End", PLC + "End"), "windows_time 0")
    given = schedule(tmp_path, text, hungry)
    one = run(given, "N10 M111\nM30\n", ticks=50)
    assert one.state == "limit"


def test_which_external_thread_is_the_plc(tmp_path: Path) -> None:
    """The load names it; a name that the list has not is 900733."""
    text = LIST.replace("End", PLC + PLC.replace("[0]", "[1]").replace(" plc", " other") + "End")
    load = LOAD + PLC_LOAD + "[external.other]\ntime = 10\n"
    assert schedule(tmp_path, text, load.replace("block = 1", 'block = 1\nplc = "other"'))
    wrong = schedule(tmp_path, text, load.replace("block = 1", 'block = 1\nplc = "none"'))
    with pytest.raises(Failure) as failure:
        Controller(None, wrong)
    assert 900733 in [found.id for found in failure.value.diagnostics]


@pytest.mark.parametrize(
    ("line", "numbers"),
    [
        ("thread[1].function[0].name task_com", [900621, 260102]),
        ("cycle_time 100", [900032, 1000153, 900038]),
    ],
)
def test_lists_that_cannot_run_a_program(line: str, numbers: list[int], tmp_path: Path) -> None:
    """No decoder, errors in the list: refused before the first tick, with all that was found."""
    load = "[functions]\ntask_int = 100\ntask_com = 100\ntask_rnd = 600\n"
    with pytest.raises(Failure) as failure:
        Controller(None, schedule(tmp_path, with_lines(LIST, line), load))
    assert [one.id for one in failure.value.diagnostics] == numbers


def test_without_task_int_the_most_urgent_thread_interpolates(tmp_path: Path) -> None:
    """As in the simulation: no thread with task_int is reported, and the first one counts as it."""
    load = "[functions]\ntask_com = 100\ntask_rnd = 600\n"
    text = with_lines(LIST, "thread[0].function[0].name task_com")
    one = run(schedule(tmp_path, text, load), "N10 G04 X0.002\nM30\n")
    assert (one.state, one.ticks) == ("ended", 3)


def test_interpolations_of_different_cycles(tmp_path: Path) -> None:
    """Two threads with task_int and different cycles have no common tick (260101)."""
    second = [
        "thread[2].name GEO2",
        "thread[2].cycle 2000",
        "thread[2].priority 114",
        "thread[2].function[0].name task_int",
    ]
    with pytest.raises(Failure) as failure:
        Controller(None, schedule(tmp_path, with_lines(LIST, *second)))
    assert 260101 in [one.id for one in failure.value.diagnostics]


def test_words_of_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """--load and --os belong to --rtconf; bad lists and loads end with exit code 2."""
    (tmp_path / "part.nc").write_text("N10 G04 X0.002\nM30\n", "utf-8")
    schedule(tmp_path)
    part, listed, load = (str(tmp_path / name) for name in ("part.nc", "rtconf.lis", "load.toml"))
    assert main(["run", part, "--rtconf", listed, "--load", load, "--os", "rtx"]) == 0
    assert main(["run", part, "--load", load]) == 2
    assert main(["run", part, "--os", "linux"]) == 2
    assert "900734" in capsys.readouterr().err
    assert main(["run", part, "--rtconf", str(tmp_path / "none.lis")]) == 2
    (tmp_path / "load.toml").write_text("[controller]\nblock = -1\nplc = 3\n", "utf-8")
    assert main(["run", part, "--rtconf", listed, "--load", load]) == 2
    assert capsys.readouterr().err.count("900623") == 2
    (tmp_path / "rtconf.lis").write_text("", "utf-8")
    assert main(["run", part, "--rtconf", listed]) == 2
    assert "900612" in capsys.readouterr().err


def test_priorities_of_another_system(tmp_path: Path) -> None:
    """P-RTCF-00010: on VxWorks 115 is less urgent than 105, so the decoder comes first.

    It wants 1200 µs and is suspended at 750, so it ends at 450 of the next cycle: an overflow in
    the NC cycles 1 and 3, ticks 0 and 2. GEO comes after it, and in each cycle.
    """
    load = LOAD.replace("task_rnd = 600", "task_rnd = 1200")
    given = schedule(tmp_path, LIST, load, RtconfOptions(PROFILES["vxworks"]))
    one = run(given, "N10 G04 X0.002\nM30\n")
    assert events(one, "overflow") == ["0 overflow BACKGROUND", "2 overflow BACKGROUND"]
    assert events(one, "end") == ["2 end program.nc"]


def test_summary_tells_it_in_both_languages(tmp_path: Path) -> None:
    """When the queue was empty and for how long; who overflowed."""
    slow = LIST.replace("thread[1].cycle 1000", "thread[1].cycle 5000")
    program = "N10 G04 X0.001\nN20 G04 X0.001\nM30\n"
    one = run(schedule(tmp_path, slow, LOAD.replace("block = 1", "block = 600")), program)
    assert [(found.first_tick, found.ticks) for found in one.starved] == [(1, 4), (6, 4)]
    for language, words in (("en", "ran empty 2 times, for 8"), ("de", "2-mal leer, zusammen 8")):
        text = io.StringIO()
        print_summary(one, text, language)  # type: ignore[arg-type]
        assert words in text.getvalue()
        assert "schedule SWITCHED" in text.getvalue()
        assert "600 µs" in text.getvalue()


def test_overflows_are_those_of_the_ticks(tmp_path: Path) -> None:
    """P-RTCF-00011: an error for the thread that wants one, with the ticks that were.

    The calls take 100, 100, 1500 µs: NC cycle 2 is tick 1, so tick 2 is lost; cycle 6 is too late.
    """
    given = schedule(tmp_path, LIST, LOAD.replace("= 100", "= [100, 100, 1500]"))
    one = run(given, "N10 G04 X0.003\nM30\n")
    assert [(found.thread, found.count, found.first_tick) for found in one.overflows] == [
        ("GEO", 1, 2),
        ("BACKGROUND", 2, 2),
    ]
    errors = [found.text("en") for found in one.errors]
    assert len(errors) == 1
    assert "GEO" in errors[0]
    assert "overflows: 1, the first at 2000" in errors[0]


def test_answers_come_with_the_decoders_time(tmp_path: Path) -> None:
    """The decoder goes on after #FLUSH WAIT when its thread runs, not before.

    One block in each five ticks: the dwell in tick 0, the flush in tick 5, the dwell in tick 10.
    """
    slow = LIST.replace("thread[1].cycle 1000", "thread[1].cycle 5000")
    given = schedule(tmp_path, slow, LOAD.replace("block = 1", "block = 600"))
    one = run(given, "N10 G04 X0.001\n#FLUSH WAIT\nN20 G04 X0.001\nM30\n", signals=["BLOCK"])
    assert one.trace is not None
    assert [tick for tick, number in enumerate(one.trace["BLOCK"]) if number] == [0, 10]
    assert events(one, "end") == ["15 end program.nc"]


def test_programs_in_a_row_and_runs_in_a_row(tmp_path: Path) -> None:
    """The second program begins without a tick between them, as without a schedule."""
    controller, plain = Controller(None, schedule(tmp_path)), Controller()
    text = NcText("one.nc", "N10 G04 X0.002\nM30\n")
    for _ in range(2):
        paced, usual = controller.run(text, text), plain.run(text, text)
        assert events(paced, "end") == events(usual, "end")
        assert paced.ticks == usual.ticks


def test_reset_while_the_queue_is_empty(tmp_path: Path) -> None:
    """RESET on the HLI ends a starving program; what it still owed is not the next one's."""
    slow = LIST.replace("thread[1].cycle 1000", "thread[1].cycle 5000")
    controller = Controller(
        None, schedule(tmp_path, slow, LOAD.replace("block = 1", "block = 500"))
    )
    text = NcText("one.nc", "N10 G04 X0.001\nN20 G04 X0.001\nN30 G04 X0.001\nM30\n")
    pressed = Stimulus("3 ms", "HLI.RESET", 1)
    first = controller.run(text, at=[pressed])
    assert first.state == "reset"
    assert [found.first_tick for found in first.starved] == [1]
    second = controller.run(NcText("two.nc", "N10 G04 X0.001\nM30\n"))
    assert second.state == "ended"


def test_values_are_read_when_a_block_begins(tmp_path: Path) -> None:
    """Of 600 µs in each fifth NC cycle N10 takes 400, N20 the rest and 200 before tick 5.

    So #MSG begins there: it sees what V.E.ASYNC is since tick 3, and not what it is from tick 5 on.
    The message comes after the dwell N20, which is tick 5.
    """
    slow = LIST.replace("thread[1].cycle 1000", "thread[1].cycle 5000")
    given = schedule(tmp_path, slow, LOAD.replace("block = 1", "block = 400"))
    program = 'N10 G04 X0.001\nN20 G04 X0.001\n#MSG ["%d", V.E.ASYNC]\nM30\n'
    said = [
        events(run(given, program, at=[Stimulus(f"{time_us} us", "V.E.ASYNC", 1)]), "message")
        for time_us in (3_000, 5_000)
    ]
    assert said == [["6 message 1"], ["6 message 0"]]


def test_random_times_are_the_same_each_time(tmp_path: Path) -> None:
    """The same seed gives the same run."""
    load = LOAD.replace("task_rnd = 600", "task_rnd = { uniform = [0, 900] }")
    load = "seed = 7\n" + load.replace("block = 1", "block = 500")
    program = "".join(f"N{n} G01 X{n / 1000} F6000\n" for n in range(1, 40)) + "M30\n"
    first, second = (run(schedule(tmp_path, LIST, load), program) for _ in range(2))
    assert [str(event) for event in first.events] == [str(event) for event in second.events]
    assert rows(first) == rows(second)
    assert first.starved


def test_the_machines_own_list_as_the_schedule(tmp_path: Path) -> None:
    """Named by --rtconf it gives the time; its mistake is reported once."""
    machine = two_channels(tmp_path, "schedule.context.geo 7")
    (machine / "rtconf.lis").write_text(with_lines(LIST, "windows_time 999"), "utf-8")
    (tmp_path / "load.toml").write_text(LOAD, "utf-8")
    plain = Controller(machine)
    given = open_schedule(machine / "rtconf.lis", tmp_path / "load.toml")
    paced = Controller(machine, given)
    assert sorted(one.id for one in paced.diagnostics) == sorted(
        one.id for one in plain.diagnostics
    )
    assert 260102 in [one.id for one in paced.diagnostics]


def test_a_list_of_the_machine_alone_gives_no_time_away() -> None:
    """The list that the start-up list names says how long a tick is, and no more."""
    assert Controller().run(NcText("a.nc", "N10 G04 X0.001\nM30\n")).ticks == 2


TWO_CHANNELS = Path(__file__).parent.parent / "runs" / "two_channels" / "machine"
DWELLS = "N10 G04 X0.001\nN20 G04 X0.001\nN30 G04 X0.001\nM30\n"


def two_channels(folder: Path, *lines: str) -> Path:
    """A machine of two channels; lines for the list of the second one."""
    machine = folder / "machine"
    shutil.copytree(TWO_CHANNELS, machine)
    channel = machine / "kanal2.lis"
    channel.write_text("\n".join([*lines, channel.read_text("utf-8")]), "utf-8")
    return machine


def test_contexts_of_channels(tmp_path: Path) -> None:
    """P-RTCF-00017, P-CHAN-00411: each channel is decoded by the thread of its context.

    That of context 2 comes in each fifth NC cycle: one block in the ticks 0, 5, 10. A context
    without a thread (260102) takes all of them.
    """
    second = [
        "thread[2].name SLOW",
        "thread[2].cycle 5000",
        "thread[2].priority 100",
        "thread[2].context_info 2",
        "thread[2].function[0].name task_rnd",
    ]
    load = LOAD.replace("600", "300").replace("block = 1", "block = 300")
    given = schedule(tmp_path, with_lines(LIST, *second), load)
    program = NcText("dwells.nc", DWELLS)
    machine = two_channels(tmp_path, "schedule.context.sda 2")
    one = Controller(machine, given).run(program, channels={2: [program]})
    assert [(found.channel, found.first_tick, found.ticks) for found in one.starved] == [
        (2, 1, 4),
        (2, 6, 4),
        (2, 11, 4),
    ]
    shutil.rmtree(machine)
    machine = two_channels(tmp_path, "schedule.context.sda 3")
    other = Controller(machine, given)
    assert [found.id for found in other.diagnostics if found.id == 260102]
    assert other.run(program, channels={2: [program]}).state == "ended"


def test_channels_share_their_decoder(tmp_path: Path) -> None:
    """600 µs for two channels: 300 for each, a block in each tick; alone one has two."""
    given = schedule(tmp_path, LIST, LOAD.replace("block = 1", "block = 300"))
    program = NcText("empty.nc", "N10 V.P.A = 1\nN20 V.P.B = 1\nN30 V.P.C = 1\nM30\n")
    both = Controller(two_channels(tmp_path), given).run(program, channels={2: [program]})
    assert events(both, "end") == ["3 CH1 end empty.nc", "3 CH2 end empty.nc"]
    alone = Controller(tmp_path / "machine", given).run(program)
    assert events(alone, "end") == ["1 CH1 end empty.nc"]
