# SPDX-License-Identifier: MIT
"""Axes and spindles that follow others: ``#AX LINK``, and gantries of the lists.

``docs/conformance/couplings.md`` says what is decided. In the machine X Y Z U V A B are the axes of
the channel; U has lower limits than the others, Y8 follows Y forever, 5 mm beside it. S, S2 and S3
are spindles; group 0 of the list is U = X, S2 = S.
"""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest
from support.coupled_axes import FOLDER, MACHINE, numbers, path_of, run
from support.insides import machine_of
from support.random_seeds import each_seed

from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.messages import Collector
from nctakt.nc.parse.parser import parse
from nctakt.nc.parse.printer import print_statement
from nctakt.nc.source import Source
from nctakt.run.access.stimuli import Stimulus
from nctakt.run.controller import Controller, NcText

# --- what follows, and how ------------------------------------------------------------------------


def test_a_slave_goes_the_way_of_its_master() -> None:
    """From where both are at rest, in each tick."""
    found = run(
        "G01 X10 U3 F6000",
        "#SET AX LINK [1, U=X]",
        "#ENABLE AX LINK [1]",
        "X50",
        "G02 X70 I10 F3000",
        "#DISABLE AX LINK [1]",
        "G01 X80",
    )
    assert numbers(found) == []
    x, u = path_of(found, "X"), path_of(found, "U")
    coupled = (x > 10.0) & (x <= 70.0)
    assert (u[coupled] == 3.0 + (x[coupled] - 10.0)).all()
    assert u[-1] == 63.0


def test_factors_and_several_pairs() -> None:
    """``-1, 2`` goes half the way in the other direction; numbers of axes with NBR."""
    found = run(
        "#AX LINK NBR [2, [4=1, -1, 2], 7=6]",
        "#AX LINK ON [2]",
        "G01 X10 A30 F6000",
        "#AX LINK OFF ALL",
    )
    assert numbers(found) == []
    assert (path_of(found, "U") == -0.5 * path_of(found, "X")).all()
    assert (path_of(found, "B") == path_of(found, "A")).all()
    assert path_of(found, "B")[-1] == 30.0


def test_programs_read_slaves() -> None:
    """V.A.ABS and V.A.PROG as after each block, V.G.AX_LINK."""
    found = run(
        '#MSG ["%d %d", V.G.AX_LINK.NR, V.G.AX_LINK.ACTIVE]',
        "#AX LINK [7, [U=X, 2, 1]]",
        "#AX LINK ON [7]",
        "G01 X10 F6000",
        '#MSG ["%d %d", V.G.AX_LINK.NR, V.G.AX_LINK.ACTIVE]',
        '#MSG ["%g %g %g", V.A.ABS.U, V.A.PROG.U, V.A.ACS.ABS.U]',
        "#AX LINK OFF",
        '#MSG ["%d %d", V.G.AX_LINK.NR, V.G.AX_LINK.ACTIVE]',
        "G91 U1",
        '#MSG ["%g", V.A.ABS.U]',
    )
    assert numbers(found) == []
    texts = [one.text for one in found.messages]
    assert texts == ["0 0", "7 1", "20 20 20", "7 0", "21"]


def test_masters_keep_the_limits_of_their_slaves() -> None:
    """U may go 100 mm/s with 800 mm/s²; X alone is faster."""
    lines = ("G00 X50", "G01 X0 F60000")
    alone, coupled = run(*lines), run("#AX LINK ON", *lines)
    assert np.abs(np.diff(path_of(alone, "X"))).max() > 0.15
    half = run("#AX LINK [1, [U=X, 1, 2]]", "#AX LINK ON [1]", *lines)
    for found, share in ((coupled, 1.0), (half, 0.5)):
        speed = np.diff(path_of(found, "U")) / 0.001
        assert np.abs(speed).max() == pytest.approx(100.0, rel=1e-6) or share < 1.0
        assert np.abs(speed).max() <= 100.0 * (1 + 1e-9)
        assert np.abs(np.diff(speed)).max() <= 0.8 * (1 + 1e-6)


