# SPDX-License-Identifier: MIT
"""Entries of absurd size: each is reported at its line, and the machine starts without it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from nctakt.lists.machine.machine import load_machine

#: List of the demo machine, entry, findings at its line.
ENTRIES = (
    ("hochlauf.lis", "kanal_anzahl 99999", {900019, 900023}),
    ("hochlauf.lis", f"kanal_anzahl {'9' * 5000}", {900019, 900023}),
    ("hochlauf.lis", "zahl_mds 65535", {900019, 900023}),
    ("hochlauf.lis", "achs_mds[4000000000] x.lis", {900008}),
    ("hochlauf.lis", "sda_mds[12] x.lis", {2009}),
    ("hochlauf.lis", f"fb_storage_size[0] 0x{'F' * 5000}", {900019, 900023}),
    ("hochlauf.lis", f"error_text_user_of_id {'x' * 100_000}", {1021}),
    ("sda_mds1.lis", "m_synch[99999999999999999999] MOS", {900008}),
    ("sda_mds1.lis", "m_synch[-1] MOS", {900009}),
    ("sda_mds1.lis", "prog_start.feedrate 1e999999", {2022, 900023}),
    ("sda_mds1.lis", f"prog_start.feedrate {'9' * 5000}", {2022, 900023}),
    ("sda_mds1.lis", f"prog_start.feedrate 0x{'F' * 5000}", {2022, 900023}),
    ("sda_mds1.lis", f"{'a' * 1_000_000} 1", {900008}),
    ("sda_mds1.lis", f"gruppe{'[0]' * 20_000} 1", {900008}),
    ("sda_mds1.lis", "configuration.decoder.v_ch_memory 4294967295", {900019, 900023}),
    ("achs_mds1.lis", "getriebe[6].kv 1", {2009}),
    ("achs_mds1.lis", "kenngr.swe_pos 99999999999", {900019}),
    ("achs_mds1.lis", f'kopf.log_achs_name "{"X" * 5000}"', {1021, 900023}),
    ("ext_var1.lis", "number_used_variables 1000000000", {900019, 900023}),
    ("ext_var1.lis", "var[0].array_elements 4294967295", {900019}),
    ("ext_var1.lis", "var[100000].name X", {2009}),
    ("werkz_d1.lis", "wz[201].laenge 1", {2009}),
    ("werkz_d1.lis", "wz[1].laenge 99999999999", {900019, 900023}),
    ("nullp_d1.lis", "np_grp[97].achse[0].versch 1", {2009}),
    ("rtconf.lis", "cycle_time 99999999999", {900019, 900023}),
    ("rtconf.lis", "thread[10].name X", {2009}),
)


@pytest.mark.parametrize(
    ("file", "entry", "expected"),
    ENTRIES,
    ids=[f"{file}: {entry:.40}" for file, entry, _ in ENTRIES],
)
def test_an_entry_of_absurd_size_is_reported(
    tmp_path: Path, file: str, entry: str, expected: set[int]
) -> None:
    """A count, an index, a number, a text, a name or a path of elements beyond all bounds."""
    machine = tmp_path / "machine"
    shutil.copytree(load_machine(None).folder, machine)
    lines = (machine / file).read_text("utf-8").splitlines()
    lines.insert(-1, entry)
    (machine / file).write_text("\n".join(lines) + "\n", "utf-8")
    found = load_machine(machine).diagnostics
    at_line = {one.message.id for one in found if one.span and one.span.line == len(lines) - 1}
    assert at_line == expected
    assert all(len(one.text("en")) < 600 for one in found)
