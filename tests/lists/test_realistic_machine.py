# SPDX-License-Identifier: MIT
"""A machine folder of realistic size, invented, with all findings that it must give.

Two channels, ten axes, 200 variables, 61 tools, offsets, nested indices, hexadecimal numbers, flag
sets, a list in Latin-1, back-slashes and other letter case in paths, and wrong entries.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from support.insides import machine_of

from nctakt.checking.check import check_files
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.run.controller import Controller, NcText

FOLDER = Path(__file__).parent.parent / "machines" / "centre"

#: Each finding: the list, the line (0: no place), the number of the message.
EXPECTED = (
    ("", 0, 260102),  # schedule.context.geo 3 of channel 2 has no thread
    ("achs_mds2.lis", 4, 900075),  # software limits swapped
    ("achs_mds3.lis", 4, 1024),  # a_max -1
    ("achs_mds3.lis", 5, 2022),  # 20Om, with a letter
    *(("achs_mds6.lis", line, 110303) for line in range(4, 24)),  # the vendor's own
    ("achs_mds6.lis", 24, 900010),  # 5 more
    ("achs_mds8.lis", 4, 110066),  # gear step 3
    ("default_sda.lis", 62, 20764),  # no such synchronisation
    ("default_sda.lis", 63, 2009),  # m_synch[1000]
    ("hochlauf.lis", 34, 1001117),  # hmi_startup_picture
    ("hochlauf.lis", 4, 900063),  # back-slashes, and SDA_MDS2.lis
    ("hochlauf.lis", 26, 900745),  # an axis list as clamp offsets
    ("hochlauf.lis", 30, 1000178),  # alignment 3
    ("nullp_d1.lis", 2, 20585),  # default group 9
    ("nullp_d1.lis", 38, 900742),  # offsets of G53
    ("nullp_d1.lis", 39, 900741),  # axis 5 of 5
    ("rtconf.lis", 4, 1000153),  # cycle_time 1750, time_slice 500
    ("rtconf.lis", 17, 2009),  # thread[10]
    ("rtconf.lis", 18, 900008),  # hsc_time
    ("sda_mds1.lis", 27, 2021),  # G72 at program start
    ("sda_mds1.lis", 28, 2022),  # 1000,5
    ("sda_mds2.lis", 10, 900750),  # axis 5 belongs to channel 1 already
    ("sda_mds2.lis", 12, 900024),  # v_ch_memory
    ("ve_var1.lis", 1, 900000),  # Latin-1
    ("ve_var1.lis", 627, 20788),  # Zähler
    ("ve_var1.lis", 631, 21196),  # scope MACHINE
    ("ve_var1.lis", 631, 900023),  # var[30].scope twice
    ("ve_var2.lis", 19, 900078),  # SHARED_3 is GLOBAL, UNS32 in channel 2
    ("ve_var2.lis", 209, 20088),  # UNS64
    ("werkz_d1.lis", 306, 900008),  # holder_id
    ("werkz_d1.lis", 302, 900740),  # tool 0
    ("werkz_d1.lis", 303, 900741),  # axis 7 of 5
    ("werkz_d1.lis", 304, 2009),  # tool 201
    ("werkz_d1.lis", 305, 1023),  # unit 2
)


def findings(machine: Machine) -> list[tuple[str, int, int]]:
    """List, line and number of what was found, in order."""
    return sorted(
        (Path(one.span.file).name, one.span.line, one.id) if one.span else ("", 0, one.id)
        for one in machine.diagnostics
    )


def test_all_findings_and_no_other() -> None:
    """Each wrong entry is reported once, with its place."""
    assert findings(load_machine(FOLDER)) == sorted(EXPECTED)


def test_verbose_names_the_unknown_entries_one_by_one() -> None:
    """27 unknown entries in three lists; entries without effect are named as well."""
    counts = Counter(number for _, _, number in findings(load_machine(FOLDER, detail="all")))
    assert counts[900010] == 0
    assert counts[900008] + counts[110303] + counts[1001117] == 27 + 1  # and hsc_time
    assert counts[900026] > 0


def test_what_results_is_a_machine() -> None:
    """Everything else is taken as it is."""
    machine = load_machine(FOLDER)
    first, second = machine.channels
    assert [axis.name for axis in first.axes] == ["X", "Y", "Z", "A", "C"]
    assert [axis.name for axis in second.axes] == ["X", "Y", "Z"]
    assert [spindle.name for spindle in first.spindles] == ["S", "S2"]
    assert len(machine.axes) == 10
    assert len(machine.global_variables) == 20
    assert (len(first.external_variables), len(second.external_variables)) == (120, 79)
    assert (first.startup.look_ahead_blocks, first.startup.backward_memory_bytes) == (80, 0x200000)
    assert machine.cycle_time_us == 2000
    assert len(first.tools) == 60
    assert first.tools[60].length == 600.0
    assert first.zero_offsets.offset(7, 4) == 0.7004
    assert first.clamp_offsets.offset(1, 2) == -0.5
    assert second.clamp_offsets.groups == {}
    assert first.parameters.m_functions[103].synchronisation == "MNS_SNS"


def test_programs_run_in_both_channels() -> None:
    """With nested structures, arrays and shared variables."""
    one = NcText("one.nc", "%one\nN10 V.E.OWN_119.PLACE[1] = 2.5\nN20 G01 X5 F600\nN30 M30\n")
    two = NcText("two.nc", "%two\nN10 V.E.SHARED_7[3] = 9\nN20 G01 X7 F600\nN30 M30\n")
    controller = Controller(FOLDER)
    run = controller.run(one, channels={2: [two]})
    assert run.state == "ended"
    assert controller.read("V.E.OWN_119.PLACE[1]") == 2.5
    assert controller.read("V.E.SHARED_7[3]") == controller.read("CH2.V.E.SHARED_7[3]") == 9.0
    assert [controller.read(f"CH{n}.V.RTA.ACS.ACT_POS.X") for n in (1, 2)] == [5.0, 7.0]


def test_the_check_reports_the_folder_as_a_whole() -> None:
    """No list of the folder is checked alone."""
    checked = check_files([FOLDER], machine_of(Controller()))
    assert 900583 not in [one.diagnostic.id for one in checked.findings]
    assert len(checked.findings) == len(EXPECTED)
