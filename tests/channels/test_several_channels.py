# SPDX-License-Identifier: MIT
"""Several channels: each has programs, variables, cycles and its own state."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from nctakt.base.failure import Failure
from nctakt.cli import main
from nctakt.lists.machine.machine import load_machine
from nctakt.results.trace.reading import read_trace
from nctakt.results.trace.sinks import file_sink
from nctakt.run.controller import Controller, NcText
from nctakt.run.plcs.plc_view import PlcView

MACHINE = Path(__file__).parent.parent / "runs" / "two_channels" / "machine"
ONE = NcText("one.nc", "%one\nN10 G01 X5 F600\nN20 V.CH.SEEN = 1\nN30 M30\n")
TWO = NcText("two.nc", '%two\nN10 G01 X-2 F600\nN20 #MSG ["there"]\nN30 M30\n')
FAULTY = NcText("faulty.nc", "%faulty\nN10 #RT CYCLE HOLD [ID=9]\nN20 M30\n")
LONG = NcText("long.nc", "%long\nN10 G04 X1\nN20 M30\n")


def test_each_channel_moves_its_own_axis() -> None:
    """Both axes are called X; the names of the signals include the channel."""
    run = Controller(MACHINE).run(ONE, channels={2: [TWO]})
    assert run.state == "ended"
    assert run.programs == ("one.nc", "two.nc")
    assert run.trace is not None
    assert run.trace["CH1.X.ACS.ACT_POS"][-1] == 5.0
    assert run.trace["CH2.X.ACS.ACT_POS"][-1] == -2.0
    ends = [(event.channel, event.text) for event in run.events if event.kind == "end"]
    assert ends == [(2, "two.nc"), (1, "one.nc")]


def test_a_channel_runs_as_it_does_alone() -> None:
    """What the other channel does changes no position and no time."""
    alone = Controller(MACHINE).run(ONE, signals=["CH1.X.ACS.ACT_POS"])
    both = Controller(MACHINE).run(ONE, channels={2: [LONG]}, signals=["CH1.X.ACS.ACT_POS"])
    assert alone.trace is not None
    assert both.trace is not None
    assert list(both.trace["CH1.X.ACS.ACT_POS"])[: alone.ticks] == list(
        alone.trace["CH1.X.ACS.ACT_POS"]
    )


def test_a_program_in_the_second_channel_alone() -> None:
    """Channel 1 has nothing to do: the run ends with channel 2."""
    run = Controller(MACHINE).run(channels={2: [TWO, TWO]})
    assert [event.text for event in run.events if event.kind == "end"] == ["two.nc", "two.nc"]
    assert [message.text for message in run.messages] == ["there", "there"]


def test_names_without_a_channel_are_the_first_ones() -> None:
    """V.CH and V.E of scope CHANNEL are a channel's own, GLOBAL ones are shared (P-EXTV-00004)."""
    controller = Controller(MACHINE)
    controller.write("V.E.OWN", 1.0)
    controller.write("CH2.V.E.OWN", 2.0)
    controller.write("ch2.V.E.SHARED", 7.0)
    controller.write("CH2.V.CH.SEEN", 3.0)
    controller.step()
    names = ("CH1.V.E.OWN", "CH2.V.E.OWN", "V.E.SHARED", "V.CH.SEEN", "CH2.V.CH.SEEN")
    assert [controller.read(name) for name in names] == [1.0, 2.0, 7.0, 0.0, 3.0]


def test_start_step_and_reset_of_one_channel() -> None:
    """A reset of channel 2 leaves the program of channel 1 alone."""
    controller = Controller(MACHINE)
    controller.start(LONG)
    controller.start(LONG, channel=2)
    controller.step(3)
    controller.reset(channel=2)
    assert controller.state == "running"
    controller.step(1000)
    assert controller.state == "ready"
    controller.start(FAULTY, channel=2)
    controller.step(2)
    assert controller.state == "error"
    controller.reset()
    assert controller.state == "ready"


def test_the_operator_of_one_channel() -> None:
    """The HLI of each channel has its own feed hold."""
    controller = Controller(MACHINE)
    controller.write("CH2.HLI.FEED_HOLD", True)
    run = controller.run(ONE, channels={2: [TWO]}, ticks=2000)
    assert run.state == "limit"
    assert [event.channel for event in run.events if event.kind == "end"] == [1]
    assert controller.read("CH2.V.RTA.ACS.ACT_POS.X") == 0.0


def test_a_plc_sees_each_channel() -> None:
    """``hli.of_channel(2)`` is the image of the second channel."""
    seen: list[tuple[object, object]] = []

    class Watch:
        def cycle(self, hli: PlcView) -> None:
            second = hli.of_channel(2)
            second.write("V.E.OWN", 5.0)
            seen.append((hli.read("V.E.OWN"), second.read("V.E.OWN")))
            with pytest.raises(Failure) as caught:
                hli.of_channel(3)
            assert caught.value.diagnostics[0].id == 900749

    Controller(MACHINE).run(ONE, plc=Watch(), ticks=2)
    assert seen == [(0.0, 5.0), (0.0, 5.0)]


