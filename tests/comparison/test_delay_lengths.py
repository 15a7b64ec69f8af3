# SPDX-License-Identifier: MIT
"""Which delays of a log are shown, and how long (LG-706), in logs of runs of our own.

``NCTAKT_SEEDS=500`` makes as many random logs.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import numpy
import pytest
from support.random_seeds import by_night

from nctakt.comparison.columns import Numbers
from nctakt.comparison.comparison import Comparison, compare
from nctakt.comparison.delay_search import MAX_DELAYS
from nctakt.comparison.log import Log, LogColumn, Samples
from nctakt.comparison.mapping import Pair
from nctakt.comparison.recorded import RecordedColumns
from nctakt.comparison.report import comparison_text
from nctakt.results.run import Run
from nctakt.results.trace.sinks import Signal
from nctakt.run.controller import Controller

NAMES = ["X.ACS.ACT_POS", "Y.ACS.ACT_POS"]
PART = "N10 G01 X100 Y50 F6000\nN20 X0\nN30 G04 0.2\nN40 Y0 X30\nN50 X80 F3000\nM30\n"
SEEDS = int(os.environ.get("NCTAKT_SEEDS", "10"))
#: A delay as it was made: the line of the block from which on the log is late, and µs.
Made = tuple[int, float]


class MadeLog(Log):
    """A log that is in memory."""

    def __init__(self, stamps: Numbers, values: Sequence[Numbers]) -> None:
        super().__init__("made.csv")
        self.columns = [LogColumn(name, "mm", at, 0) for at, name in enumerate(NAMES, 1)]
        self._stamps, self._values = stamps, values

    def read(self, columns: Sequence[LogColumn]) -> list[Samples]:
        """Return the samples."""
        return [Samples(self._stamps, self._values[one.column - 1]) for one in columns]


def run_of(program: str) -> tuple[Run, RecordedColumns]:
    """Return the run of a program, and what it recorded."""
    Path("part.nc").write_text(program, "utf-8")
    recorded = RecordedColumns()
    run = Controller().run(
        "part.nc", signals=NAMES, sinks=[recorded], memory_trace=False, blocks=True
    )
    return run, recorded


def ticks_of(recorded: RecordedColumns) -> Numbers:
    """Return the times of the ticks, in µs."""
    return 1000.0 * numpy.arange(len(recorded[NAMES[0]]))


def logged(
    recorded: RecordedColumns,
    stands: Sequence[tuple[float, float]],
    *,
    gain: float = 1.0,
    bias: float = 0.0,
    noise: float = 0.0,
    step_us: float = 2000.0,
    begin_us: float = 1_234_500.0,
    drift: float = 0.0,
) -> MadeLog:
    """Return a log in which the machine is at times of the run, each for so long, in µs."""
    ticks = ticks_of(recorded)
    longest = sum(length for _, length in stands)
    end_us = begin_us + (ticks[-1] + longest) * (1.0 + drift) + 5e5
    stamps = numpy.arange(0.0, end_us, step_us)
    times = (stamps - begin_us) / (1.0 + drift)
    for time_us, length in stands:
        times = numpy.where(times > time_us, numpy.maximum(times - length, time_us), times)
    random = numpy.random.default_rng(1)
    values = [
        gain * numpy.interp(times, ticks, recorded[name][:])
        + bias
        + random.normal(0.0, noise, len(times))
        for name in NAMES
    ]
    return MadeLog(stamps, values)


def compared(run: Run, recorded: RecordedColumns, log: MadeLog) -> Comparison:
    """Return a log beside a run."""
    pairs = [
        Pair(Signal(name, "mm"), column, 1.0, 0.0, None, False)
        for name, column in zip(NAMES, log.columns, strict=True)
    ]
    return compare(log, run, recorded, pairs, {})


def shown(comparison: Comparison) -> list[tuple[int, float | None]]:
    """Return the lines and lengths of the delays that are shown."""
    return [
        (0 if one.block is None else one.block.line, one.jump_us) for one in comparison.delays.found
    ]


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("noise", [by_night(0.0), 0.002])
@pytest.mark.parametrize("gain", [1.0, by_night(1.01)])
@pytest.mark.parametrize("length_us", [3e3, 3e4, 1e5, 5e5, 2e6, 15e6])
def test_a_length_is_what_it_is(length_us: float, gain: float, noise: float) -> None:
    """The machine is longer in the dwell N30: N40 comes later by as much, nothing else.

    Noise of 2 µm at up to 91 mm/s and some 100 samples in ramps: µs.
    """
    run, recorded = run_of(PART)
    found = compared(run, recorded, logged(recorded, [(2.35e6, length_us)], gain=gain, noise=noise))
    assert found.alignment.offset_us == pytest.approx(1_234_500.0, abs=5.0)
    ((line, length),) = shown(found)
    assert line == 4
    assert length == pytest.approx(length_us, abs=20.0)


@pytest.fixture(scope="module")
def long_run(tmp_path_factory: pytest.TempPathFactory) -> tuple[Run, RecordedColumns, int]:
    """A run of 100 s without repeats, what it recorded, and the line of an M10 in its middle."""
    random = numpy.random.default_rng(5)
    lines = [
        f"G01 X{x:.3f} Y{y:.3f} F{feed}"
        for (x, y), feed in zip(
            random.uniform(-80.0, 80.0, (90, 2)),
            random.choice([3000, 6000, 12000], 90),
            strict=True,
        )
    ]
    lines.insert(45, "M10")
    folder = tmp_path_factory.mktemp("long")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        return (*run_of("\n".join([*lines, "M30"]) + "\n"), 46)


@pytest.mark.parametrize("noise", [by_night(0.0), 0.005])
@pytest.mark.parametrize("drift", [by_night(0.0), 40e-6])
@pytest.mark.parametrize("length_us", [0.0, 1e3, 3e4, 1e6])
def test_a_late_function_in_a_long_log_is_no_drift(
    long_run: tuple[Run, RecordedColumns, int], length_us: float, drift: float, noise: float
) -> None:
    """M10 is acknowledged later on the machine, in the middle of the log: a step, and no slope.

    With a clock that runs 40 ppm slower both are reported; without a delay there is none.
    """
    run, recorded, line = long_run
    event = next(one for one in recorded.blocks if one.span is not None and one.span.line == line)
    stands = [(float(event.time_us), length_us)] if length_us else []
    log = logged(recorded, stands, noise=noise, drift=drift)
    found = compared(run, recorded, log)
    assert found.alignment.offset_us == pytest.approx(1_234_500.0, abs=10.0)
    assert found.alignment.drift * 1e6 == pytest.approx(1e6 * drift, abs=0.2)
    assert (found.alignment.drift == 0.0) == (drift == 0.0)
    reported = [(line + 1, pytest.approx(length_us, abs=30.0))] if length_us else []
    assert shown(found) == reported


def test_delays_one_after_another() -> None:
    """The second is found on what the first leaves; one that is shorter than it should be, too."""
    program = "G01 X40 F6000\nG04 0.3\nX90 Y20\nG04 0.3\nX10\nG04 0.3\nX50 Y0\nM30\n"
    run, recorded = run_of(program)
    starts = [one.time_us for one in recorded.blocks][1::2]
    stands = [(starts[0] + 1e5, 7e4), (starts[1] + 1e5, 1.2e6), (starts[2] + 1e5, 4e3)]
    found = shown(compared(run, recorded, logged(recorded, stands, noise=0.001)))
    assert [line for line, _ in found] == [3, 5, 7]
    assert [length for _, length in found] == [pytest.approx(one, abs=30.0) for _, one in stands]


def test_a_dwell_that_is_shorter_in_the_log() -> None:
    """N40 comes 50 ms earlier: the end of the dwell is left out."""
    run, recorded = run_of(PART)
    log = logged(recorded, [])
    stamps = log.read(log.columns)[0].times[:]
    times = stamps - 1_234_500.0
    times += numpy.where(times > 2.3e6, 5e4, 0.0)
    values = [numpy.interp(times, ticks_of(recorded), recorded[name][:]) for name in NAMES]
    found = shown(compared(run, recorded, MadeLog(stamps, values)))
    assert found == [(4, pytest.approx(-5e4, abs=30.0))]


def test_a_length_that_is_not_sure_is_not_shown() -> None:
    """Y alone is late, X is not: there is a place, and no length of all."""
    run, recorded = run_of(PART)
    one, other = logged(recorded, [(2.35e6, 3e4)]), logged(recorded, [])
    values = [other.read(other.columns)[0].values, one.read(one.columns)[1].values]
    length = min(map(len, values))
    stamps = one.read(one.columns)[0].times[:length]
    found = compared(run, recorded, MadeLog(stamps, [value[:length] for value in values]))
    assert shown(found) == [(4, None)]
    text = comparison_text(found, "part.nc", "en")
    assert "the log is late or early; by how much, and what comes after, the curves do" in text


def test_a_list_that_is_cut_says_so() -> None:
    """Twelve dwells that are 20 ms longer: ten are listed."""
    program = "".join(f"G01 X{(at * 37) % 100} F6000\nG04 0.1\n" for at in range(1, 14))
    run, recorded = run_of(f"{program}M30\n")
    dwells = [one.time_us for one in recorded.blocks][1::2]
    stands = [(time_us + 5e4, 2e4) for time_us in dwells[:12]]
    found = compared(run, recorded, logged(recorded, stands))
    assert len(shown(found)) == MAX_DELAYS
    assert "later delays are not listed" in comparison_text(found, "part.nc", "en")


def random_case(seed: int) -> tuple[str, list[int], numpy.random.Generator]:
    """Return a program of moves and dwells, and which of its lines are dwells."""
    random = numpy.random.default_rng(seed)
    lines: list[str] = []
    dwells: list[int] = []
    repeats = bool(random.random() < 0.3)
    targets = random.uniform(-80.0, 80.0, (3, 2))
    for at in range(int(random.integers(4, 12))):
        x, y = targets[at % 3] if repeats else random.uniform(-80.0, 80.0, 2)
        word = f"X{x:.3f}" if random.random() < 0.4 else f"X{x:.3f} Y{y:.3f}"
        lines.append(f"G01 {word} F{random.choice([1500, 6000, 12000])}")
        if random.random() < 0.5:
            lines.append(f"G04 {random.choice([0.05, 0.2, 1.0])}")
            dwells.append(len(lines))
    return "\n".join([*lines, "M30"]) + "\n", dwells, random


@pytest.mark.parametrize("seed", range(SEEDS))
def test_no_length_is_false(seed: int) -> None:
    """A length that is shown is that of the delay that was made, to 1 ms or 1 %; so is a place."""
    program, dwells, random = random_case(seed)
    run, recorded = run_of(program)
    blocks = recorded.blocks
    made: list[Made] = []
    stands = []
    count = min(len(dwells), int(random.integers(0, 4)))
    for line in sorted(random.choice(dwells, count, replace=False).tolist() if count else []):
        event = next(one for one in blocks if one.span is not None and one.span.line == line)
        length = float(10.0 ** random.uniform(3.0, 7.0))
        stands.append((event.time_us + 2.5e4, length))
        made.append((line + 1, length))
    found = compared(
        run,
        recorded,
        logged(
            recorded,
            stands,
            gain=float(random.choice([1.0, 1.0, 1.01, 0.98])),
            bias=float(random.choice([0.0, 0.0, 0.4])),
            noise=float(random.choice([0.0, 0.001, 0.01, 0.05])),
            step_us=float(random.choice([250.0, 1000.0, 2000.0, 5000.0, 10_000.0])),
            begin_us=float(random.uniform(0.0, 5e6)),
        ),
    )
    true = dict(made)
    for line, length in shown(found):
        assert line in true, (shown(found), made)
        if length is not None:
            limit = max(1000.0, 0.01 * true[line])
            assert length == pytest.approx(true[line], abs=limit), (shown(found), made)
