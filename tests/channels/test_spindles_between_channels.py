# SPDX-License-Identifier: MIT
"""A spindle whose axis one channel gives and another one fetches (``S[PUTAX]``, ``S[CALLAX]``).

Sources: programming manual, pages 208235275 (PUTAX, CALLAX) and 206987659 (#CALL AX), and page
287462539: a spindle that two channels list. ``docs/conformance/axis-exchange.md`` has the rest.
"""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest
from support.random_seeds import each_seed
from support.run_folders import changed_machine

from nctakt.cli import main
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText
from nctakt.session.session import Session

#: Channel 1 has X (1), Y (2), Z (3) and the spindle S (5, mode 0x204), channel 2 has X (4).
FOLDER = Path(__file__).parent / "spindle_machine"
MACHINE = load_machine(FOLDER)
SIGNALS = ["CH1.S.SPEED", "CH1.S.POSITION", "CH2.X.ACS.ACT_POS"]
SHARED = [
    "spdl_anzahl 1",
    "main_spindle_ax_nr 5",
    "main_spindle_name S",
    "spindel[0].bezeichnung S1",
    "spindel[0].log_achs_nr 5",
]


@pytest.fixture(scope="module", name="shared")
def fixture_shared(tmp_path_factory: pytest.TempPathFactory) -> Machine:
    """Both channels list the spindle."""
    folder = tmp_path_factory.mktemp("shared") / "machine"
    return load_machine(changed_machine({"kanal2.lis": SHARED}, folder, base=FOLDER))


def text(name: str, *lines: str) -> NcText:
    """A main program of these lines."""
    return NcText(name, "\n".join([f"%{name}", *lines, "M30", ""]))


def run(
    one: list[str],
    two: list[str],
    controller: Controller | None = None,
    signals: list[str] = SIGNALS,
) -> Run:
    """A run of both channels."""
    controller = controller or Controller(MACHINE)
    programs = {2: [text("two", *two)]}
    return controller.run(text("one", *one), channels=programs, ticks=9000, signals=signals)


def numbers(found: Run) -> list[int]:
    """The numbers of all errors and warnings."""
    return [one.id for one in found.diagnostics if one.severity.name != "NOTE"]


def exchanges(found: Run) -> list[tuple[int, str]]:
    """Channel and text of each event of the exchange."""
    return [(one.channel, one.text) for one in found.events if one.kind == "exchange"]


def at_end(found: Run, signal: str) -> float:
    """The value of a signal at the end of a run."""
    assert found.trace is not None
    return float(found.trace[signal][-1])


GIVES = ["M19 S.POS30 S60", "S[PUTAX]", "G04 0.1", "S[CALLAX]", "M19 S.POS100 S60"]
FETCHES = [
    "#CALL AX [C, 5, 3]",
    "P1=V.A.ABS.C",
    '#MSG ["%f", P1]',
    "G01 C90 X10 F600",
    "#PUT AX [C]",
]
EVENTS = [
    (2, "5 awaited CH1"),
    (1, "S given"),
    (2, "5 taken"),
    (1, "S awaited CH2"),
    (2, "5 given"),
    (1, "S taken"),
]


def test_another_channel_fetches_the_axis_of_a_spindle() -> None:
    """C of channel 2 begins at the angle of the spindle, which takes its axis again at 90°."""
    found = run(GIVES, FETCHES)
    assert numbers(found) == []
    assert exchanges(found) == EVENTS
    assert [one.text for one in found.messages] == ["30.000000"]
    assert at_end(found, "CH2.X.ACS.ACT_POS") == 10.0
    assert at_end(found, "CH1.S.POSITION") == 100.0
    assert found.trace is not None
    taken = next(i for i, one in enumerate(found.events) if one.text == "S taken")
    tick = found.events[taken].time_us // 1000 - 1
    assert found.trace["CH1.S.POSITION"][tick] == 90.0


