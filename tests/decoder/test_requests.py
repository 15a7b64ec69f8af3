# SPDX-License-Identifier: MIT
"""When the decoder doubts where an axis is (RC-409)."""

from __future__ import annotations

from nctakt.decoder.state.uncertain_axes import LivingCycle, MovedAxes


def moved(*living: LivingCycle, moving: tuple[str, ...] = ()) -> MovedAxes:
    return MovedAxes(living, moving)


def test_without_cycles_no_axis_is_doubtful() -> None:
    """A program without single-axis commands never asks."""
    axes = moved()
    axes.took_time(["X"])
    assert axes.doubtful("XYZ") == ()


def test_a_block_cycle_makes_its_axes_doubtful_behind_its_block() -> None:
    """RC-409: not in its own block, which may move the axis; behind it once."""
    axes = moved()
    axes.defined(0, ("Z",), is_block=True, starts=True)
    assert axes.doubtful("XYZ") == ()
    axes.took_time(is_block=False)
    assert axes.doubtful("XYZ") == ()
    axes.took_time(["X"])
    assert axes.doubtful("XYZ") == ("Z",)
    axes.told("Z")
    axes.took_time(["X"])
    assert axes.doubtful("XYZ") == ()


def test_a_block_cycle_with_def_does_so_after_each_start() -> None:
    """RC-409: again after each START; a definition alone moves nothing."""
    axes = moved()
    axes.defined(17, ("Z",), is_block=True, starts=False)
    axes.took_time(["X"])
    assert axes.doubtful("Z") == ()
    for _ in range(2):
        axes.started(17)
        axes.took_time(["X"])
        assert axes.doubtful("Z") == ("Z",)
        axes.told("Z")


def test_a_prog_cycle_makes_its_axes_doubtful_while_it_lives() -> None:
    """RC-409 (choice): at once, and again after what takes time and does not move the axis."""
    axes = moved()
    axes.defined(0, ("Y", "Z"), is_block=False, starts=True)
    assert axes.doubtful("XYZ") == ("Y", "Z")
    axes.told("Z")
    axes.took_time(["Z"])
    assert axes.doubtful("Z") == ()
    axes.took_time(["Z", "X"])
    assert axes.doubtful("Z") == ()
    axes.took_time(["X"])
    assert axes.doubtful("Z") == ("Z",)


def test_after_delete_only_axes_that_still_move_are_doubtful() -> None:
    """RC-409: DELETE asks for all positions by itself; what moves on is asked for again."""
    axes = moved()
    axes.defined(5, ("Y", "Z"), is_block=False, starts=True)
    axes.deleted(5, ("Z",))
    assert axes.doubtful("XYZ") == ("Z",)
    axes.told("Z")
    axes.took_time(["X"])
    assert axes.doubtful("XYZ") == ()
    axes.started(5)
    assert axes.doubtful("XYZ") == ()


def test_cycles_of_earlier_programs_count() -> None:
    """RC-107, RC-409: a GLOBAL cycle that runs, or is started by this program, and MOVE_CONT."""
    axes = moved(LivingCycle(1, ("X",), True), LivingCycle(2, ("Y",), False), moving=("A",))
    assert axes.doubtful("XYZA") == ("X", "A")
    axes.started(2)
    assert axes.doubtful("XYZA") == ("X", "Y", "A")


def test_start_of_an_unknown_id_is_of_no_concern() -> None:
    """RC-111: it is an error of the tick, 50858."""
    axes = moved()
    axes.started(99)
    axes.deleted(98, ())
    assert axes.doubtful("XYZ") == ()


def test_a_cycle_without_single_axis_commands_is_of_no_concern() -> None:
    """Most cycles move nothing."""
    axes = moved()
    axes.defined(1, (), is_block=False, starts=True)
    axes.took_time(["X"])
    assert axes.doubtful("XYZ") == ()
