# SPDX-License-Identifier: MIT
"""Starts the processes of a run; named semaphores. Written in C."""

from mmap import mmap

class Semaphore: ...

AREA_SIZE: int
TASK_SIZE: int
ENTRY_SIZE: int

def spawn(area: mmap, /) -> int:
    """Start the scheduler over an area of shared memory; its process ID."""

def create(name: str, /) -> None:
    """Make a named semaphore that must not exist yet, with count 0; raises ``OSError``."""

def remove(name: str, /) -> None:
    """Remove a named semaphore; raises ``OSError``."""

def open(name: str, /) -> Semaphore:
    """Open a named semaphore for ``post``; raises ``OSError``."""

def post(semaphore: Semaphore, /) -> int:
    """Give a semaphore; return how many earlier posts are still there."""

def wait_until(moment_ns: int, /) -> int:
    """Wait for a moment of the monotonic clock, without the interpreter's lock; return the time."""

def place_thread(priority: int, cpu: int, /) -> int:
    """Give the calling thread a priority of SCHED_FIFO (0: ordinary) and a CPU (0: any).

    Return the system's error, 0 for none.
    """