def test_the_spindle_turns_with_its_axis_in_the_same_tick() -> None:
    """While channel 2 moves C, the spindle of channel 1 shows each command of it."""
    signals = ["CH1.S.POSITION", "CH2.V.RTA.ACS.ACT_POS.X", "CH2.X.ACS.ACT_POS"]
    found = run(
        GIVES,
        ["#CALL AX [C, 5, 3]", "G01 C90 X60 F600", "#PUT AX [C]"],
        signals=signals[:1] + signals[2:],
    )
    assert found.trace is not None
    angle, way = found.trace["CH1.S.POSITION"], found.trace["CH2.X.ACS.ACT_POS"]
    moving = (way > 0.0) & (way < 60.0)
    assert moving.any()
    assert abs(angle[moving] - 30.0 - way[moving]).max() < 1e-9


def test_a_spindle_of_two_lists_goes_from_one_channel_to_the_other(shared: Machine) -> None:
    """S[CALLAX] of channel 2 waits for S[PUTAX] of channel 1; the angle goes with the axis."""
    found = run(
        [
            "M19 S.POS30 S60",
            "S[PUTAX]",
            "#SIGNAL SYN [ID=1 CH=2]",
            "#WAIT SYN [ID=2 CH=2]",
            "S[CALLAX]",
        ],
        [
            "S[CALLAX]",
            "#WAIT SYN [ID=1 CH=1]",
            "M19 S.POS100 S60",
            "S[PUTAX]",
            "#SIGNAL SYN [ID=2 CH=1]",
        ],
        Controller(shared),
        ["CH1.S.POSITION", "CH2.S.POSITION"],
    )
    assert numbers(found) == []
    assert exchanges(found) == [
        (2, "S awaited CH1"),
        (1, "S given"),
        (2, "S taken"),
        (2, "S given"),
        (1, "S taken"),
    ]
    assert at_end(found, "CH2.S.POSITION") == 100.0
    assert at_end(found, "CH1.S.POSITION") == 100.0


@pytest.mark.parametrize(
    ("one", "two", "expected"),
    [
        (["G04 0.1"], ["#CALL AX [C, 5, 3]"], [901808, 901506]),
        (["M3 S60", "S[PUTAX]"], ["G04 0.1"], [60137]),
        (["S[PUTAX]", "G04 0.1", "S[CALLAX]"], ["#CALL AX [C, 5, 3]"], [901506]),
        (["S[PUTAX]", "G04 0.1", "M3 S60"], ["#CALL AX [C, 5, 3]"], [902720]),
        (["#CAX [S, C]", "G04 0.5", "#CAX OFF"], ["#CALL AX [C, 5, 3]"], [901808, 901506]),
    ],
)
def test_what_nobody_gives_and_what_is_refused(
    one: list[str], two: list[str], expected: list[int]
) -> None:
    assert numbers(run(one, two)) == expected


def test_the_error_says_who_has_the_axis_and_what_gives_it() -> None:
    found = run(["G04 0.1"], ["#CALL AX [C, 5, 3]"])
    (error,) = [one for one in found.diagnostics if one.id == 901506]
    assert "axis 5, which channel 1 has" in error.headline()
    assert "S[PUTAX] in channel 1" in error.render("en")
    found = run(["S[PUTAX]", "G04 0.1", "S[CALLAX]"], ["#CALL AX [C, 5, 3]"])
    (error,) = [one for one in found.diagnostics if one.id == 901506]
    assert error.span is not None
    assert error.span.line == 4
    assert "axis 5, which channel 2 has" in error.headline()
    assert "#PUT AX in channel 2" in error.render("en")


def test_a_reset_waits_no_more() -> None:
    controller = Controller(MACHINE)
    programs = {2: [text("two", "#CALL AX [C, 5, 3]", "#WAIT FOR V.G.BLOCK_NR < 0")]}
    found = controller.run(
        text("one", "S[PUTAX]", "G04 0.1", "S[CALLAX]"),
        channels=programs,
        ticks=2000,
        at=[("0.5 s", "CH1.HLI.RESET", 1)],
    )
    assert exchanges(found)[-1] == (1, "S awaited CH2")
    assert controller.read("CH1.HLI.STATE") == 0.0