def test_software_limits_of_slaves() -> None:
    """At the ends of lines and within arcs; the list has none for X that were lower."""
    limits = ("G99 U20", "#AX LINK ON")
    assert numbers(run(*limits, "G01 X20 F6000")) == []
    assert numbers(run(*limits, "G01 X21 F6000")) == [901885]
    assert numbers(run(*limits, "G01 X18 F6000", "G03 Y10 J5")) == [901885]
    assert numbers(run(*limits, "G01 X15 F6000", "G03 Y10 J5")) == []


def test_realtime_cycles_see_slaves() -> None:
    """RC-304: ACS of the slave, and its state while its master moves."""
    found = run(
        "#RT CYCLE [ID=1 SCOPE=PROG]",
        "$IF [V.RTA.ACS.ACT_POS.U >= 5] && [V.RTA.ACS.CMD_POS.U == 10]",
        "M26",
        "$ENDIF",
        "#RT CYCLE END",
        "#AX LINK ON",
        "G01 X10 F6000",
    )
    assert numbers(found) == []
    u = path_of(found, "U")
    fired = next(event.tick for event in found.events if event.kind == "fired")
    assert u[fired - 1] >= 5.0 > u[fired - 2]


def test_coupled_axes_take_no_motion_of_their_own() -> None:
    """21481, for master and slave; the gantry's slave, too."""
    for axis in "XU":
        found = run(
            "#AX LINK ON",
            "#RT CYCLE [ID=1 SCOPE=PROG]",
            f"{axis}[INDP G90 POS=5 FEED=1000]",
            "#RT CYCLE END",
            "G04 0.1",
        )
        assert numbers(found) == [21481], axis


def test_spindles_get_the_jobs_of_their_master() -> None:
    found = run(
        "#AX LINK [1, S2=S, S3=S]",
        "#AX LINK ON [1]",
        "M3 S300",
        "G04 0.5",
        "#AX LINK OFF",
        "M5",
        "G04 0.5",
        "S2[M5]",
        "G04 0.5",
        signals=["S.SPEED", "S2.SPEED", "S3.SPEED"],
    )
    assert numbers(found) == []
    assert found.trace is not None
    one, two, three = (np.asarray(found.trace[f"{n}.SPEED"].tolist()) for n in ("S", "S2", "S3"))
    assert (one[:500] == two[:500]).all()
    assert (one[:500] == three[:500]).all()
    assert one[500] > 0.0
    assert one[-1] == two[-1] == 0.0
    assert three[-1] > two.max() > one.max()


# --- how long ------------------------------------------------------------------------------------


def changed(tmp_path: Path, entry: str) -> Machine:
    """The machine with another entry in its channel list."""
    for file in FOLDER.iterdir():
        text = file.read_text()
        if file.name == "kanal.lis":
            text = text.replace("Ende", f"{entry}\nEnde")
        (tmp_path / file.name).write_text(text)
    return load_machine(tmp_path)


def test_groups_outlive_programs_and_couplings_do_not() -> None:
    controller = Controller(MACHINE)
    assert numbers(run("#AX LINK [3, V=Y]", "#AX LINK ON [3]", "Y1", controller=controller)) == []
    found = run("G01 Y5 F6000", controller=controller)
    assert path_of(found, "V")[-1] == 1.0
    found = run("#AX LINK ON [3]", "G01 Y6 F6000", controller=controller)
    assert path_of(found, "V")[-1] == 2.0


def test_a_list_can_keep_couplings_after_the_end(tmp_path: Path) -> None:
    """P-CHAN-00105."""
    machine = changed(tmp_path, "synchro_data.preserve_coupling_after_prog_end 1")
    controller = Controller(machine)
    run("#AX LINK ON", "G01 X1 F6000", controller=controller)
    found = run("G01 X5 F6000", "#AX LINK OFF", controller=controller)
    assert path_of(found, "U")[-1] == 5.0
    found = run("G01 X9 F6000", controller=controller)
    assert path_of(found, "U")[-1] == 5.0


