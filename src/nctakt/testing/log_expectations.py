# SPDX-License-Identifier: MIT
"""Expectations that a signal stays near a machine's log: the comparison of ``nctakt compare``.

In: a run with its trace, an expectation, the folder of its program. Out: the differences.
"""

from __future__ import annotations

from pathlib import Path

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.base.unit_factors import factor_between
from nctakt.comparison.comparison import compare
from nctakt.comparison.log_file import open_log
from nctakt.comparison.mapping import Tolerance, pairs_of
from nctakt.comparison.recorded import RecordedTrace
from nctakt.files.access import FileAccess
from nctakt.lists.format.times import time_stamp
from nctakt.messages import diagnostic
from nctakt.messages.commands.comparison import LOG_LACKS_SIGNAL, UNITS_DO_NOT_FIT
from nctakt.results.trace.events import number_text
from nctakt.testing.expectations import Expectation
from nctakt.testing.queries import NcRun

_AXIS_SIGNAL = ".ACS.ACT_POS"


def wrong_beside_log(run: NcRun, name: str, expectation: Expectation, folder: Path) -> list[str]:
    """Return where signal ``name`` leaves its tolerance; empty if it never does.

    Raises ``Failure`` as ``nctakt compare``, and for a log without the signal (902619).
    """
    trace = run.run.trace
    assert trace is not None
    log = open_log(folder / expectation.file, FileAccess())
    axes = [
        one.name.removesuffix(_AXIS_SIGNAL)
        for one in trace.signals
        if one.name.endswith(_AXIS_SIGNAL)
    ]
    pairs = pairs_of(log, trace.signals, axes, {})
    signal = next((pair.signal for pair in pairs if pair.signal.name == name), None)
    if signal is None:
        raise Failure(diagnostic(LOG_LACKS_SIGNAL, file=log.file, name=name))
    factor = factor_between(expectation.unit, signal.unit)
    if factor is None:
        raise Failure(
            diagnostic(
                UNITS_DO_NOT_FIT,
                name=number_text(expectation.within),
                unit=expectation.unit,
                signal=name,
                other=signal.unit,
            )
        )
    comparison = compare(
        log, run.run, RecordedTrace(run.run), pairs, {name: Tolerance(expectation.within * factor)}
    )
    found = next(one for one in comparison.deviations if one.pair.signal.name == name)
    if found.first_us is None:
        return []
    lines = [
        f"beyond from {time_stamp(found.first_us)} on, in {found.beyond} of {found.samples} "
        f"samples; {found.greatest:.4g} {signal.unit} at {time_stamp(found.greatest_us)}"
    ]
    lines += [one.text("en") for one in comparison.diagnostics if one.severity > Severity.NOTE]
    return lines
