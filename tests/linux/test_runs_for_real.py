# SPDX-License-Identifier: MIT
"""``nctakt schedule run``: order, counts, overflows, files, and that nothing stays behind.

Nothing here asserts how long anything took. Cycles last 20 ms and threads about one, so that what
is asserted holds on a machine that does other things at the same time.
"""

from __future__ import annotations

import csv
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from itertools import pairwise
from pathlib import Path

import pytest
from support.linux_runs import (
    CYCLE_US,
    ROOT,
    Semaphore,
    children,
    fresh_name,
    is_alive,
    needs_runner,
    run,
    semaphore_file,
    started,
    stop,
    tree_of,
    wait_for,
    write_files,
)

from nctakt.schedule.real import machine, plan

pytestmark = [needs_runner, pytest.mark.slow]
Capture = pytest.CaptureFixture[str]


def may_use_fifo() -> bool:
    """Whether SCHED_FIFO is permitted here."""
    return machine.fifo_refusal() is None


def rows(out: str, name: str) -> list[list[str]]:
    """The words of all lines that begin with a name: numbers, then simulated, then the run."""
    lines = out.splitlines()
    found = [line.split() for line in lines if line.startswith(f"{name} ")]
    place = next(i for i, line in enumerate(lines) if line.startswith(name) and " simul" in line)
    return [*found, lines[place + 1].split()]


def counts(out: str, name: str) -> dict[str, int]:
    """What the first table says of a thread."""
    words = rows(out, name)[0]
    heads = ("due", "done", "overflows", "lost", "suspended")
    return dict(zip(heads, map(int, (words[4], words[5], *words[-3:])), strict=True))


def events(path: Path, kind: str) -> list[dict[str, str]]:
    """The rows of one kind in a CSV file."""
    with path.open(encoding="utf-8", newline="") as file:
        return [row for row in csv.DictReader(file) if row["event"] == kind]


def ns(us: str) -> int:
    """A time of a CSV file in ns."""
    return round(float(us) * 1000)


@pytest.mark.parametrize("scheduling", ["--no-fifo", "--quiet"])
def test_counts(tmp_path: Path, capsys: Capture, scheduling: str) -> None:
    """Each thread is due in each n-th cycle, and each activation is a job or lost."""
    words = write_files(tmp_path)
    assert run(*words, "--cycles", "12", scheduling) in (0, 1)
    out = capsys.readouterr().out
    for name, due in (("GEO", 12), ("BACKGROUND", 12), ("COM", 6)):
        found = counts(out, name)
        assert found["due"] == due
        assert due - found["lost"] - 1 <= found["done"] <= due - found["lost"]
        assert found["overflows"] == found["lost"]
        assert rows(out, name)[1][1:5] == ["simulated", str(due), str(due), "0"]
        assert rows(out, name)[2][:2] == ["run", str(due)]
    assert ("ordinary scheduling" in out) == (scheduling == "--no-fifo" or not may_use_fifo())
    assert f"Run: 12 NC cycles, {12 * CYCLE_US} µs" in out