@pytest.mark.parametrize("keeps", [False, True])
def test_a_reset_releases(tmp_path: Path, keeps: bool) -> None:
    """P-CHAN-00104: the next program couples again what the reset has released."""
    machine = changed(tmp_path, f"synchro_data.restore_coupling_after_reset {int(keeps)}")
    controller = Controller(machine)
    controller.start(NcText("part.nc", "#AX LINK ON\nG01 X100 F6000\nM30\n"))
    controller.step(300)
    controller.reset()
    controller.step(500)
    x, u = (controller.read(f"V.RTA.ACS.ACT_POS.{axis}") for axis in "XU")
    assert x == u
    assert 0.0 < x < 100.0
    found = run("G01 X0 F6000", controller=controller)
    assert numbers(found) == []
    assert path_of(found, "U")[-1] == (0.0 if keeps else u)


def test_the_way_back_keeps_the_coupling() -> None:
    """MO-7: forward, then backward: the history begins where the axes were coupled."""
    switch = "HLI.BACKWARD_MOTION"
    back = [Stimulus("400 ms", switch, 1), Stimulus("1500 ms", switch, 0)]
    found = run("G01 X20 F6000", "#AX LINK ON", "X60", at=back)
    assert numbers(found) == []
    x, u = path_of(found, "X"), path_of(found, "U")
    coupled = np.flatnonzero(u)
    assert (np.diff(x) < 0).any()
    assert (u[coupled] == x[coupled] - 20.0).all()
    assert x[coupled].min() >= 20.0


# --- gantries ------------------------------------------------------------------------------------


def test_a_gantry_of_the_lists_follows_forever() -> None:
    """P-AXIS-00070, 00073: also when the axis moves on its own, and when it is homed."""
    program = (
        "G01 Y10 F6000",
        "#RT CYCLE [ID=1 SCOPE=PROG]",
        "Y[INDP G90 POS=30 FEED=1000]",
        "#RT CYCLE END",
        "G04 2",
        "#RT CYCLE DELETE [ID=1]",
        '#MSG ["%g", V.A.ABS.Y]',
        "G74 Y1",
        "G01 Y3",
    )
    controller = Controller(MACHINE)
    assert MACHINE.axes[7].gantry.offset == 5.0
    found = run(*program, controller=controller, signals=["Y.ACS.ACT_POS"])
    assert numbers(found) == []
    assert [one.text for one in found.messages] == ["30"]
    axes = machine_of(controller).axes
    assert list(axes.positions())[7] == list(axes.positions())[1] + 5.0


