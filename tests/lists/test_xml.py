# SPDX-License-Identifier: MIT
"""Lists in XML: by parameter ID, alone and mixed with ASCII lists; what a hostile file may do."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.diagnostics import Diagnostic, Severity
from nctakt.lists.declared.schemas import AXIS, RTCONF
from nctakt.lists.format import xml_reader
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import Values
from nctakt.lists.format.xml_reader import MAX_DEPTH, is_xml
from nctakt.lists.machine.list_kinds import kind_of
from nctakt.lists.machine.machine import load_machine
from nctakt.messages import Collector

HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
VERSION = '<Version Label="1"><Schema Version="1"/></Version>'


def load(schema: Schema, text: str | bytes) -> tuple[Values, list[Diagnostic]]:
    """The values of a list, and what was found."""
    collector = Collector()
    data = text if isinstance(text, bytes) else text.encode()
    values = load_list(schema, "x.xml", data, collector)
    for diagnostic in collector.diagnostics:
        assert diagnostic.render("en") and diagnostic.render("de")
    return values, collector.diagnostics


def places(diagnostics: list[Diagnostic]) -> list[tuple[int, int, int]]:
    """Number, line and column of each finding."""
    return [(one.id, one.span.line, one.span.column) for one in diagnostics if one.span]


def test_ids_with_indices_are_names() -> None:
    """Elements name parameters; those around them group."""
    text = (
        f"{HEAD}<RTConfiguration>{VERSION}\n"
        '<Threads><P-RTCF-00012.0.1 Value="task_rnd" />\n'
        '<P-RTCF-00009.3 Value="2000"/></Threads>\n<P-RTCF-00002 Value="1000"></P-RTCF-00002>\n'
        "</RTConfiguration>"
    )
    values, found = load(RTCONF, text)
    assert found == []
    assert values.text("thread[].function[].name", 0, 1) == "task_rnd"
    assert values.integer("thread[].cycle", 3) == 2000
    assert values.integer("cycle_time") == 1000


@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
def test_with_and_without_a_byte_order_mark(mark: bytes) -> None:
    """UTF-8 with either, and the text of a value as it is."""
    data = mark + '<AX_MDS><P-AXIS-00297 Value="Größe (mm) # 1"/></AX_MDS>'.encode()
    values, found = load(AXIS, data)
    assert (values.text("kopf.log_achs_name"), found) == ("Größe (mm) # 1", [])


def test_old_names_and_old_ids() -> None:
    """An ID means the parameter, whatever the name of its entry."""
    values, found = load(AXIS, '<AX_MDS><P-AXIS-00212.0 Value="0x10"/></AX_MDS>')
    assert (values.integer("getriebe[].dynamik.vb_max", 0), found) == (16, [])


def test_findings_have_line_and_column() -> None:
    """At the element for the name, at the attribute for the value."""
    text = (
        "<AX_MDS>\n"
        '  <P-AXIS-00016 Value="x1" />\n'
        '  <P-AXIS-99999 Value="1" />\n'
        '  <P-AXIS-00212.9 Value="1" />\n'
        '  <P-AXIS-00212 Value="1" />\n'
        '  ä<P-AXIS-00015   Value = "-1"/>\n'
        "  <P-AXIS-00018/>\n"
        '  <P-AXIS-00013.0 Value="500"/>\n'
        "</AX_MDS>\n"
    )
    _, found = load(AXIS, text)
    assert places(found) == [
        (2022, 2, 24),
        (110303, 3, 4),
        (2009, 4, 4),
        (110303, 5, 4),
        (110053, 6, 29),
        (900013, 7, 4),
        (900028, 8, 4),
    ]


def test_true_and_false_and_references() -> None:
    """The words of ASCII lists hold."""
    text = (
        '<AX_MDS><P-AXIS-00457 Value="TRUE"/><P-AXIS-00209.0 Value="P-AXIS-00212.0"/>'
        '<P-AXIS-00018 Value="ACHSTYP_ROTATOR"/></AX_MDS>'
    )
    values, found = load(AXIS, text)
    assert found == []
    assert values.flag("kenngr.enable_single_axis")
    assert values.integer("getriebe[].vb_eilgang", 0) == 200_000
    assert values.text("kenngr.achs_typ") == "ACHSTYP_ROTATOR"


BOMB = (
    '<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">'
    '<!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;">]>'
)


@pytest.mark.parametrize(
    ("head", "number"),
    [
        (BOMB, 900976),
        ('<!DOCTYPE a SYSTEM "file:///etc/passwd">', 900976),
        ('<!DOCTYPE a [<!ENTITY a SYSTEM "file:///etc/passwd">]>', 900976),
        ('<!DOCTYPE a [<!ENTITY % a SYSTEM "http://x/y"> %a;]>', 900976),
    ],
)
def test_entities_are_refused(head: str, number: int) -> None:
    """No document type, no entity, nothing from another file."""
    values, found = load(AXIS, f'{head}<AX_MDS><P-AXIS-00016 Value="&c;"/></AX_MDS>')
    assert [one.id for one in found] == [number]
    assert values.entry_values == {}


@pytest.mark.parametrize(
    "text",
    [
        '<AX_MDS><P-AXIS-00016 Value="5"/>',
        '<AX_MDS><P-AXIS-00016 Value="5"/></AX>',
        '<AX_MDS><P-AXIS-00016 Value="5"/><P-AXIS-00015 Value=5/></AX_MDS>',
        '<AX_MDS><P-AXIS-00016 Value="5"/>&unknown;</AX_MDS>',
        '<AX_MDS><P-AXIS-00016 Value="5"/>\0</AX_MDS>',
        '<AX_MDS><P-AXIS-00016 Value="5"/><x y="1" y="2"/></AX_MDS>',
    ],
)
def test_entries_before_a_mistake_are_read(text: str) -> None:
    """A list that is cut off or wrong ends there, with one finding."""
    values, found = load(AXIS, text)
    assert [one.id for one in found] == [900975]
    assert values.integer("kopf.achs_nr") == 5


@pytest.mark.parametrize(("depth", "numbers"), [(MAX_DEPTH - 1, []), (MAX_DEPTH, [900977])])
def test_depth_is_bounded(depth: int, numbers: list[int]) -> None:
    """Elements inside each other, the entry included."""
    inner = '<P-AXIS-00016 Value="5"/>'
    values, found = load(AXIS, "<g>" * depth + inner + "</g>" * depth)
    assert [one.id for one in found] == numbers
    assert values.is_set("kopf.achs_nr") == (not numbers)


def test_size_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """A list of more bytes is not read at all."""
    text = '<AX_MDS><P-AXIS-00016 Value="5"/></AX_MDS>'
    monkeypatch.setattr(xml_reader, "MAX_BYTES", 100)
    assert load(AXIS, text.ljust(100))[1] == []
    values, found = load(AXIS, text.ljust(101))
    assert ([one.id for one in found], values.entry_values) == ([900978], {})


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("<RTConfiguration/>", "rtconf"),
        ("<StartUp/>", "startup"),
        ("<Default_AX_MDS/>", "axis"),
        ("<SDA_MDS/>", "channel"),
        ("<ExtVar/>", "variables"),
        ("<ToolData/>", "tools"),
        ("<ZeroOffset/>", "zero_offsets"),
        ("<ClampPosOffset/>", "clamp_offsets"),
        ("<ManualMode/>", "manual_mode"),
        ("<AX_COMP/>", "axis_compensation"),
        ("<VolComp/>", "volumetric_compensation"),
        (f'{HEAD}<!-- x -->\n<Update><P-CHAN-00003.0 Value="1"/></Update>', "channel"),
        ("<html/>", None),
    ],
)
def test_the_root_or_the_ids_tell_the_kind(text: str, kind: str | None) -> None:
    """An update file has any root element: the IDs in it count."""
    schema = kind_of("x.xml", text.encode())
    assert (schema.kind if schema else None) == kind


@pytest.mark.parametrize(
    "text", ["# <a>\nkopf.achs_nr 1\n", "", "kopf.achs_nr 1 ( <x/>\n", "< 3\n"]
)
def test_ascii_lists_are_no_xml(text: str) -> None:
    """An ASCII list never begins with an element."""
    assert not is_xml(text.encode())


STARTUP = (
    f'{HEAD}<StartUp>{VERSION}<P-STUP-00001 Value="1"/><P-STUP-00014 Value="2"/>\n'
    '<P-STUP-00009.0 Value="CncKernelRootDir/listen/sda.xml"/>\n'
    '<P-STUP-00015.0 Value="CncKernelRootDir\\listen\\x.xml"/><P-STUP-00015.1 Value="y.lis"/>\n'
    '<P-STUP-00135 Value="rt.xml"/></StartUp>'
)
CHANNEL = (
    '<SDA_MDS><P-CHAN-00003.0 Value="2"/>\n<P-CHAN-00006.0.0 Value="X"/>'
    '<P-CHAN-00035.0.0 Value="1"/>\n<P-CHAN-00006.0.1 Value="Y"/><P-CHAN-00035.0.1 Value="2"/>'
    "</SDA_MDS>"
)


def test_a_machine_of_both_formats(tmp_path: Path) -> None:
    """XML and ASCII lists next to each other; paths from the controller's root folder."""
    files = {
        "startup.xml": STARTUP,
        "listen/sda.xml": CHANNEL,
        "listen/x.xml": '<AX_MDS><P-AXIS-00016 Value="1"/></AX_MDS>',
        "y.lis": "kopf.achs_nr 2\nkenngr.swe_pos 5000\n",
        "rt.xml": (
            '<RTConfiguration><P-RTCF-00001 Value="2"/><P-RTCF-00002 Value="2000"/>'
            '<P-RTCF-00003 Value="500"/><P-RTCF-00004 Value="500"/>'
            '<P-RTCF-00008.0 Value="G"/><P-RTCF-00009.0 Value="2000"/>'
            '<P-RTCF-00012.0.0 Value="task_int"/></RTConfiguration>'
        ),
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    machine = load_machine(tmp_path)
    # One path with back-slashes; the rest is about rtconf.lis.
    found = [one.id for one in machine.diagnostics if one.span and "rt.xml" not in one.span.file]
    assert found == [900063]
    assert not any(one.severity is Severity.ERROR for one in machine.diagnostics)
    assert [axis.name for axis in machine.channels[0].axes] == ["X", "Y"]
    assert machine.cycle_time_us == 2000
    assert machine.axes[1].software_limit_high == 0.5


def test_a_list_of_another_kind_is_left_out(tmp_path: Path) -> None:
    """Its root element shows it."""
    files = {
        "hochlauf.lis": "sda_mds[0] sda.xml\nachs_mds[0] x.xml\n",
        "sda.xml": CHANNEL,
        "x.xml": CHANNEL,
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    assert 900745 in [one.id for one in load_machine(tmp_path).diagnostics]
