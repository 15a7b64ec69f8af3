# SPDX-License-Identifier: MIT
"""How lists name each other: circles, lists of the wrong kind; nothing of it is followed."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.lists.machine.machine import load_machine

STARTUP = "kanal_anzahl 1\nsda_mds[0] kanal.lis\nzahl_mds 1\nachs_mds[0] x.lis\nrtconf_lis rt.lis\n"
CHANNEL = "gruppe[0].achse[0].bezeichnung X\ngruppe[0].achse[0].log_achs_nr 1\n"
RTCONF = (
    "interrupt_source 3 ( semaphore\nexternal_object_name S\ncycle_time 2000\ntime_slice 500\n"
    "windows_time 500\nthread[0].name GEO\nthread[0].cycle 2000\nthread[0].priority 115\n"
    "thread[0].error_on_overflow 1\nthread[0].function[0].name task_int\nEnde\n"
)


def reported(folder: Path, files: dict[str, str]) -> list[str]:
    """What loading the folder reports, but for notes: place, number, text."""
    standard = {"hochlauf.lis": STARTUP, "kanal.lis": CHANNEL, "x.lis": "kopf.achs_nr 1\n"}
    for name, text in {**standard, "rt.lis": RTCONF, **files}.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    found = load_machine(folder).diagnostics
    return [
        f"{one.span.line if one.span else 0}: {one.id} {one.text()}"
        for one in found
        if one.severity.name != "NOTE"
    ]


def test_a_start_up_list_that_names_itself(tmp_path: Path) -> None:
    """The entry leads back to the list it is in."""
    text = STARTUP + "werkz_data[0] ./HOCHLAUF.lis\n"
    (found,) = reported(tmp_path, {"hochlauf.lis": text})
    assert found == (
        "6: 900744 lists refer to each other in a circle: hochlauf.lis → hochlauf.lis; "
        "the reference is not followed"
    )


def test_start_up_lists_that_name_each_other(tmp_path: Path) -> None:
    """hochlauf.lis names b.lis as variables, b.lis names c.lis, c.lis names hochlauf.lis."""
    files = {
        "hochlauf.lis": STARTUP + "ve_var[0] b.lis\n",
        "b.lis": "kanal_anzahl 1\nsda_mds[0] c.lis\n",
        "c.lis": "zahl_mds 1\nachs_mds[0] hochlauf.lis\n",
    }
    (found,) = reported(tmp_path, files)
    assert found.startswith("6: 900744 ")
    assert "hochlauf.lis → b.lis → c.lis → hochlauf.lis;" in found


def test_a_circle_that_does_not_lead_back_ends(tmp_path: Path) -> None:
    """b.lis names itself: the search ends, and b.lis is no variables list."""
    files = {
        "hochlauf.lis": STARTUP + "ve_var[0] b.lis\n",
        "b.lis": "kanal_anzahl 1\nsda_mds[0] b.lis\n",
    }
    (found,) = reported(tmp_path, files)
    assert found == (
        "6: 900745 b.lis is ignored: it has no entries of the kind Variables list, "
        "but some of Start-up list"
    )


@pytest.mark.parametrize(
    ("entry", "found"),
    [("nullp_data[0] kanal.lis", "Channel list"), ("ve_var[0] x.lis", "Axis list")],
)
def test_a_list_of_another_kind_is_left_out(tmp_path: Path, entry: str, found: str) -> None:
    """None of its entries belongs there, and some belong elsewhere."""
    (reported_text,) = reported(tmp_path, {"hochlauf.lis": f"{STARTUP}{entry}\n"})
    assert reported_text.startswith("6: 900745 ")
    assert reported_text.endswith(found)


def test_a_list_with_unknown_entries_only_is_taken(tmp_path: Path) -> None:
    """Unknown entries say nothing about the list's kind."""
    files = {"hochlauf.lis": STARTUP + "ve_var[0] v.lis\n", "v.lis": "our.own[3].key 1\n"}
    (warning,) = reported(tmp_path, files)
    assert warning.startswith("1: 900008 ")


def test_one_list_for_two_axes_is_no_circle(tmp_path: Path) -> None:
    """The second axis has the number of the first: that is reported, and no more."""
    text = STARTUP.replace("zahl_mds 1", "zahl_mds 2") + "achs_mds[1] x.lis\n"
    found = reported(tmp_path, {"hochlauf.lis": text})
    assert [one.split()[1] for one in found] == ["110064"]