@pytest.mark.parametrize("where", ["list", "program"])
def test_drives_that_are_too_far_apart(tmp_path: Path, where: str) -> None:
    """901879: an obstacle holds the slave back; a reset releases that of a program."""
    entry, slave = "antr.simu.fixed_stop 80000", "v5.lis"
    if where == "list":
        entry, slave = f"{entry}\nkenngr.gantry_max_diff_resetable 5000", "y8.lis"
    for file in FOLDER.iterdir():
        text = file.read_text()
        if file.name == slave:
            text = text.replace("Ende", f"{entry}\nEnde")
        (tmp_path / file.name).write_text(text)
    controller = Controller(load_machine(tmp_path))
    lines = ["#AX LINK [1, [V=Y, G, 0.5, 2]]", "#AX LINK ON [1]"] if where == "program" else []
    found = run(*lines, "G01 Y20 F6000", controller=controller)
    assert numbers(found) == [901879]
    y = path_of(found, "Y")
    stop = 8.5 if where == "program" else 3.5
    assert stop < y[-1] < stop + 6.0
    controller.reset()
    again = numbers(run("G01 Y1 F6000", controller=controller))
    assert again == ([] if where == "program" else [901879])


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"y8.lis": "kenngr.gantry_ax_nr 99"}, [70124]),
        ({"y8.lis": "kenngr.gantry_ax_nr 8"}, [70124]),
        ({"v5.lis": "kenngr.gantry_ax_nr 1"}, [901886]),
        ({"a6.lis": "kenngr.achs_mode 4", "y8.lis": "kenngr.gantry_ax_nr 6"}, [70202]),
        ({"y8.lis": "getriebe[0].dynamik.a_max 100"}, [70205]),
        ({"y8.lis": "getriebe[0].dynamik.vb_max 20000"}, [901890]),
        ({"y8.lis": "kenngr.swe_pos 50000"}, [901890]),
        ({"kanal.lis": "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_slave 5"}, [20438]),
        (
            {
                "kanal.lis": "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_slave 5\n"
                "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_master 5"
            },
            [20440],
        ),
        (
            {
                "kanal.lis": "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_slave 4\n"
                "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_master 2"
            },
            [20441],
        ),
        (
            {
                "kanal.lis": "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_slave 5\n"
                "synchro_data.koppel_gruppe[0].paar[2].log_achs_nr_master 4"
            },
            [20442],
        ),
    ],
)
def test_wrong_lists(tmp_path: Path, files: dict[str, str], expected: list[int]) -> None:
    for file in FOLDER.iterdir():
        text = file.read_text()
        if file.name in files:
            key = files[file.name].split()[0]
            text = "\n".join(line for line in text.split("\n") if not line.startswith(key))
            text = text.replace("Ende", f"{files[file.name]}\nEnde")
        (tmp_path / file.name).write_text(text)
    machine = load_machine(tmp_path)
    found = [one.id for one in machine.diagnostics if one.severity.name != "NOTE"]
    assert found == expected


# --- what is wrong -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["#AX LINK [1, Y=X]", "#AX LINK ON [1]"], [20467]),
        (["#AX LINK [1, A=X]", "#AX LINK ON [1]"], [20468]),
        (["#AX LINK [1, S2=X]"], [20468]),
        (["#AX LINK [1, U=U]"], [20475]),
        (["#AX LINK [1, U=X, U=Y]"], [20476]),
        (["#AX LINK [1, U=X, V=U]"], [20477]),
        (["#AX LINK [0, U=X]"], [20461]),
        (["#AX LINK [100, U=X]"], [20461]),
        (["#AX LINK ON [1.5]"], [20461]),
        (["#AX LINK ON [3]"], [901880]),
        (["#AX LINK OFF [3]"], [901880]),
        (["#AX LINK OFF"], []),
        (["#AX LINK OFF ALL"], []),
        (["#AX LINK [1, [U=X, 1]]"], [21110]),
        (["#AX LINK [1, [U=X, 0, 1]]"], [21077]),
        (["#AX LINK [1, [U=X, 1, 0]]"], [21077]),
        (["#AX LINK [1, Q=X]"], [901881]),
        (["#AX LINK NBR [1, 4=9]"], [901881]),
        (["#AX LINK [1]"], [900233]),
        (["#AX LINK [1, U]"], [900233]),
        (["#AX LINK"], [900233]),
        (["#AX LINK ON [1, 2]"], [900233]),
        (["#AX LINK ON", "#AX LINK [1, V=U]", "#AX LINK ON [1]"], [21285]),
        (["#AX LINK ON", "#AX LINK [1, X=V]", "#AX LINK ON [1]"], [21284]),
        (["#AX LINK ON", "#AX LINK [1, U=Y]", "#AX LINK ON [1]"], [21283]),
        (["#AX LINK ON", "#AX LINK [2, V=Y]", "#AX LINK ON [2]", "#AX LINK [2, V=Z]"], [20472]),
        (["#AX LINK ON", "#AX LINK ON"], []),
        (["#AX LINK ON", "G74 Z1"], [20137]),
        (["#AX LINK ON", "#PUT AX [X]"], [20545]),
        (["#AX LINK ON", "#SET AX [X,1,0] [Y,2,1] [Z,3,2] [U,4,5]"], [21312]),
        (["#AX LINK ON", "#PUT AX [V]"], []),
        (["#AX LINK ON", "G01 X5 U5 F600"], [901883]),
        (["#AX LINK ON", "S2[M3 S100]"], [901883]),
        (["#AX LINK [1, S=S2]", "#AX LINK ON [1]"], [21347]),
        (["#AX LINK ON", "#MAIN SPINDLE [S2]"], [21347]),
        (["#AX LINK ON", "G96 S100"], [901884]),
        (["V.G.AX_LINK.NR = 3"], [20100]),
    ],
)
def test_what_is_refused(lines: list[str], expected: list[int]) -> None:
    assert numbers(run(*lines)) == expected


