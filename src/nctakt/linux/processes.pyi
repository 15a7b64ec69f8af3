# SPDX-License-Identifier: MIT
"""Starts the processes of a run; named semaphores. Written in C."""

from mmap import mmap

AREA_SIZE: int
TASK_SIZE: int
ENTRY_SIZE: int

def spawn(area: mmap, /) -> int:
    """Start the scheduler over an area of shared memory; its process ID."""

def create(name: str, /) -> None:
    """Make a named semaphore that must not exist yet, with count 0; raises ``OSError``."""

def remove(name: str, /) -> None:
    """Remove a named semaphore; raises ``OSError``."""