def test_each_channel_has_its_own_operator() -> None:
    """What is commanded to the second channel is not the first one's, and what it shows neither."""
    controller = Controller(MACHINE)
    first, second = controller.hli, controller.hli.of_channel(2)
    second.override_pct = 50
    second.feed_hold = True
    assert (first.override_pct, second.override_pct) == (100.0, 50.0)
    assert (first.feed_hold, second.feed_hold) == (False, True)
    controller.select(NcText("a.nc", "G04 1\nM30"), channel=2)
    second.start()
    controller.step(3)
    assert (first.state, second.state) == ("ready", "running")


@pytest.mark.parametrize(
    "ask",
    [
        lambda controller: controller.run(channels={3: [ONE]}),
        lambda controller: controller.run(channels={0: [ONE]}),
        lambda controller: controller.start(ONE, channel=3),
        lambda controller: controller.reset(channel=3),
        lambda controller: controller.read("CH3.V.E.OWN"),
        lambda controller: controller.write("CH0.HLI.START", 1.0),
    ],
    ids=["run", "run 0", "start", "reset", "read", "write"],
)
def test_a_channel_that_there_is_not(ask: Callable[[Controller], object]) -> None:
    """The machine has two."""
    with pytest.raises(Failure) as caught:
        ask(Controller(MACHINE))
    assert [one.id for one in caught.value.diagnostics] == [900749]


def test_mistakes_of_all_channels_are_reported_at_once() -> None:
    """Axis Y belongs to no channel: each program is checked for its own channel."""
    wrong = NcText("wrong.nc", "%wrong\nN10 G01 Y5 F600\nN20 M30\n")
    run = Controller(MACHINE).run(wrong, channels={2: [wrong]})
    assert (run.state, run.ticks) == ("error", 0)
    assert len(run.errors) == 2


@pytest.mark.slow
def test_a_run_that_is_cut_into_ticks_is_the_same_run() -> None:
    """Both channels ask for the decoder at their own times, wherever a run is cut."""
    texts = [
        NcText(name, "%p\n" + "".join(f"N{i} G01 X{i % 7} F{f}\n" for i in range(1, 120)) + "M30\n")
        for name, f in (("a.nc", 3000), ("b.nc", 4500))
    ]
    whole = Controller(MACHINE)
    run = whole.run(texts[0], channels={2: [texts[1]]})
    cut = Controller(MACHINE)
    cut.start(texts[0])
    cut.start(texts[1], channel=2)
    assert run.trace is not None
    for tick in range(run.ticks):
        cut.step()
        for number in (1, 2):
            name = f"CH{number}.V.RTA.ACS.ACT_POS.X"
            assert cut.read(name) == run.trace.at(tick, f"CH{number}.X.ACS.ACT_POS")


@pytest.mark.parametrize("suffix", ["csv", "jsonl"])
def test_traces_keep_the_channel(suffix: str, tmp_path: Path) -> None:
    """Signals and events come back from files with their channel."""
    path = tmp_path / f"t.{suffix}"
    run = Controller(MACHINE).run(ONE, channels={2: [TWO]}, sinks=[file_sink(path)])
    trace = read_trace(path)
    assert run.trace is not None
    assert [signal.name for signal in trace.signals] == [one.name for one in run.trace.signals]
    assert [(one.channel, one.kind, one.text) for one in trace.events] == [
        (one.channel, one.kind, one.text) for one in run.events
    ]


def test_an_axis_belongs_to_one_channel(tmp_path: Path) -> None:
    """Both lists name axis 1: the second channel does without it."""
    for path in MACHINE.iterdir():
        (tmp_path / path.name).write_bytes(path.read_bytes())
    (tmp_path / "kanal2.lis").write_bytes((MACHINE / "kanal1.lis").read_bytes())
    machine = load_machine(tmp_path)
    assert [one.id for one in machine.diagnostics] == [900750]
    assert [len(channel.axes) for channel in machine.channels] == [1, 0]


def test_the_command_line_runs_a_program_in_each_channel(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """``--channel 2 two.nc``; messages and diagnosis data name their channel."""
    monkeypatch.chdir(tmp_path)
    for program in (ONE, TWO):
        Path(program.name).write_text(program.text, "utf-8")
    words = ["run", "one.nc", "--channel", "2", "two.nc", "--machine", str(MACHINE)]
    assert main([*words, "--diagnosis", "d.txt", "--messages", "m.txt"]) == 0
    reported = capsys.readouterr().out
    assert "s  CH2  there\n" in reported
    assert "one.nc, two.nc: ended" in reported
    assert Path("m.txt").read_text("utf-8").endswith("CH2  there\n")
    titles = [line for line in Path("d.txt").read_text("utf-8").splitlines() if "NO.:" in line]
    assert [title[-1] for title in titles] == ["1", "2"]


@pytest.mark.parametrize(
    ("words", "number"),
    [
        (["--channel", "two", "one.nc"], 900752),
        (["--channel", "3", "one.nc"], 900749),
        (["--channel", "2", "absent.nc"], 900500),
    ],
)
def test_wrong_words(
    words: list[str],
    number: int,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """What cannot be used is reported with exit code 2."""
    monkeypatch.chdir(tmp_path)
    Path("one.nc").write_text(ONE.text, "utf-8")
    assert main(["run", *words, "--machine", str(MACHINE)]) == 2
    assert str(number) in capsys.readouterr().err
