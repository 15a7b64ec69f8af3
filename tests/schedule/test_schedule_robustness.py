# SPDX-License-Identifier: MIT
"""No list and no load makes scheduling fail with anything but diagnostics."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.schedule_examples import EXAMPLE_1, EXAMPLE_2, TIGHT, load_text, with_line
from support.scheduling_entries import KEYS, VALUES

from nctakt.base.diagnostics import Severity
from nctakt.base.mode import is_compiled
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions
from nctakt.messages import Collector
from nctakt.schedule.analysis.analyse import analyse, simulate_worst_phases
from nctakt.schedule.analysis.findings import analysis_findings, simulation_findings
from nctakt.schedule.analysis.margins import find_margins
from nctakt.schedule.assemble import assemble
from nctakt.schedule.effective_table import effective_rows
from nctakt.schedule.load import ASSUMED, read_load
from nctakt.schedule.model import Rules
from nctakt.schedule.pictures.figure import svg
from nctakt.schedule.pictures.gantt import PictureTitle, gantt
from nctakt.schedule.reports.report import analysis_report, simulation_report
from nctakt.schedule.simulation.simulate import simulate

LOADS = (
    None,
    load_text(TIGHT),
    load_text(TIGHT, extra="[machine]\ncpus = 2\noffline = [1]\n"),
    load_text(TIGHT, extra="[machine]\ncpus = 3\nwindows_cpus = [9]\n"),
    load_text(TIGHT, extra="[machine]\ncpus = 1\nwindows_cpus = []\n"),
    load_text(TIGHT | {"task_int": 0, "task_rnd": 4294967294}),
    load_text(TIGHT, extra="[interrupt]\nperiod = 0.001\njitter = 5\ndrift = 0.5\n"),
)


@pytest.mark.nightly
@pytest.mark.slow
@given(
    st.sampled_from([EXAMPLE_1, EXAMPLE_2, "End\n", ""]),
    st.lists(st.tuples(st.sampled_from(KEYS), st.sampled_from(VALUES)), max_size=5),
    st.sampled_from(LOADS),
    st.sampled_from(sorted(PROFILES)),
    st.sampled_from(["skip", "pend", "queue"]),
)
@settings(max_examples=300 if is_compiled() else 60, deadline=None)
def test_nothing_fails(
    text: str, changes: list[tuple[str, str]], load: str | None, name: str, overflow: str
) -> None:
    """Whatever the list says, it is shown, simulated, analysed and drawn, or refused by number."""
    data = with_line(text, *(f"{key} {value}" for key, value in changes)).encode()
    collector = Collector()
    options = RtconfOptions(profile=PROFILES[name])
    configuration = load_rtconf("rtconf.lis", data, collector, options)
    rows = effective_rows("rtconf.lis", data, configuration, collector.diagnostics, "de")
    assert rows
    findings = Collector()
    loaded = ASSUMED if load is None else read_load("load.toml", load, findings)
    policy = "skip" if overflow == "skip" else "pend" if overflow == "pend" else "queue"
    model = assemble(configuration, loaded, options.profile, findings, rules=Rules(policy))
    for found in (*collector.diagnostics, *findings.diagnostics):
        assert found.render("en") and found.render("de")
    if any(one.severity is Severity.ERROR and one.id < 1_000_000 for one in findings.diagnostics):
        return
    run = simulate(model, 20, record=6)
    analysis = analyse(model)
    for found in (*simulation_findings(run), *analysis_findings(analysis)):
        assert found.render("en") and found.render("de")
    assert simulation_report(run, simulate_worst_phases(run), "de")
    if configuration.threads:
        assert analysis_report(analysis, find_margins(model), run, "en")
    assert svg(gantt(run, PictureTitle("rtconf.lis"), "de")).endswith("</svg>\n")