def test_the_next_program_takes_the_axis_again_and_waits_for_it() -> None:
    """As with axes: it begins with those of the list (P-CHAN-00460 = 0)."""
    controller = Controller(MACHINE)
    run(["S[PUTAX]"], ["#CALL AX [C, 5, 3]", "G01 C45 F6000"], controller)
    found = run(["M19 S.POS50 S60"], ["G04 0.2"], controller)
    assert numbers(found) == []
    assert exchanges(found)[-2:] == [(2, "5 given"), (1, "S taken")]
    assert at_end(found, "CH1.S.POSITION") == 50.0


def test_going_back_over_an_exchange_and_forward_again() -> None:
    one, two = text("one", *GIVES), text("two", *FETCHES)
    with Session(one, channels={2: [two]}, machine=FOLDER, signals=SIGNALS) as session:
        session.run()
        end = session.tick
        events = [one.text for one in session.events(0, end)[0] if one.kind == "exchange"]
        assert events == [what for _, what in EVENTS]
        position = session.read("CH1.S.POSITION")
        for tick in (end // 2, 50, end):
            session.go_to(tick)
        assert session.read("CH1.S.POSITION") == position
        assert [one.text for one in session.events(0, end)[0] if one.kind == "exchange"] == events


def test_a_tape_of_an_exchange_is_replayed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("one.nc").write_text("\n".join(["%one", *GIVES, "M30", ""]), "utf-8")
    Path("two.nc").write_text("\n".join(["%two", *FETCHES, "M30", ""]), "utf-8")
    with Session("one.nc", channels={2: ["two.nc"]}, machine=str(FOLDER)) as session:
        session.run()
        session.save("exchange.tape")
    assert main(["replay", "exchange.tape", "--root", "/"]) == 0
    assert "error" not in capsys.readouterr().err


# --- at random ------------------------------------------------------------------------------------


def random_programs(draw: random.Random) -> tuple[list[str], list[str]]:
    """Channel 1 gives the axis of its spindle and wants it back, channel 2 fetches and moves it."""
    one = ["M19 S.POS30 S60"]
    for _ in range(draw.randint(1, 3)):
        one += ["S[PUTAX]", f"G04 {draw.choice((0.0, 0.01, 0.05))}", "S[CALLAX]"]
        one += draw.choice(([], [f"M19 S.POS{draw.randrange(360)} S60"], ["G04 0.03"]))
    if draw.random() < 0.5:
        one.append("S[PUTAX]")
    two = []
    for _ in range(draw.randint(1, 3)):
        two += ["#CALL AX [C, 5, 3]", f"G01 C{draw.randrange(360)} F60000"]
        two += [*draw.choice(([], ["G04 0.02"])), "#PUT AX [C]"]
        two += draw.choice(([], ["G04 0.01"]))
    return one, two


def judged(found: Run) -> set[int]:
    """Follow who has the axis, event by event; return the channels that wait at the end."""
    holder, waiting = 1, set()
    for channel, reported in exchanges(found):
        what = reported.split()[1]
        if what == "awaited":
            assert (holder, reported.split()[2]) == (3 - channel, f"CH{holder}")
            waiting.add(channel)
        elif what == "given":
            assert holder == channel
            holder = 0
        else:
            assert (what, holder) == ("taken", 0)
            holder = channel
            waiting.discard(channel)
    return waiting


@each_seed(compiled=8, plain=3)
def test_random_exchanges_have_one_holder_and_no_step(seed: int) -> None:
    """A wait for something that never comes is reported (901506), no other; the spindle, which
    turns with its axis, never turns farther in a tick than it can at 60000°/min.
    """
    one, two = random_programs(random.Random(seed))
    found = run(one, two)
    waiting = judged(found)
    assert numbers(found) == [901506] * bool(waiting), (one, two)
    assert found.trace is not None
    steps = np.diff(found.trace["CH1.S.POSITION"])
    steps = (steps + 180.0) % 360.0 - 180.0
    assert np.abs(steps).max() <= 1.0 + 1e-9, (one, two)
