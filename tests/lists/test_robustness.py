# SPDX-License-Identifier: MIT
"""No bytes in a list can stop a start (manual of rtconf.lis, 2.4)."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st
from support.random_seeds import examples

from nctakt.lists.all_parameters import SCHEMAS
from nctakt.lists.declared.schemas import AXIS, CHANNEL, STARTUP, VARIABLES
from nctakt.lists.declared.startup import startup_configuration
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.schema import Schema
from nctakt.lists.machine.axis_configuration import axis_configuration
from nctakt.lists.machine.channel_configuration import channel_parameters
from nctakt.lists.machine.external.variables import variables_configuration
from nctakt.lists.machine.schedules.scheduling import load_rtconf
from nctakt.messages import Collector

WORDS = ["0", "1", "-1", "7", "0x10", "99999999999", "TRUE", "MOS", "MOS | PLC_INFO", '"A', "A B"]
WORDS += ["P-AXIS-00212.0", "P-AXIS-00209", "S1", "REAL64", "(", "#", "", '"', "1e308", ".5"]


def lines(schema: Schema) -> st.SearchStrategy[str]:
    """Lines that name parameters of ``schema`` with values of all kinds."""
    names = st.sampled_from([parameter.pattern for parameter in schema.parameters])
    index = st.sampled_from(["[0]", "[1]", "[00]", "[9999999]", "[]", "[-1]"])
    key = st.builds(lambda name, at: name.replace("[]", at), names, index)
    return st.builds(lambda name, value: f"{name} {value}", key, st.sampled_from(WORDS))


def load_all(data: bytes) -> None:
    """Read ``data`` as each kind of list, and render what is found."""
    collector = Collector()
    axis_configuration(load_list(AXIS, "a", data, collector, detail="all"), collector)
    channel_parameters(load_list(CHANNEL, "c", data, collector), collector)
    startup_configuration(load_list(STARTUP, "s", data, collector), collector)
    variables = variables_configuration(load_list(VARIABLES, "v", data, collector), collector)
    for variable in variables.external:
        next(iter(variable.leaves()))
    load_rtconf("r", data, collector)
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")


@settings(max_examples=examples(150), deadline=None, derandomize=True)
@given(st.binary(max_size=200))
def test_any_bytes(data: bytes) -> None:
    """Arbitrary bytes are read to the end."""
    load_all(data)


@settings(max_examples=examples(150), deadline=None, derandomize=True)
@given(st.lists(st.one_of([lines(schema) for schema in SCHEMAS]), max_size=12))
def test_any_entries(entries: list[str]) -> None:
    """Known names with values of all kinds are read to the end."""
    load_all("\n".join(entries).encode())
