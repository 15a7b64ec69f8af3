# SPDX-License-Identifier: MIT
"""What is said of a parameter's effect is true: what "changes nothing" is read by nobody."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import nctakt
from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.format.parameter import Effect

SOURCES = Path(nctakt.__file__).parent
DOCUMENT = Path(__file__).parents[2] / "docs/machine-folders.md"

#: Each parameter that changes nothing, with the attribute that its value becomes.
WITHOUT_EFFECT = {
    "ext_var_max": "external_variables_bytes",
    "error_log_file_name": "startup.error_log",
    "configuration.diagnosis_upload.path": "diagnosis_folder",
    "configuration.diagnosis_upload.default_file": "diagnosis_file",
    "path[].id": "path.id",
    "mass_einh": "parameters.inch",
    "rund_mass_einh": "parameters.gon",
    "kenngr.swe_toleranz": "software_limit_tolerance",
    "getriebe[].dynamik.a_emergency": "emergency_deceleration",
    "getriebe[].dynamik.tr_geom": "contour_ramp_time_us",
    "getriebe[].vb_max_red": "reduced_speed",
    "getriebe[].rapid_speed_red": "reduced_rapid_speed",
    "getriebe[].window": "exact_stop_window",
    "wz[].typ": "tool.type",
    "wz[].vb_min": "least_speed",
    "wz[].vb_max": "greatest_speed",
    "wz[].a_max": "tool.max_acceleration",
}


def test_each_parameter_without_effect_is_known_here() -> None:
    """Effect.CHECKED stands at these and no other, and the document names them."""
    checked = {
        parameter.pattern: parameter.id
        for schema in SCHEMAS
        for parameter in schema.parameters
        if parameter.effect is Effect.CHECKED
    }
    assert checked.keys() == WITHOUT_EFFECT.keys()
    document = DOCUMENT.read_text(encoding="utf-8")
    assert [id_ for id_ in checked.values() if id_[-5:] not in document] == []


@pytest.mark.parametrize(("pattern", "attribute"), WITHOUT_EFFECT.items(), ids=WITHOUT_EFFECT)
def test_nobody_outside_of_the_lists_reads_it(pattern: str, attribute: str) -> None:
    """Whoever makes a parameter effective says so in its declaration."""
    reads = re.compile(rf"\b{re.escape(attribute)}\b")
    readers = [
        path.relative_to(SOURCES).as_posix()
        for path in sorted(SOURCES.rglob("*.py"))
        if path.relative_to(SOURCES).parts[0] not in ("lists", "messages")
        and reads.search(path.read_text(encoding="utf-8"))
    ]
    assert readers == [], pattern
