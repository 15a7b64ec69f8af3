# SPDX-License-Identifier: MIT
"""Lists, loads and processes for the tests of schedules that run for real.

NC cycles are long (20 ms) and runs short, so that what is asserted holds on a busy machine; no
test asserts how long anything took.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path

import pytest

from nctakt.cli import main

ROOT = Path(__file__).parents[2]
SHARED_MEMORY = Path("/dev/shm")
CYCLE_US = 20_000

IS_BUILT = (
    sys.platform == "linux"
    and importlib.util.find_spec("nctakt.schedule.real.processes") is not None
)
needs_runner = pytest.mark.skipif(
    not IS_BUILT, reason="the part that runs schedules is not compiled (scripts/test does it)"
)

LIST = """\
interrupt_source 2 # 1: hardware, 2: timer
cycle_time 20000
time_slice 5000
windows_time 5000
thread[0].name GEO
thread[0].cycle 20000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
thread[0].function[0].trace_bit 1
thread[1].name BACKGROUND
thread[1].cycle 20000
thread[1].priority 105
thread[1].function[0].name task_rnd
thread[1].function[0].calls_per_cycle 2
thread[1].function[0].trace_bit 2
thread[2].name COM
thread[2].cycle 40000
thread[2].priority 90
thread[2].function[0].name task_com
thread[2].function[0].trace_bit 4
"""
LOAD = """\
[functions]
task_int = {task_int}
task_rnd = {task_rnd}
task_com = {task_com}
{more}
"""
_numbers = count(1)


def fresh_name() -> str:
    """The name of a semaphore that no other test has."""
    return f"nctakt-test-{os.getpid()}-{next(_numbers)}"


def write_files(
    folder: Path,
    *lines: str,
    semaphore: str = "",
    task_int: int = 1000,
    task_rnd: int = 500,
    task_com: int = 500,
    more: str = "",
) -> list[str]:
    """Write a list and a load; the words of the command line for them."""
    text = LIST + "".join(f"{line}\n" for line in lines)
    if semaphore:
        text += f"external_thread[0].semaphore_name {semaphore}\nexternal_thread[0].cycle 20000\n"
        more += f'\n[external."{semaphore}"]\ntime = 500\npriority = 110\n'
    (folder / "rtconf.lis").write_text(text + "End\n", "utf-8")
    load = LOAD.format(task_int=task_int, task_rnd=task_rnd, task_com=task_com, more=more)
    (folder / "load.toml").write_text(load, "utf-8")
    return [str(folder / "rtconf.lis"), "--load", str(folder / "load.toml")]


def run(*words: str) -> int:
    """The exit code of ``nctakt schedule run``."""
    return main(["schedule", "run", *words])


@contextmanager
def started(*words: str) -> Iterator[subprocess.Popen[str]]:
    """``nctakt schedule run`` in its own process, at the head of its own group."""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(one for one in sys.path if one)}
    with subprocess.Popen(
        [sys.executable, "-m", "nctakt", "schedule", "run", *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        start_new_session=True,
    ) as process:
        try:
            yield process
        finally:
            process.kill()


def wait_for(what: Callable[[], object], seconds: float = 60.0) -> None:
    """Wait until a condition holds."""
    end = time.monotonic() + seconds
    while not what():
        assert time.monotonic() < end, "it never came"
        time.sleep(0.01)


def semaphore_file(name: str) -> Path:
    """Where the system keeps a named semaphore."""
    return SHARED_MEMORY / f"sem.{name}"


def children(pid: int) -> list[int]:
    """The processes that a process has started."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            text = (entry / "stat").read_text("utf-8")
        except OSError:
            continue
        state, parent = text.rpartition(")")[2].split()[:2]
        if int(parent) == pid and state != "Z":
            found.append(int(entry.name))
    return found


def is_alive(pid: int) -> bool:
    """Whether a process is there and no zombie."""
    try:
        text = Path(f"/proc/{pid}/stat").read_text("utf-8")
    except OSError:
        return False
    return text.rpartition(")")[2].split()[0] not in ("Z", "X")


def tree_of(process: subprocess.Popen[str]) -> tuple[int, list[int]]:
    """The scheduler and the workers of a run that has begun."""
    wait_for(lambda: children(process.pid) and children(children(process.pid)[0]))
    scheduler = children(process.pid)[0]
    wait_for(lambda: len(children(scheduler)) == 3)
    return scheduler, children(scheduler)


def stop(process: subprocess.Popen[str]) -> tuple[int, str, str]:
    """End a run as Ctrl-C does; exit code, output, errors."""
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    return process.returncode, out, err


class Semaphore:
    """A named semaphore as another program has it."""

    def __init__(self, name: str, *, create: bool = False) -> None:
        self._library = ctypes.CDLL(None, use_errno=True)
        self._library.sem_open.restype = ctypes.c_void_p
        self._name = f"/{name}".encode()
        flags = os.O_CREAT if create else 0
        self._address = ctypes.c_void_p(self._library.sem_open(self._name, flags, 0o600, 0))
        assert self._address.value, os.strerror(ctypes.get_errno())

    def post(self) -> None:
        """Give it once."""
        assert self._library.sem_post(self._address) == 0

    @property
    def count(self) -> int:
        """How often it was given and not taken."""
        value = ctypes.c_int()
        assert self._library.sem_getvalue(self._address, ctypes.byref(value)) == 0
        return value.value

    def remove(self) -> None:
        """Remove its name."""
        self._library.sem_unlink(self._name)