def test_a_group_has_at_most_fifteen_pairs() -> None:
    pairs = ", ".join(["U=X"] * 16)
    assert 901882 in numbers(run(f"#AX LINK [1, {pairs}]"))


def test_forms_are_printed_as_they_are_read() -> None:
    for line in (
        "#SET AX LINK [1, U = X, [V = Y, -1, 2]]",
        "#AX LINK NBR [P1, 4 = 1, [7 = P2, G, 0.01, 0.25]]",
        "#AX LINK ON [P1 + 1]",
    ):
        (statement,) = parse(Source("part.nc", [line]), Collector())
        assert [text.strip() for text in print_statement(statement)] == [line]


# --- at random ------------------------------------------------------------------------------------


@each_seed(6, 2)
def test_random_programs(seed: int) -> None:
    """Slaves follow in each tick, whatever the path does, and stay within their limits."""
    generator = random.Random(seed)
    factor = generator.choice((1.0, -1.0, 0.5, -2.0))
    lines = [f"#AX LINK [1, [U=X, {2 * factor:g}, 2], V=Y]", "#AX LINK ON [1]", "F6000"]
    for _ in range(12):
        x, y = generator.uniform(-40, 40), generator.uniform(-40, 40)
        kind = generator.randrange(5)
        if kind == 0:
            lines.append(f"G00 X{x:.3f} Y{y:.3f}")
        elif kind == 1:
            lines.append(f"G0{generator.choice('23')} X{x:.3f} Y{y:.3f} R120")
        elif kind == 2:
            lines.append(f"G01 G261 X{x:.3f} Y{y:.3f} Z{x / 4:.3f}")
        else:
            lines.append(f"G01 X{x:.3f} Y{y:.3f} F{generator.randrange(1000, 20000)}")
    at = [Stimulus(f"{100 * i} ms", "HLI.OVERRIDE", generator.choice((0.3, 1.0))) for i in range(9)]
    found = run(*lines, at=at)
    assert numbers(found) == []
    x, u, y, v = (path_of(found, axis) for axis in "XUYV")
    assert (u == 0.0 + factor * (x - 0.0)).all()
    assert (v == y).all()
    speed = np.diff(u) / 0.001
    assert np.abs(speed).max() <= 100.0 * (1 + 1e-6)


def test_the_example_does_what_its_comments_say() -> None:
    """Two heads: mirrored, then to the same side; the right side of the bridge follows the left."""
    folder = Path(__file__).parents[2] / "examples" / "coupled"
    controller = Controller(load_machine(folder / "machine"))
    found = controller.run(folder / "mirror.nc", signals=["Y.ACS.ACT_POS", "Y2.ACS.ACT_POS"])
    assert numbers(found) == []
    one, other = path_of(found, "Y"), path_of(found, "Y2")
    mirrored = np.flatnonzero(np.abs(one + other - 200.0) < 1e-9)
    assert one[mirrored].max() > 79.9
    assert (one[-1], other[-1]) == (60.0, 220.0)
