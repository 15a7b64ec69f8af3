# SPDX-License-Identifier: MIT
"""The interface by the controller's paths and by attributes, for a PLC in Python."""

from __future__ import annotations

import ast
import inspect

import pytest

from nctakt import Controller, Failure, NcText
from nctakt.hli.plc_entries import AXIS_ALIASES, AXIS_NAMES, CHANNEL_ALIASES, CHANNEL_NAMES
from nctakt.run.access import hli_values
from nctakt.run.plcs.plc_view import PlcView

MOVE = NcText("move.nc", "N10 G01 X100 F6000\nN20 M30\n")
OVERRIDE = "gpCh[0]^.bahn_mc_control.override"


class Reader:
    """Reads elements while the path moves; takes the override over at 50 mm."""

    def __init__(self) -> None:
        self.seen: list[tuple[object, ...]] = []

    def cycle(self, hli: PlcView) -> None:
        """Compare the paths with the attributes."""
        x = "gpCh[0]^.bahn_state.coord_r[0]"
        if hli.axis("X").command_position > 50 and not hli[f"{OVERRIDE}.enable_w"]:
            hli[f"{OVERRIDE}.command_w"] = 500
            hli[f"{OVERRIDE}.enable_w"] = True
        self.seen.append(
            (
                hli[f"{x}.act_position_r"],
                round(10_000 * hli.axis("X").program_position),
                hli["gpCh[0]^.bahn_state.active_feed_r"],
                round(1000 * hli.channel().path_feed),
                hli[f"{x}.axis_name_r.zeichen"],
                hli["gpCh[0]^.bahn_state.program_end_r"],
            )
        )


def test_paths_show_what_attributes_show_in_units_of_the_controller() -> None:
    """0.1 µm and µm/s; half of the speed once the PLC has taken the override over."""
    plc = Reader()
    controller = Controller()
    run = controller.run(MOVE, plc=plc)
    assert run.state == "ended"
    assert all(one[0] == one[1] and one[2] == one[3] for one in plc.seen)
    assert {one[4] for one in plc.seen} == {"X"}
    assert max(one[2] for one in plc.seen) == 100_000
    assert controller.hli.override_pct == 50.0
    assert controller.hli[f"{OVERRIDE}.state_r"] == 500
    controller.hli[f"{OVERRIDE}.enable_w"] = False
    assert controller.hli.override_pct == 100.0


@pytest.mark.parametrize(
    ("path", "value", "number"),
    [
        ("gpCh[0]^.bahn_mc_control.overide.command_w", 1, "902100"),
        ("gpCh[3]^.head.plc_present_w", 1, "902103"),
        ("gpCh[0]^.bahn_mc_control.override", 1, "902104"),
        ("gpCh[0]^.bahn_mc_control.override.state_r", 1, "902105"),
        ("gpCh[0]^.bahn_mc_control.override.command_w", 70_000, "20847"),
        ("gpCh[0]^.bahn_mc_control.override.command_w", "fast", "90"),
    ],
)
def test_what_cannot_be_written_is_refused(path: str, value: object, number: str) -> None:
    with pytest.raises(Failure) as caught:
        Controller().hli[path] = value
    assert str(caught.value).startswith(f"error {number}")


def test_what_nctakt_does_not_compute_is_refused_and_not_0() -> None:
    hli = Controller().hli
    for path in ("gpCh[0]^.bahn_state.covered_distance_r", "gpAx[0]^.lr_state.active_rev_r"):
        with pytest.raises(Failure, match="902109"):
            _ = hli[path]
    assert hli["gpAx[4]^.lr_state.active_rev_r"] == 0


def test_what_has_no_effect_is_a_note_once() -> None:
    controller = Controller()

    class Writer:
        """Writes what has no effect, and a control unit that is not enabled."""

        def cycle(self, hli: PlcView) -> None:
            """Write in each tick."""
            hli["gpAx[0]^.ipo_mc_control.feedhold.command_w"] = True
            hli["gpCh[0]^.bahn_mc_control.single_block.command_w"] = True

    run = controller.run(NcText("short.nc", "G00 X1\nM30\n"), plc=Writer())
    numbers = [found.id for found in run.diagnostics if found.id in (902106, 902107)]
    assert sorted(numbers) == [902106, 902107]
    assert controller.hli["gpAx[0]^.ipo_mc_control.feedhold.command_w"] is True


def test_a_transition_that_is_not_simulated_is_refused() -> None:
    hli = Controller().hli
    unit = "gpCh[0]^.channel_mc_control.mode_and_state"
    hli[f"{unit}.enable_w"] = True
    hli[f"{unit}.command_w.to_mode"] = 4
    hli[f"{unit}.command_w.to_state"] = 4
    with pytest.raises(Failure, match="902108"):
        hli[f"{unit}.command_semaphor_rw"] = True


@pytest.mark.parametrize(
    ("kind", "names"),
    [
        ("AxisValues", (*AXIS_NAMES, *AXIS_ALIASES)),
        ("ChannelValues", (*CHANNEL_NAMES, *CHANNEL_ALIASES)),
    ],
)
def test_editors_complete_the_names_that_there_are(kind: str, names: tuple[str, ...]) -> None:
    tree = ast.parse(inspect.getsource(getattr(hli_values, kind)))
    declared = [node.target.id for node in ast.walk(tree) if isinstance(node, ast.AnnAssign)]  # type: ignore[union-attr]
    assert sorted(declared) == sorted(names)
