# SPDX-License-Identifier: MIT
"""When the decoder doubts where an axis is (RC-409)."""

from __future__ import annotations

from nctakt.decoder.state.uncertain_axes import LivingCycle, UncertainAxes


def moved(*living: LivingCycle, moving: tuple[str, ...] = ()) -> UncertainAxes:
    return UncertainAxes(living, moving)


def test_without_cycles_no_axis_is_doubtful() -> None:
    """A program without single-axis commands never asks."""
    axes = moved()
    axes.pass_time(["X"])
    assert axes.uncertain("XYZ") == ()


def test_a_block_cycle_makes_its_axes_doubtful_after_its_block() -> None:
    """RC-409: not in its own block, which may move the axis; after it once."""
    axes = moved()
    axes.define_cycle(0, ("Z",), is_block=True, starts=True)
    assert axes.uncertain("XYZ") == ()
    axes.pass_time(is_block=False)
    assert axes.uncertain("XYZ") == ()
    axes.pass_time(["X"])
    assert axes.uncertain("XYZ") == ("Z",)
    axes.confirm("Z")
    axes.pass_time(["X"])
    assert axes.uncertain("XYZ") == ()


def test_a_block_cycle_with_def_does_so_after_each_start() -> None:
    """RC-409: again after each START; a definition alone moves nothing."""
    axes = moved()
    axes.define_cycle(17, ("Z",), is_block=True, starts=False)
    axes.pass_time(["X"])
    assert axes.uncertain("Z") == ()
    for _ in range(2):
        axes.start_cycle(17)
        axes.pass_time(["X"])
        assert axes.uncertain("Z") == ("Z",)
        axes.confirm("Z")


def test_a_prog_cycle_makes_its_axes_doubtful_while_it_lives() -> None:
    """RC-409 (choice): at once, and again after what takes time and does not move the axis."""
    axes = moved()
    axes.define_cycle(0, ("Y", "Z"), is_block=False, starts=True)
    assert axes.uncertain("XYZ") == ("Y", "Z")
    axes.confirm("Z")
    axes.pass_time(["Z"])
    assert axes.uncertain("Z") == ()
    axes.pass_time(["Z", "X"])
    assert axes.uncertain("Z") == ()
    axes.pass_time(["X"])
    assert axes.uncertain("Z") == ("Z",)


def test_after_delete_only_axes_that_still_move_are_doubtful() -> None:
    """RC-409: DELETE asks for all positions by itself; what moves on is asked for again."""
    axes = moved()
    axes.define_cycle(5, ("Y", "Z"), is_block=False, starts=True)
    axes.delete_cycle(5, ("Z",))
    assert axes.uncertain("XYZ") == ("Z",)
    axes.confirm("Z")
    axes.pass_time(["X"])
    assert axes.uncertain("XYZ") == ()
    axes.start_cycle(5)
    assert axes.uncertain("XYZ") == ()


def test_cycles_of_earlier_programs_count() -> None:
    """RC-107, RC-409: a GLOBAL cycle that runs, or is start_cycle by this program, and
    MOVE_CONT."""
    axes = moved(LivingCycle(1, ("X",), True), LivingCycle(2, ("Y",), False), moving=("A",))
    assert axes.uncertain("XYZA") == ("X", "A")
    axes.start_cycle(2)
    assert axes.uncertain("XYZA") == ("X", "Y", "A")


def test_start_of_an_unknown_id_is_of_no_concern() -> None:
    """RC-111: it is an error of the tick, 50858."""
    axes = moved()
    axes.start_cycle(99)
    axes.delete_cycle(98, ())
    assert axes.uncertain("XYZ") == ()


def test_a_cycle_without_single_axis_commands_is_of_no_concern() -> None:
    """Most cycles move nothing."""
    axes = moved()
    axes.define_cycle(1, (), is_block=False, starts=True)
    axes.pass_time(["X"])
    assert axes.uncertain("XYZ") == ()
