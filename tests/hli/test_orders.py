# SPDX-License-Identifier: MIT
"""Orders by the interface: block search, programs, zero offsets (docs/conformance/programs.md)."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from nctakt import Controller, Failure, NcText, Session

TEXT = "N10 G01 X10 F6000\n$FOR P1 = 1, 3, 1\nN20 G91 G01 Y5\n$ENDFOR\nN30 G90 G01 X50\nN40 M30\n"
PROGRAM = NcText("part.nc", TEXT)
SEARCH = "gpCh[0]^.decoder_mc_control.block_search_"
PRESENT = "gpCh[0]^.head.plc_present_w"


def order_by_hmi(controller: Controller) -> None:
    """Ask the control units for it."""
    controller.write(f"ask {SEARCH}number", 30)
    controller.write(f"ask {SEARCH}type", 4)


def order_by_plc(controller: Controller) -> None:
    """Command it in the control units."""
    controller.write(PRESENT, 1)
    for name, value in (("number", 30), ("type", 4)):
        controller.write(f"{SEARCH}{name}.enable_w", 1)
        controller.write(f"{SEARCH}{name}.command_w", value)


def order_by_name(controller: Controller) -> None:
    """Use the operator's side."""
    controller.hli.search_block = 30


@pytest.mark.parametrize("order", [order_by_hmi, order_by_plc, order_by_name])
def test_a_program_begins_where_the_interface_orders_it(
    order: Callable[[Controller], None],
) -> None:
    """As with --from-block: to X10 Y15, where N30 begins, and then N30."""
    plain = Controller().run(PROGRAM, from_block=30)
    controller = Controller()
    order(controller)
    assert controller.hli.search_block == 30
    result = controller.run(PROGRAM)
    assert (result.state, result.virtual_time_us) == ("ended", plain.virtual_time_us)
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 50


def test_the_order_holds_until_it_is_taken_back() -> None:
    """Each program that begins is searched, as block skip holds for each one."""
    searched = Controller().run(PROGRAM, from_block=30).virtual_time_us
    whole = Controller().run(PROGRAM).virtual_time_us
    controller = Controller()
    controller.hli.search_block = 30
    assert controller.run(PROGRAM).virtual_time_us == searched
    controller = Controller()
    controller.hli.search_block = 30
    controller.hli.search_block = 0
    assert controller.run(PROGRAM).virtual_time_us == whole


@pytest.mark.parametrize(("passes", "begin"), [(0, 0.0), (1, 0.0), (2, 5.0), (3, 10.0)])
def test_the_pass_of_a_loop_at_which_it_begins(passes: int, begin: float) -> None:
    """N20 is passed three times, from Y0, Y5 and Y10 on; X10 is reached where it begins."""
    controller = Controller()
    controller.write("HLI.SEARCH_PASS", passes)
    controller.hli.search_block = 20
    run = controller.run(PROGRAM, signals=["X.ACS.ACT_POS", "Y.ACS.ACT_POS"])
    axes = (run.trace[f"{axis}.ACS.ACT_POS"].tolist() for axis in "XY")
    at_x10 = [y for x, y in zip(*axes, strict=True) if x == 10.0]
    assert 0.0 <= at_x10[0] - begin < 0.2  # of the tick that reaches it, N20 has the rest


def test_a_pass_that_never_comes_is_an_error() -> None:
    controller = Controller()
    controller.hli.search_block = 20
    controller.write("HLI.SEARCH_PASS", 4)
    result = controller.run(PROGRAM)
    assert result.state == "error"
    assert "901730" in str(result.diagnostics[-1])
    assert "N20, pass 4" in str(result.diagnostics[-1])


@pytest.mark.parametrize(
    "name", ["HLI.SEARCH_TYPE", f"{SEARCH}type.command_w", f"ask {SEARCH}type"]
)
@pytest.mark.parametrize("kind", [1, 3, 5])
def test_a_search_that_is_not_simulated_is_refused(name: str, kind: int) -> None:
    controller = Controller()
    with pytest.raises(Failure, match="902850") as failure:
        controller.write(name, kind)
    assert "0, 4" in str(failure.value)
    assert controller.read("HLI.SEARCH_TYPE") == 0


def test_zero_offsets_act_when_a_program_selects_them() -> None:
    """In mm; G54 is the group 1, G55 the group 2 (V.G.NP)."""
    controller = Controller()
    controller.write("V.G.NP[2].V.X", 12.5)
    assert controller.read("v.g.np[2].v.x") == 12.5
    controller.run(NcText("offset.nc", "N10 G55\nN20 G01 X10 F6000\nN30 M30\n"))
    assert controller.read("V.RTA.ACS.ACT_POS.X") == 22.5


@pytest.mark.parametrize(
    ("name", "value", "number"),
    [
        ("V.G.NP[97].V.X", 1.0, 20149),
        ("V.G.NP[1].V.Q", 1.0, 901003),
        ("CH2.V.G.NP[1].V.X", 1.0, 900749),
        ("V.G.NP[1].V.X", "text", 900543),
        ("V.G.NP[1].V.X", float("inf"), 50893),
    ],
)
def test_zero_offsets_that_are_not_there(name: str, value: float | str, number: int) -> None:
    with pytest.raises(Failure, match=str(number)):
        Controller().write(name, value)


def test_orders_are_inputs_of_a_session() -> None:
    """Going back takes them back, and running again brings them again."""
    with Session(PROGRAM) as session:
        session.step(5)
        session.write({"V.G.NP[3].V.Y": 4.0})
        session.write({"HLI.SEARCH_BLOCK": 30})
        session.step(5)
        assert session.read("V.G.NP[3].V.Y", "HLI.SEARCH_BLOCK") == [4.0, 30]
        session.go_to(3)
        assert session.read("V.G.NP[3].V.Y", "HLI.SEARCH_BLOCK") == [0.0, 0]
        session.go_to(9)
        assert session.read("V.G.NP[3].V.Y", "HLI.SEARCH_BLOCK") == [4.0, 30]