def test_order_of_urgency(tmp_path: Path) -> None:
    """In each cycle the more urgent thread begins first, and BACKGROUND's calls are in order."""
    if not may_use_fifo():
        pytest.skip("SCHED_FIFO is not permitted here, and nothing else keeps the order")
    words = write_files(tmp_path)
    path = tmp_path / "run.csv"
    run(*words, "--cycles", "10", "--drawn", "10", "--csv", str(path), "--quiet")
    runs = events(path, "RUN")
    begins: dict[tuple[str, str], int] = {}
    for row in runs:
        begins.setdefault((row["thread"], row["job"]), ns(row["time_us"]))
    # What began in each NC cycle, in the order of time; a lost activation is missing there.
    found: dict[int, list[str]] = {}
    for (name, _), begin in sorted(begins.items(), key=lambda one: one[1]):
        found.setdefault(begin // (1000 * CYCLE_US), []).append(name)
    urgent_first = ["GEO", "BACKGROUND", "COM"]
    assert sum(len(names) for names in found.values()) >= 20
    for names in found.values():
        assert names == [one for one in urgent_first if one in names]
    # Of what shares a processor no two pieces overlap.
    times = sorted((ns(row["time_us"]), ns(row["value"])) for row in runs)
    for (begin, length), (after, _) in pairwise(times):
        assert begin + length <= after


def test_files_and_pictures(tmp_path: Path) -> None:
    """A run is drawn and written as a simulation is."""
    words = write_files(tmp_path, semaphore=fresh_name())
    for name in ("a.svg", "a.html"):
        assert run(*words, "--cycles", "3", "--plot", str(tmp_path / name), "--quiet") in (0, 1)
    page = (tmp_path / "a.html").read_text("utf-8")
    assert "Run: 3 NC cycles" in page and "<svg" in page
    assert "BACKGROUND #0" in (tmp_path / "a.svg").read_text("utf-8")
    files = ("--csv", str(tmp_path / "a.csv"), "--perfetto", str(tmp_path / "a.json"))
    pytest.importorskip("vcd")
    assert run(*words, "--cycles", "3", "--vcd", str(tmp_path / "a.vcd"), *files) in (0, 1)
    assert "bit2" in (tmp_path / "a.vcd").read_text("utf-8")
    names = {one["name"] for one in json.loads((tmp_path / "a.json").read_text())["traceEvents"]}
    assert {"task_int", "task_rnd", "task_com", "trace bit 1", "Windows CPU 1"} <= names
    assert [row["value"] for row in events(tmp_path / "a.csv", "NC")] == ["0", "1"]


@pytest.mark.parametrize("policy", ["skip", "pend", "queue"])
def test_overflow(tmp_path: Path, capsys: Capture, policy: str) -> None:
    """A thread that works longer than its cycle overflows by the simulator's rule: an error."""
    words = write_files(tmp_path, task_int=30_000)
    assert run(*words, "--cycles", "10", "--overflow", policy, "--force", "--quiet") == 1
    shown = capsys.readouterr()
    found = counts(shown.out, "GEO")
    assert "error 900630: GEO was" in shown.err
    assert found["overflows"] >= 4
    assert found["due"] == 10
    if policy == "skip":
        # A job takes at least two cycles: no more than every second activation can be one.
        assert found["lost"] == found["overflows"] and found["done"] <= 5
    elif policy == "pend":
        assert found["lost"] < found["overflows"]
    else:
        assert found["lost"] == 0


def test_windows_time(tmp_path: Path, capsys: Capture) -> None:
    """A thread that would reach into Windows' time is stopped in each cycle and goes on after."""
    words = write_files(tmp_path, task_com=17_000)
    path = tmp_path / "run.csv"
    run(*words, "--cycles", "8", "--drawn", "8", "--csv", str(path), "--quiet")
    found = counts(capsys.readouterr().out, "COM")
    assert found["suspended"] >= 3
    assert found["done"] >= 1
    stops = [float(row["time_us"]) for row in events(path, "SUSPEND")]
    goes = [float(row["time_us"]) for row in events(path, "RESUME")]
    assert len(goes) in (len(stops), len(stops) - 1)
    busy = [row for row in events(path, "RUN") if row["thread"] == "COM"]
    for begin, end in zip(stops, goes, strict=False):
        assert not any(begin < float(row["time_us"]) < end for row in busy)


def test_windows_time_that_is_the_whole_cycle(tmp_path: Path, capsys: Capture) -> None:
    """S12: what can be suspended never runs."""
    words = write_files(tmp_path, "windows_time 20000")
    run(*words, "--cycles", "5", "--quiet")
    out = capsys.readouterr().out
    for name in ("BACKGROUND", "COM"):
        assert counts(out, name)["done"] == 0
    assert counts(out, "GEO")["done"] >= 4


def test_hardware_interrupt_is_played(tmp_path: Path, capsys: Capture) -> None:
    """Without hardware a timer gives the interrupts, with the load's period: a note says so."""
    more = "[interrupt]\nperiod = 23000\nphase = 1000\njitter = 100\n"
    words = write_files(tmp_path, "interrupt_source 1 # 1: hardware, 2: timer", more=more)
    run(*words, "--cycles", "6")
    shown = capsys.readouterr()
    assert "note 900683" in shown.err
    assert "hardware interrupt" in shown.out
    assert counts(shown.out, "GEO")["due"] == 6


def test_interrupts_from_a_semaphore(tmp_path: Path) -> None:
    """interrupt_source 3: each post of somebody else's semaphore opens a cycle."""
    name = fresh_name()
    lines = ("interrupt_source 3", f"external_object_name {name}")
    source = Semaphore(name, create=True)
    try:
        words = write_files(tmp_path, *lines)
        with started(*words, "--duration", "30s", "--quiet") as process:
            tree_of(process)
            for _ in range(8):
                source.post()
                wait_for(lambda: source.count == 0)
            out = stop(process)[1]
    finally:
        source.remove()
    assert "semaphore" in out
    assert 1 <= counts(out, "GEO")["due"] <= 7
    assert not semaphore_file(name).exists()


def test_semaphore_that_is_not_there(tmp_path: Path, capsys: Capture) -> None:
    """900687: nobody has made the semaphore that is to give the interrupts."""
    words = write_files(tmp_path, "interrupt_source 3", f"external_object_name {fresh_name()}")
    assert run(*words) == 2
    assert "error 900687" in capsys.readouterr().err


def test_posts_from_before_the_start(tmp_path: Path, capsys: Capture) -> None:
    """3.1: what was posted before anybody waited is drained and counted, no NC interrupt."""
    name = fresh_name()
    source = Semaphore(name, create=True)
    try:
        for _ in range(5):
            source.post()
        words = write_files(tmp_path, "interrupt_source 3", f"external_object_name {name}")
        assert run(*words, "--cycles", "3") == 2
        with started(*words, "--duration", "30s") as process:
            tree_of(process)
            for _ in range(3):
                source.post()
                wait_for(lambda: source.count == 0)
            time.sleep(8 * CYCLE_US / 1e6)
            out, err = stop(process)[1:]
    finally:
        source.remove()
    assert "error 900695" in capsys.readouterr().err
    assert counts(out, "GEO")["due"] <= 3
    assert "warning 900698" in err
    assert "note 900696" not in err


def test_name_of_the_semaphore_from_the_command_line(tmp_path: Path, capsys: Capture) -> None:
    """--semaphore names what the list leaves open; the posts of before are reported."""
    name = fresh_name()
    source = Semaphore(name, create=True)
    words = write_files(tmp_path, "interrupt_source 3")
    try:
        for _ in range(5):
            source.post()
        with started(*words, "--duration", "30s", "--semaphore", name) as process:
            tree_of(process)
            wait_for(lambda: source.count == 0)
            for _ in range(3):
                source.post()
                wait_for(lambda: source.count == 0)
            err = stop(process)[2]
    finally:
        source.remove()
    assert "note 900041" in err
    assert f"semaphore '/{name}' was posted 5 times before the start" in err
    assert run(*words, "--cycles", "1") == 2
    assert "error 900708" in capsys.readouterr().err
    assert run(*words, "--semaphore", "a/b") == 2
    assert "error 900684" in capsys.readouterr().err
    run(*write_files(tmp_path), "--semaphore", name, "--dry-run")
    assert "warning 900709" in capsys.readouterr().err


def test_interrupts_that_do_not_come(tmp_path: Path, capsys: Capture) -> None:
    """900695: no cycle was completed."""
    name = fresh_name()
    source = Semaphore(name, create=True)
    try:
        words = write_files(tmp_path, "interrupt_source 3", f"external_object_name {name}")
        assert run(*words, "--cycles", "3") == 2
    finally:
        source.remove()
    assert "error 900695" in capsys.readouterr().err


# --- external threads ---------------------------------------------------------------------------


def test_external_thread_played_by_the_run(tmp_path: Path, capsys: Capture) -> None:
    """--stand-in: a process of the run waits on the semaphore and works as the load describes."""
    name = fresh_name()
    words = write_files(tmp_path, semaphore=name)
    run(*words, "--cycles", "8", "--stand-in", "--quiet")
    found = counts(capsys.readouterr().out, name)
    assert found["due"] == 8 and found["lost"] == 0 and found["done"] >= 7
    assert not semaphore_file(name).exists()


def test_external_thread_that_nobody_plays(tmp_path: Path, capsys: Capture) -> None:
    """A wake-up that was not taken when the next one comes is an overflow."""
    name = fresh_name()
    words = write_files(tmp_path, semaphore=name)
    run(*words, "--cycles", "8", "--quiet")
    found = counts(capsys.readouterr().out, name)
    assert found == {"due": 8, "done": 0, "overflows": 7, "lost": 0, "suspended": 0}


def test_semaphore_that_nobody_waits_on(tmp_path: Path, capsys: Capture) -> None:
    """A warning names it; a thread that never finishes has one of its own."""
    name = fresh_name()
    words = write_files(tmp_path, semaphore=name, task_rnd=100_000)
    run(*words, "--cycles", "12", "--no-fifo")
    err = capsys.readouterr().err
    reported = next(line for line in err.splitlines() if "warning 900699" in line)
    assert f"'/{name}'" in reported
    assert "warning 900636: BACKGROUND hardly ever finishes" in err
    assert f"900636: {name}" not in err


@pytest.mark.nightly
@pytest.mark.parametrize(("words", "mode"), [((), 0o600), (("--all-users",), 0o666)])
def test_who_may_wait_on_semaphores(tmp_path: Path, words: tuple[str, ...], mode: int) -> None:
    """Semaphores belong to one user unless all are let in; the mask of files does not count."""
    name = fresh_name()
    with started(*write_files(tmp_path, semaphore=name), "--duration", "30s", *words) as process:
        tree_of(process)
        assert semaphore_file(name).stat().st_mode & 0o777 == mode
        stop(process)


def test_the_example_in_c(tmp_path: Path, capsys: Capture) -> None:
    """Any program can be an external thread: the example is compiled and takes its wake-ups."""
    compiler = shutil.which("cc") or shutil.which("gcc")
    if compiler is None:
        pytest.skip("there is no C compiler")
    program, name = tmp_path / "plc", fresh_name()
    source = ROOT / "examples" / "schedule" / "plc.c"
    flags = ["-O2", "-Wall", "-Wextra", "-Werror", "-pthread"]
    subprocess.run([compiler, *flags, "-o", program, source], check=True)
    words = write_files(tmp_path, semaphore=name)
    with subprocess.Popen([program, f"/{name}"], stdout=subprocess.PIPE, text=True) as process:
        run(*words, "--cycles", "25", "--quiet")
        reported = process.communicate(timeout=30)[0]
    found = counts(capsys.readouterr().out, name)
    # Wake-ups that were given and not yet taken at the end may still be taken.
    assert 1 <= found["done"] <= int(reported.split()[1]) <= found["due"] - found["lost"]


def test_semaphore_of_somebody_else(tmp_path: Path, capsys: Capture) -> None:
    """900685: a semaphore of that name is there, and it is nobody's leftover: it stays."""
    name = fresh_name()
    other = Semaphore(name, create=True)
    try:
        assert run(*write_files(tmp_path, semaphore=name)) == 2
        assert "error 900685" in capsys.readouterr().err
        assert semaphore_file(name).exists()
        assert not list(Path("/dev/shm").glob(f"nctakt-schedule.{os.getpid()}"))
    finally:
        other.remove()


@pytest.mark.parametrize("name", ["a/b", "x" * 251])
def test_name_that_no_semaphore_can_have(tmp_path: Path, capsys: Capture, name: str) -> None:
    """900684, or already refused by the list's own limit of 127 characters."""
    run(*write_files(tmp_path, semaphore=name), "--quiet", "--cycles", "1")
    shown = capsys.readouterr().err
    assert ("error 900684" in shown) == (name == "a/b")


# --- the end ------------------------------------------------------------------------------------


def test_ctrl_c(tmp_path: Path) -> None:
    """Ctrl-C ends a run early: tables of what there was, nothing left behind."""
    name = fresh_name()
    with started(*write_files(tmp_path, semaphore=name), "--duration", "60s") as process:
        scheduler, workers = tree_of(process)
        wait_for(lambda: Semaphore(name).count >= 2)
        os.killpg(process.pid, signal.SIGINT)  # a terminal signals all processes of the group
        out, err = process.communicate(timeout=30)
    assert process.returncode in (0, 1)
    assert "note 900693: stopped after " in err
    assert counts(out, "GEO")["due"] >= 1
    assert not any(map(is_alive, (scheduler, *workers)))
    assert not semaphore_file(name).exists()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_to_the_command_alone(tmp_path: Path, number: signal.Signals) -> None:
    """A signal to nctakt only ends the run as well."""
    with started(*write_files(tmp_path), "--duration", "60s", "--no-fifo") as process:
        scheduler, workers = tree_of(process)
        process.send_signal(number)
        process.communicate(timeout=30)
    assert process.returncode in (0, 1, 2)
    assert not any(map(is_alive, (scheduler, *workers)))


def left_behind(name: str) -> list[Path]:
    """The semaphore, and files about it."""
    records = Path("/dev/shm").glob("nctakt-schedule.*")
    return [
        path for path in (semaphore_file(name), *records) if path.exists() and name in text(path)
    ]


def text(path: Path) -> str:
    """A file's name and what is in it."""
    try:
        return path.name + path.read_text("utf-8", "replace")
    except OSError:
        return ""


def test_command_killed(tmp_path: Path) -> None:
    """SIGKILL of the command: the scheduler ends the run and removes all names."""
    name = fresh_name()
    with started(*write_files(tmp_path, semaphore=name), "--duration", "60s") as process:
        scheduler, workers = tree_of(process)
        process.kill()
        process.wait(timeout=60)
        wait_for(lambda: not any(map(is_alive, (scheduler, *workers))))
    assert left_behind(name) == []


def test_scheduler_killed(tmp_path: Path) -> None:
    """SIGKILL of the scheduler: workers die with it, the command removes all names; 900689."""
    name = fresh_name()
    with started(*write_files(tmp_path, semaphore=name), "--duration", "60s") as process:
        scheduler, workers = tree_of(process)
        os.kill(scheduler, signal.SIGKILL)
        err = process.communicate(timeout=30)[1]
        wait_for(lambda: not any(map(is_alive, workers)))
    assert process.returncode == 2
    assert "error 900689" in err
    assert left_behind(name) == []


def test_worker_killed(tmp_path: Path) -> None:
    """SIGKILL of one thread's process: the run ends, and says whose it was."""
    name = fresh_name()
    with started(*write_files(tmp_path, semaphore=name), "--duration", "60s") as process:
        scheduler, workers = tree_of(process)
        os.kill(workers[1], signal.SIGKILL)
        err = process.communicate(timeout=30)[1]
    assert process.returncode == 2
    assert "error 900689" in err and ": Killed)" in err
    assert not any(map(is_alive, (scheduler, *workers)))
    assert left_behind(name) == []


def test_all_killed_and_started_again(tmp_path: Path, capsys: Capture) -> None:
    """All processes killed at once: the semaphore stays, and the next run removes it first."""
    name = fresh_name()
    words = write_files(tmp_path, semaphore=name)
    with started(*words, "--duration", "60s") as process:
        scheduler, workers = tree_of(process)
        wait_for(semaphore_file(name).exists)
        # Stopped first, that none can clean up after the other.
        for pid in (scheduler, process.pid):
            os.kill(pid, signal.SIGSTOP)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait(timeout=60)
        wait_for(lambda: not any(map(is_alive, (scheduler, *workers))))
    assert semaphore_file(name).exists()
    assert run(*words, "--cycles", "3") in (0, 1)
    assert f"900692: removed the leftovers of a killed run: /{name}" in capsys.readouterr().err
    assert left_behind(name) == []


def test_names_of_a_living_run_stay(tmp_path: Path, capsys: Capture) -> None:
    """A second run removes nothing of a run that lives."""
    first, second = fresh_name(), fresh_name()
    words = write_files(tmp_path, semaphore=first)
    with started(*words, "--duration", "60s", "--no-fifo") as process:
        tree_of(process)
        folder = tmp_path / "second"
        folder.mkdir()
        assert run(*write_files(folder, semaphore=second), "--cycles", "2", "--no-fifo") in (0, 1)
        assert semaphore_file(first).exists()
        stop(process)
    assert "900692" not in capsys.readouterr().err
    assert left_behind(first) == left_behind(second) == []


def test_no_children_stay(tmp_path: Path) -> None:
    """After a run in this process there is no child of it."""
    before = children(os.getpid())
    run(*write_files(tmp_path), "--cycles", "2", "--quiet")
    assert children(os.getpid()) == before


# --- what the machine does not give -------------------------------------------------------------


def without_rights(*words: str) -> subprocess.CompletedProcess[str]:
    """The command without the right to choose a scheduling class."""
    drop = "import ctypes, sys; ctypes.CDLL(None).prctl(24, 23); "
    drop += "import resource; resource.setrlimit(resource.RLIMIT_RTPRIO, (0, 0)); "
    drop += "import os; os.execv(sys.executable, [sys.executable, '-m', 'nctakt', *sys.argv[1:]])"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(one for one in sys.path if one)}
    return subprocess.run(
        [sys.executable, "-c", drop, "schedule", "run", *words],
        capture_output=True,
        text=True,
        env=environment,
        check=False,
        timeout=60,
    )


