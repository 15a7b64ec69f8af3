# SPDX-License-Identifier: MIT
"""P-STUP-00145, P-EXTV-00002: the places of V.E variables are those of C structures."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from support.variable_machines import NESTED, folder_with, machine_with

from nctakt.hli.variables_c_header import describe_c
from nctakt.hli.variables_memory import describe, image_bytes, sections
from nctakt.lists.machine.external.variables_layout import Field
from nctakt.lists.machine.machine import load_machine

COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")


def places(fields: list[Field]) -> dict[str, int]:
    """Path -> offset."""
    return {field.path: field.offset for field in fields}


#: By hand, for pack 1, 2, 4 and 8. INNER: LONG 4, BYTES 3, TEXT 5, WORD 2 bytes: 14, with pack 2 on
#: WORD at 12; 4 and 8 pad to 16. OUTER: FLAG 1, REAL 8, SHORT 2, two INNER, LAST 1 byte.
EXPECTED = {
    1: {
        "FIRST": 0,
        "o": 1,
        "REAL": 1,
        "SHORT": 9,
        "INNER": 11,
        "inner": 14,
        "LAST": 39,
        "outer": 40,
    },
    2: {
        "FIRST": 0,
        "o": 2,
        "REAL": 2,
        "SHORT": 10,
        "INNER": 12,
        "inner": 14,
        "LAST": 40,
        "outer": 42,
    },
    4: {
        "FIRST": 0,
        "o": 4,
        "REAL": 4,
        "SHORT": 12,
        "INNER": 16,
        "inner": 16,
        "LAST": 48,
        "outer": 52,
    },
    8: {
        "FIRST": 0,
        "o": 8,
        "REAL": 8,
        "SHORT": 16,
        "INNER": 20,
        "inner": 16,
        "LAST": 52,
        "outer": 56,
    },
}


@pytest.mark.parametrize("alignment", [1, 2, 4, 8])
def test_members_are_where_a_c_compiler_puts_them(tmp_path: Path, alignment: int) -> None:
    """Members are padded to their own size or to the alignment, structures to their strictest."""
    found = places(describe(machine_with(tmp_path, NESTED, alignment), 1))
    by_hand = EXPECTED[alignment]
    for element in range(2):
        base = by_hand["o"] + element * by_hand["outer"]
        name = f"OUTERS[{element}]"
        assert found[f"{name}.FLAG"] == base
        for member in ("REAL", "SHORT", "LAST"):
            assert found[f"{name}.{member}"] == base + by_hand[member]
        for inner in range(2):
            place = base + by_hand["INNER"] + inner * by_hand["inner"]
            offsets = {"LONG": 0, "BYTES": 4, "TEXT": 7, "WORD": 12}
            for member, offset in offsets.items():
                assert found[f"{name}.INNER[{inner}].{member}"] == place + offset
    end = by_hand["o"] + 2 * by_hand["outer"]
    assert found["BEHIND"] == -(-end // alignment) * alignment


def test_automatic_alignment_is_8(tmp_path: Path) -> None:
    """P-STUP-00145 = 0: as with 8."""
    automatic = describe(machine_with(tmp_path / "0", NESTED, 0), 1)
    assert automatic == describe(machine_with(tmp_path / "8", NESTED, 8), 1)


def test_arrays_of_numbers_are_one_field(tmp_path: Path) -> None:
    """``describe`` gives path, offset, type, elements and bytes of an element."""
    found = describe(machine_with(tmp_path, NESTED), 1)
    assert found[0] == Field("FIRST", 0, "BOOLEAN", 0, 1)
    assert Field("OUTERS[1].INNER[0].BYTES", 88, "UNS08", 3, 1) in found
    assert Field("OUTERS[1].INNER[0].TEXT", 91, "VSTRING", 0, 5) in found


GIVEN = """
number_used_variables 4
var[0].name A
var[0].type UNS08
var[0].byte_offset 3
var[1].name B
var[1].type REAL64
var[2].name C
var[2].type REAL64
var[2].byte_offset 41
var[3].name D
var[3].type UNS16
"""


def test_a_given_place_is_taken_as_it_is(tmp_path: Path) -> None:
    """P-EXTV-00002: without regard to alignment; what has none is after the one before."""
    machine = machine_with(tmp_path, GIVEN)
    assert places(describe(machine, 1)) == {"A": 3, "B": 8, "C": 41, "D": 50}
    assert [(one.offset, one.size_bytes) for one in sections(machine)] == [(0, 0), (0, 52)]
    assert image_bytes(machine) == 64


def test_global_and_channel_variables_have_sections_of_their_own() -> None:
    """GLOBAL first, then each channel at the next multiple of 64; V.CH is nowhere."""
    machine = load_machine(None)
    assert [one.channel for one in sections(machine)] == [0, 1]
    assert sections(machine)[1].offset == 64
    assert list(places(describe(machine))) == ["VALUE", "VALUE1", "TRIGGER", "FLAGS"]
    assert places(describe(machine, 1))["VALUE2"] == 0
    names = [field.path for one in (0, 1) for field in describe(machine, one)]
    assert "Total" not in names
    assert "VarTest1" not in names


def compiled(header: str, fields: list[Field], struct: str, folder: Path) -> dict[str, int]:
    """What the compiler says of each path."""
    assert COMPILER is not None
    (folder / "ve.h").write_text(header, "utf-8")
    prints = [f'printf("{f.path} %zu\\n", offsetof({struct}, {f.path}));' for f in fields]
    size = f'printf("size %zu\\n", sizeof({struct}));'
    body = "\n".join(("#include <stdio.h>", '#include "ve.h"', "int main(void) {", *prints, size))
    (folder / "t.c").write_text(body + "\nreturn 0; }\n", "utf-8")
    program = folder / "t"
    command = [COMPILER, "-std=c11", "-Wall", "-Werror", "-o", str(program), str(folder / "t.c")]
    subprocess.run(command, check=True)
    out = subprocess.run([str(program)], check=True, capture_output=True, encoding="utf-8").stdout
    return {name: int(offset) for name, offset in re.findall(r"(\S+) (\d+)\n", out)}


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
@pytest.mark.parametrize("alignment", [0, 1, 2, 4, 8])
def test_the_header_has_the_same_places(tmp_path: Path, alignment: int) -> None:
    """``describe_c``: a C compiler finds each member where ``describe`` says."""
    machine = machine_with(tmp_path, NESTED, alignment)
    fields = describe(machine, 1)
    found = compiled(describe_c(machine), fields, "ve_channel_1", tmp_path)
    assert found.pop("size") == sections(machine)[1].size_bytes
    assert found == places(fields)


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
def test_the_header_keeps_given_places(tmp_path: Path) -> None:
    """Gaps are members; the section is as long as its variables."""
    machine = machine_with(tmp_path, GIVEN)
    found = compiled(describe_c(machine), describe(machine, 1), "ve_channel_1", tmp_path)
    assert found == {"A": 3, "B": 8, "C": 41, "D": 50, "size": 52}


AWKWARD = """
number_used_variables 4
struct[0].name int
struct[0].element[0].name double
struct[0].element[0].type REAL64
var[0].name char
var[0].type int
var[1].name OVER
var[1].type UNS16
var[1].byte_offset 2
var[2].name while
var[2].type STRING
var[2].array_elements 2
var[2].byte_offset 16
var[3].name SHARED
var[3].type int
var[3].scope GLOBAL
"""


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
def test_the_header_is_c_whatever_the_names_are(tmp_path: Path) -> None:
    """Words of C get an underscore; what overlaps is no member and has its place as a number."""
    machine = machine_with(tmp_path, AWKWARD)
    header = describe_c(machine)
    assert "#define VE_CHANNEL_1_OFFSET_OF_OVER 2" in header
    fields = [Field("char_.double_", 0, "", 0, 0), Field("SHARED.double_", 0, "", 0, 0)]
    assert compiled(header, fields[:1], "ve_channel_1", tmp_path)["char_.double_"] == 0
    assert compiled(header, fields[1:], "ve_global", tmp_path)["SHARED.double_"] == 0
    assert "char while_[2][24];" in header


@pytest.mark.parametrize(("switch", "reported"), [(0, []), (1, [21848, 21848])])
def test_overlapping_places_are_reported_on_request(
    tmp_path: Path, switch: int, reported: list[int]
) -> None:
    """P-EXTV-00011 leaves out what overlaps; without it the one written last is what is seen."""
    lists = AWKWARD.replace("byte_offset 16", "byte_offset 3")
    folder = folder_with(tmp_path, f"{lists}check_overlapping_variables {switch}")
    loaded = load_machine(folder)
    assert [one.id for one in loaded.diagnostics] == reported
    if reported:
        texts = [one.text("en") for one in loaded.diagnostics]
        assert "V.E.OVER at byte 2 overlaps V.E.char " in texts[0]
        assert "V.E.while at byte 3 overlaps V.E.char " in texts[1]
    left = {"char"} if reported else {"char", "OVER", "while"}
    assert {name.split(".")[0] for name in places(describe(loaded, 1))} == left


def test_a_place_has_a_limit(tmp_path: Path) -> None:
    """P-EXTV-00002 up to 16777215; beyond it (21988) there is no variable."""
    for offset, reported in ((16_777_215, []), (16_777_216, [21988])):
        lists = f"number_used_variables 1\nvar[0].name A\nvar[0].byte_offset {offset}"
        loaded = load_machine(folder_with(tmp_path / str(offset), lists))
        assert [one.id for one in loaded.diagnostics] == reported
        assert places(describe(loaded, 1)) == ({} if reported else {"A": offset})
