# SPDX-License-Identifier: MIT
"""The axes of a machine by their logical numbers: those that turn spindles, and those of paths."""

from __future__ import annotations

from nctakt.lists.machine.machine import Machine


def spindle_numbers(machine: Machine) -> dict[int, tuple[str, int]]:
    """Return logical number -> name and channel, from 1, of each spindle."""
    return {
        spindle.spindle.logical_number: (spindle.name, channel.number)
        for channel in machine.channels
        for spindle in channel.spindles
    }


def c_axes(machine: Machine) -> dict[int, int]:
    """Return logical number -> index of the main spindles' axes that a path can have."""
    indices = [machine.c_axis_of(channel) for channel in machine.channels]
    return {machine.axes[index].logical_number: index for index in indices if index >= 0}


def path_axes(machine: Machine) -> dict[int, int]:
    """Return logical number -> index of the axes that turn no spindle and are no slaves."""
    spindles = spindle_numbers(machine)
    return {
        axis.logical_number: index
        for index, axis in enumerate(machine.axes)
        if axis.logical_number not in spindles and not axis.gantry.master
    }
