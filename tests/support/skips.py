# SPDX-License-Identifier: MIT
"""Which tests may be skipped in CI and why nothing is lost there; what is missing elsewhere.

A skip in CI hides that a program or a library of others is not installed: it is a failure, unless
its reason is in this table. Elsewhere the run says at its end what could not be tried, and how to
get it.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable

import pytest

IS_CI = os.environ.get("CI", "") not in ("", "0", "false")

#: Reasons of skips that CI permits -> why no test is lost.
PERMITTED = {
    r"compiled methods cannot be called": "asked in plain mode, which CI runs, too",
    r"fields of compiled objects are not seen": "asked in plain mode",
    r"calls are counted in the plain mode": "asked in plain mode",
    r"plain Python imports Cython": "asked in compiled mode",
    r"not compiled|the modules run plain|is not compiled here": "asked in compiled mode",
    r"the same in both modes|short cycles do the same": "asked in compiled mode",
    r"there is no C compiler|^no C compiler": "the sanitized build cannot be reached from it",
    r"rights do not bind root": "CI may be root; a user's run asks it",
    r"SCHED_FIFO": "a right of the machine, not a program",
    r"this process cannot be copied": "it has threads of other tests; asked without them",
    r"this machine has a CPU": "the test needs a number that no processor has",
    r"has mistakes": "the property holds for programs without mistakes",
    r"NCTAKT_CORPUS names no folder|no corpus beside|programs of others": "others' programs",
    r"got empty parameter set": "the same: there is no file to ask about",
    r"trace_processor_shell": "in no package; Perfetto's page, which CI opens, has the same code",
    r"does not run with this Python": "SimSo has no release for Python 3.12",
}
_PERMITTED = re.compile("|".join(f"(?:{pattern})" for pattern in PERMITTED))


def reason_of(report: pytest.TestReport | pytest.CollectReport) -> str:
    """Return why a test or a file was skipped, "" where it was not or is expected to fail."""
    if report.outcome != "skipped" or hasattr(report, "wasxfail"):
        return ""
    if isinstance(report.longrepr, tuple):
        return str(report.longrepr[2]).removeprefix("Skipped: ")
    return str(report.longrepr)


def refuse(report: pytest.TestReport | pytest.CollectReport) -> None:
    """Make a skip in CI a failure where its reason is not permitted."""
    reason = reason_of(report)
    if IS_CI and reason and not _PERMITTED.search(reason):
        report.outcome = "failed"
        report.longrepr = f"skipped in CI, where nothing may be missing: {reason}"


def summary(reports: Iterable[pytest.TestReport | pytest.CollectReport]) -> list[str]:
    """Return lines that say what could not be tried for want of a program or a library."""
    reasons = (reason_of(report) for report in reports)
    missing = Counter(reason for reason in reasons if reason and not _PERMITTED.search(reason))
    if not missing:
        return []
    return [
        *(f"{count:5}  {reason}" for reason, count in sorted(missing.items())),
        'Libraries: pip install -e ".[test]"; programs: python scripts/real_clients FOLDER.',
    ]