def test_without_the_right_to_sched_fifo(tmp_path: Path) -> None:
    """900682, a warning: then it runs by ordinary scheduling."""
    done = without_rights(*write_files(tmp_path), "--cycles", "5")
    assert "warning 900682: SCHED_FIFO is not permitted" in done.stderr
    assert "ordinary scheduling" in done.stdout
    assert counts(done.stdout, "GEO")["due"] == 5


def test_processor_that_does_not_exist(tmp_path: Path, capsys: Capture) -> None:
    """1000180: an error, and the thread runs where the system likes."""
    if max(machine.present_cpus()) >= 7:
        pytest.skip("this machine has a CPU 7")
    words = write_files(tmp_path, "thread[2].cpu 7")
    assert run(*words, "--cycles", "4") == 1
    shown = capsys.readouterr()
    assert "error 1000180" in shown.err
    assert rows(shown.out, "COM")[0][2] == "any"
    assert counts(shown.out, "COM")["due"] == 2


def test_processor_that_is_switched_off(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """1000181: it exists, and this process cannot have it."""
    monkeypatch.setattr(machine, "present_cpus", lambda: (1, 2, 3))
    monkeypatch.setattr(machine, "usable_cpus", lambda: (1, 2))
    assert run(*write_files(tmp_path, "thread[2].cpu 3"), "--cycles", "2") == 1
    assert "error 1000181" in capsys.readouterr().err


def test_the_loads_machine_does_not_count(tmp_path: Path, capsys: Capture) -> None:
    """900690: the processors are those of this machine."""
    run(*write_files(tmp_path, more="[machine]\ncpus = 5\n"), "--cycles", "1")
    assert "note 900690: machine.cpus " in capsys.readouterr().err


def test_processors_as_the_system_names_them() -> None:
    """Ranges and single ones, from 1 on, as far as a list can name them."""
    assert machine.parse_cpus("0-1\n") == (1, 2)
    assert machine.parse_cpus("0,2-3,63\n") == (1, 3, 4)


def test_crowded_machine(tmp_path: Path, capsys: Capture) -> None:
    """900688: what would take a processor wholly runs with --force only."""
    if not may_use_fifo():
        pytest.skip("without SCHED_FIFO nothing can take a processor wholly")
    words = write_files(tmp_path, task_int=19_500)
    assert run(*words, "--cycles", "2") == 2
    assert "error 900688" in capsys.readouterr().err
    assert run(*words, "--cycles", "2", "--no-fifo") in (0, 1)


def test_dry_run(tmp_path: Path, capsys: Capture) -> None:
    """Who would run where; nothing is made."""
    name = fresh_name()
    assert run(*write_files(tmp_path, semaphore=name), "--dry-run", "--quiet") == 0
    out = capsys.readouterr().out
    row = next(line for line in out.splitlines() if line.startswith("GEO "))
    assert row.split()[:4] == ["GEO", "realtime", "1", "0"]
    assert f"/{name}" in out
    assert not semaphore_file(name).exists()


def test_other_systems(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    """900680: by name; 900681: where the compiled part is missing."""
    words = write_files(tmp_path)
    with monkeypatch.context() as patch:
        patch.setattr(machine.sys, "platform", "darwin")
        assert run(*words) == 2
    assert "error 900680" in capsys.readouterr().err
    with monkeypatch.context() as patch:
        patch.setattr(machine.importlib.util, "find_spec", lambda name: None)
        assert run(*words) == 2
    assert "error 900681" in capsys.readouterr().err


def test_log_without_room(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    """900691: a run ends when its log is full; what it has is reported."""
    from nctakt.schedule.real import area  # noqa: PLC0415 - what is compiled may be missing

    monkeypatch.setattr(area, "MAX_ENTRIES", 60)
    run(*write_files(tmp_path), "--cycles", "40", "--no-fifo")
    shown = capsys.readouterr()
    assert "warning 900691: the run ended after " in shown.err
    assert 1 <= counts(shown.out, "GEO")["due"] < 40


def test_longest_run(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    """900691: nor does it last longer than a run can; what was asked for may be any number."""
    monkeypatch.setattr(plan, "MAX_CYCLES", 3)
    run(*write_files(tmp_path), "--duration", "100000min", "--no-fifo")
    assert "warning 900691: the run ended after 3 NC cycles" in capsys.readouterr().err
