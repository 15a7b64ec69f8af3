# SPDX-License-Identifier: MIT
"""Checking entries against declared parameters."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from nctakt.base.diagnostics import Text, whole_file
from nctakt.lists.all_parameters import SCHEMAS, find_parameters
from nctakt.lists.declared.schemas import AXIS, CHANNEL, RTCONF, VARIABLES
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.parameter import Parameter, ValueType, shown
from nctakt.lists.format.reader import ListDialect
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.table import ParameterTable
from nctakt.lists.format.values import Values
from nctakt.lists.format.without_effect import Detail
from nctakt.messages import Collector


def load(
    schema: Schema, text: str, *, base: Values | None = None, detail: Detail = "summary"
) -> tuple[Values, list[int]]:
    """The values of a list and the numbers of what was found."""
    collector = Collector()
    values = load_list(schema, "x.lis", text.encode(), collector, base=base, detail=detail)
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")
    return values, [found.id for found in collector.diagnostics]


def test_hexadecimal_and_signed_numbers() -> None:
    """Lists other than rtconf.lis have hexadecimal and signed numbers."""
    values, found = load(AXIS, "kenngr.achs_mode 0x400001\nkenngr.swe_neg -5\nkenngr.swe_pos +7\n")
    assert found == []
    assert values.integer("kenngr.achs_mode") == 0x400001
    assert values.integer("kenngr.swe_neg") == -5
    assert values.integer("kenngr.swe_pos") == 7


def test_missing_end_and_comment_styles_are_silent_outside_rtconf() -> None:
    """Vendors' lists end without End and comment with '#' without a blank: no finding."""
    assert load(AXIS, "#comment\n   # indented\n#\n")[1] == []


@pytest.mark.parametrize(
    ("text", "flags"),
    [
        ("MOS", ("MOS",)),
        ("MOS (comment", ("MOS",)),
        ("PLC_INFO | MVS_SVS", ("MVS_SVS", "PLC_INFO")),
        ("PLC_INFO|MVS_SVS 0x00020002", ("MVS_SVS", "PLC_INFO")),
        ("0x00020002   PLC_INFO,  MVS_SVS", ("MVS_SVS", "PLC_INFO")),
        ("PLC_INFO, MVS_SVS", ("MVS_SVS", "PLC_INFO")),
        ("MVS_SVS | 0x20000", ("MVS_SVS", "PLC_INFO")),
        ("8", ("MNS_SNS",)),
        ("0", ("NO_SYNCH",)),
        ('"MOS"', ("MOS",)),
    ],
)
def test_flag_sets(text: str, flags: tuple[str, ...]) -> None:
    """Flags are joined by '|' or commas, by name or by their bits; a comment may follow."""
    values, found = load(CHANNEL, f"m_synch[7] {text}\n")
    assert (values.names("m_synch[]", 7), found) == (flags, [])


@pytest.mark.parametrize("text", ["MOSS", "0x40", "MOS#", "MOS | ?", "-1", "MVS_SVS | WRONG"])
def test_wrong_synchronisation_becomes_mvs_svs(text: str) -> None:
    """A synchronisation type that does not exist is 20764 and counts as MVS_SVS."""
    values, found = load(CHANNEL, f"m_synch[7] {text}\n")
    if text == "MOS | ?":
        assert (values.names("m_synch[]", 7), found) == (("MOS",), [])
        return
    assert (values.names("m_synch[]", 7), found) == (("MVS_SVS",), [20764])


def test_flag_set_without_a_value() -> None:
    """A flag set needs a flag."""
    values, found = load(CHANNEL, "m_synch[7]\n")
    assert (values.names("m_synch[]", 7), found) == (("NOT_VALID",), [900013])


@pytest.mark.parametrize(
    ("text", "value", "numbers"),
    [
        ("1", True, []),
        ("0", False, []),
        ("TRUE", True, []),
        ("false", False, []),
        ("0x1", True, []),
        ("YES", True, [1019]),
        ("2", True, [1023]),
    ],
)
def test_truth_values_in_a_variables_list(text: str, value: bool, numbers: list[int]) -> None:
    """Variables lists have TRUE and FALSE beside 1 and 0; a wrong word leaves the default."""
    values, found = load(VARIABLES, f"var[0].synchronisation {text}\n")
    assert (values.flag("var[].synchronisation", 0), found) == (value, numbers)


def test_truth_words_are_refused_in_rtconf() -> None:
    """rtconf.lis has 0 and 1 only (its manual), the other lists TRUE and FALSE as well."""
    assert load(RTCONF, "thread[0].error_on_overflow TRUE\nEnd\n")[1] == [2022]
    values, numbers = load(CHANNEL, "exact_stop_after_g00 TRUE\n")
    assert (values.flag("exact_stop_after_g00"), numbers) == (True, [])


@pytest.mark.parametrize(
    ("text", "value", "numbers"),
    [
        ("1000", 1000.0, []),
        ("1000.5", 1000.5, []),
        ("1.5e3", 1500.0, []),
        (".5", 0.5, []),
        ("0x10", 16.0, []),
        ("-1", 0.0, [21305]),
        ("nan", 0.0, [2022]),
        ("inf", 0.0, [2022]),
        ("1e999", 0.0, [2022]),
        ("1,5", 0.0, [2022]),
    ],
)
def test_real_numbers(text: str, value: float, numbers: list[int]) -> None:
    """A REAL64 parameter takes decimal points and exponents, only finite values."""
    values, found = load(CHANNEL, f"prog_start.feedrate {text}\n")
    assert (values.real("prog_start.feedrate"), found) == (value, numbers)


@pytest.mark.parametrize(
    ("key", "low", "high", "default"),
    [
        ("rt_cycles.max_duration", 1, 65534, 75),
        ("rt_cycles.cont_steps", 1, 2**32 - 2, 100),
        ("rt_cycles.max_steps", 1, 2**32 - 2, 2**32 - 2),
        ("configuration.rt_cycles.memory", 0, 2**32 - 2, 48000),
        ("configuration.rt_cycles.buffers", 0, 65534, 5),
        ("configuration.decoder.v_ch_memory", 0, 2**32 - 2, 0),
    ],
)
def test_limits_of_realtime_cycles(key: str, low: int, high: int, default: int) -> None:
    """RC-5xx: ranges are kept at both ends, outside them the default is used."""
    assert load(CHANNEL, "")[0].integer(key) == default
    for value in (low, high):
        values, found = load(CHANNEL, f"{key} {value}\n")
        assert (values.integer(key), found) == (value, [])
    for value, number in ((low - 1, 1024), (high + 1, 1023)):
        values, found = load(CHANNEL, f"{key} {value}\n")
        assert (values.integer(key), found) == (default, [number])


@pytest.mark.parametrize(
    ("old", "new", "numbers"),
    [
        ("rt_cycles.enable", "configuration.rt_cycles.enable", []),
        ("rt_cycles.memory", "configuration.rt_cycles.memory", []),
        ("v_ch_memory", "configuration.decoder.v_ch_memory", [900024]),
        ("twincat.context.geo", "schedule.context.geo", []),
    ],
)
def test_old_names(old: str, new: str, numbers: list[int]) -> None:
    """Old names work, silently or with a warning as the manual has it."""
    values, found = load(CHANNEL, f"{old} 1\n")
    assert (values.get(new), found) == (1, numbers)


@pytest.mark.parametrize(
    "entry", ["syn_chk.fehler_gesamt 20", "syn_chk.fehler_pro_zeile 2", "syn_chk.interaktiv 1"]
)
def test_old_names_of_parameters_without_effect(entry: str) -> None:
    """Pages 149227915, 149226379, 149229451: the syntax up to V2.11 is known, and checked."""
    assert load(CHANNEL, f"{entry}\n")[1] == [900024]


def test_the_old_name_of_the_kind_of_homing() -> None:
    """Page 117265547: it has the effect of the present one."""
    values, found = load(AXIS, "kenngr.homing_type DISABLED\n")
    assert (values.text("kenngr.homing.homing_type"), found) == ("DISABLED", [900024])


def test_each_unknown_entry_is_a_warning_at_its_line() -> None:
    """Up to 20 of a file; one more finding counts the others, or names them if all are wanted."""
    text = "".join(f"vendor.own_{number} 1\n" for number in range(23))
    assert load(CHANNEL, text)[1] == [900008] * 20 + [900010]
    assert load(CHANNEL, text, detail="all")[1] == [900008] * 23


@pytest.mark.parametrize(
    ("entry", "number"),
    [
        ("max_vb_overide 1000", 900009),
        ("max_vb_override_x 1000", 900009),
        ("max_bv_override 1000", 900009),
        ("MAX_VB_OVERRIDE 1000", 900009),
        ("einrechnen_mit_d 1", 900009),
        ("max_vb_overrides_of_ours 1000", 900008),
        ("a 1", 900008),
        ("override 1", 900008),
    ],
)
def test_a_misspelt_entry_names_the_one_that_is_meant(entry: str, number: int) -> None:
    """One or two letters too many, too few, wrong or swapped; a name that is farther is unknown."""
    assert load(CHANNEL, entry + "\n")[1] == [number]


def test_entries_without_effect_are_silent_at_their_default() -> None:
    """A parameter without effect is checked; with all details it is reported."""
    text = "gruppe[0].bezeichnung IPO 1 # x\ncoordinate_system.rotation_sequence ZYX\n"
    assert load(CHANNEL, text)[1] == [900018]
    assert load(CHANNEL, text, detail="all")[1] == [900018, 900026, 900026]


def test_what_would_change_a_run_is_reported_once_for_the_file() -> None:
    """One finding names the entries; with "effects" each has one of its own."""
    text = (
        "mode_exact_stop_indp_axis 1\ncorr_v_trans_jerk 1\n"
        "mode_exact_stop_indp_axis 2\ndebug.prg_trace 1\n"
        "p_param_haltend 1\nversch_im_durchm 0\n"
    )
    assert sorted(load(CHANNEL, text)[1]) == [900023, 900028, 900029]
    assert sorted(load(CHANNEL, text, detail="effects")[1]) == [900023, 900970, 900970, 900971]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("getriebe[0].dynamik.vb_max 90000\ngetriebe[0].vb_eilgang 100000\n", 90_000),
        ("getriebe[0].vb_eilgang 300000\n", 200_000),
        ("getriebe[0].vb_eilgang 0\n", 166_666),
    ],
)
def test_a_rapid_speed_above_the_highest_speed(text: str, value: int) -> None:
    """P-AXIS-00209 ≤ P-AXIS-00212: the bound takes its place; 0 is out of range."""
    values, numbers = load(AXIS, text)
    assert values.integer("getriebe[].vb_eilgang", 0) == value
    assert numbers == ([110085] if value != 166_666 else [110084])


def test_bounds_of_other_parameters() -> None:
    """Accelerations ≤ a_max, ramp times ≥ tr_min, speeds ≤ vb_max, also without effect here."""
    text = (
        "getriebe[0].dynamik.a_max 500\ngetriebe[0].slope_profil.a_beschl 600\n"
        "getriebe[0].dynamik.tr_min 20000\ngetriebe[0].slope_profil.tr_grenz 10000\n"
        "getriebe[0].dynamik.a_emergency 1001\nkenngr.vb_messen 300000\n"
    )
    values, numbers = load(AXIS, text)
    assert sorted(numbers)[:4] == [110101, 110114, 110243, 110322]
    assert values.integer("getriebe[].slope_profil.a_beschl", 0) == 500
    assert values.integer("getriebe[].slope_profil.tr_grenz", 0) == 20_000


def test_a_list_that_lowers_a_bound_of_its_defaults_list() -> None:
    """The entry of the defaults list keeps the bound; the finding is in the list itself."""
    base, _ = load(AXIS, "getriebe[0].slope_profil.a_beschl 900\n")
    values, numbers = load(AXIS, "getriebe[0].dynamik.a_max 400\n", base=base)
    assert numbers == [110101]
    assert values.integer("getriebe[].slope_profil.a_beschl", 0) == 400


def test_specific_list_goes_over_the_defaults_list() -> None:
    """What a list does not name comes from the defaults list, what is defective too."""
    base, _ = load(AXIS, "kenngr.swe_pos 5\ngetriebe[0].kv 2000\nkenngr.swe_neg -5\n")
    values, found = load(AXIS, "kenngr.swe_pos 7\nkenngr.swe_neg x\n", base=base)
    assert found == [2022]
    assert values.integer("kenngr.swe_pos") == 7
    assert values.integer("kenngr.swe_neg") == -5
    assert values.integer("getriebe[].kv", 0) == 2000
    assert values.integer("getriebe[].kv", 1) == 1000


def test_references_take_the_value_of_another_parameter() -> None:
    """P-AXIS-00212.0 is the value of that parameter for gear step 0, wherever it is used."""
    text = "getriebe[0].vb_eilgang P-AXIS-00212.0 (comment\ngetriebe[1].vb_eilgang P-AXIS-00212\n"
    base, found = load(AXIS, text)
    assert found == []
    assert base.integer("getriebe[].vb_eilgang", 0) == 200_000
    own = "getriebe[0].dynamik.vb_max 90000\ngetriebe[1].dynamik.vb_max 80000\n"
    values, found = load(AXIS, own, base=base)
    assert found == []
    assert values.integer("getriebe[].vb_eilgang", 0) == 90_000
    assert values.integer("getriebe[].vb_eilgang", 1) == 80_000


@pytest.mark.parametrize(
    "text",
    [
        "getriebe[0].vb_eilgang P-AXIS-99999.0",
        "getriebe[0].vb_eilgang P-AXIS-00209.0",
        "getriebe[0].vb_eilgang P-AXIS-00297",
        "getriebe[0].vb_eilgang P-AXIS-00212.0\ngetriebe[0].dynamik.vb_max P-AXIS-00209.0",
        "kopf.achs_nr P-AXIS-00212",
    ],
)
def test_broken_references_leave_the_default(text: str) -> None:
    """A reference to nothing, to itself, to a text or in a circle is reported."""
    values, found = load(AXIS, text + "\n")
    assert found == [2052] * (text.count("\n") + 1)
    assert values.integer("getriebe[].vb_eilgang", 0) == 166_666


def test_name_parameters_take_names_and_numbers() -> None:
    """An axis type is its name or its number."""
    for text in ("ACHSTYP_SPINDEL", "4", "0x0004", '"ACHSTYP_SPINDEL"'):
        values, found = load(AXIS, f"kenngr.achs_typ {text}\n")
        assert (values.text("kenngr.achs_typ"), found) == ("ACHSTYP_SPINDEL", [])
    assert load(AXIS, "kenngr.achs_typ 3\n")[1] == [2021]


def test_scope_that_does_not_exist_is_the_controllers_own_number() -> None:
    """P-EXTV-00004: a wrong scope is 21196 and counts as CHANNEL."""
    values, found = load(VARIABLES, "var[0].scope LOCAL\n")
    assert (values.text("var[].scope", 0), found) == ("CHANNEL", [21196])


def test_values_given_by_a_list_have_a_place() -> None:
    """Where an entry is can be reported later; without one it is the file as a whole."""
    values, _ = load(CHANNEL, "\n  exact_stop_after_g00 1\n")
    span, line = values.position("exact_stop_after_g00")
    assert (span.line, span.column, line) == (2, 3, "  exact_stop_after_g00 1")
    assert values.position("max_vb_override")[0] == whole_file("x.lis")


def test_each_parameter_is_well_declared() -> None:
    """IDs, texts in both languages, defaults within their own range, unique names."""
    for schema in SCHEMAS:
        for parameter in schema.parameters:
            assert re.fullmatch(r"(P-[A-Z]{4}-\d{5})?", parameter.id)
            assert parameter.text.en and parameter.text.de
            assert parameter.text.en != parameter.text.de
            _check_default(parameter)


def _check_default(parameter: Parameter) -> None:
    default = parameter.default
    if parameter.type is ValueType.FLAGS:
        assert isinstance(default, tuple) and all(name in parameter.names for name in default)
    elif parameter.type is ValueType.NAME:
        assert default in parameter.names
    elif parameter.type is ValueType.BOOLEAN:
        assert isinstance(default, bool)
    elif parameter.type is ValueType.STRING:
        assert isinstance(default, str)
    elif default is not None and parameter.id != "P-RTCF-00001":
        assert isinstance(default, int | float) and parameter.allows(default)


def test_parameters_are_found_by_id_and_by_name() -> None:
    """The explanation finds P-CHAN-00425 and rt_cycles.max_duration alike."""
    for name in ("P-CHAN-00425", "p-chan-00425", "rt_cycles.max_duration"):
        (found,) = find_parameters(name)
        assert (found.schema.kind, found.parameter.default) == ("channel", 75)
    (found,) = find_parameters("thread[3].context")
    assert found.parameter.id == "P-RTCF-00017"
    assert find_parameters("P-RTCF-00016") == ()


def test_values_are_shown_as_a_list_writes_them() -> None:
    """Messages show defaults in the notation of the lists."""
    assert [shown(value) for value in (True, 5, ("A", "B"), "", None)] == [
        "1",
        "5",
        "A | B",
        '""',
        "–",
    ]


def test_names_are_declared_once(tmp_path: Path) -> None:
    """Two parameters with one name are a mistake of ours."""
    row = "\ta\tUNS16\t0\t\t\t\t\tused\t\t\ta\tb\n"
    table = tmp_path / "x.tsv"
    table.write_text(f"id\tentry\n{row}{row}", "utf-8")
    schema = Schema("x", Text("x", "y"), ListDialect(), ParameterTable(str(table)))
    with pytest.raises(AssertionError):
        schema.find("a")


@pytest.mark.parametrize(
    ("text", "bound"),
    [("", "10000"), ("getriebe[0].dynamik.tr_min 20000\n", "20000")],
)
def test_a_value_out_of_range_names_entry_and_value_of_its_bound(text: str, bound: str) -> None:
    """P-AXIS-00200 ≥ P-AXIS-00201, whose default is 10000, wherever the list has it."""
    collector = Collector()
    lines = f"getriebe[0].slope_profil.tr_grenz -40000\n{text}"
    load_list(AXIS, "x.lis", lines.encode(), collector)
    (found,) = [one for one in collector.diagnostics if one.id == 110243]
    reported = f"P-AXIS-00201 (getriebe[0].dynamik.tr_min = {bound}) … 4294967295"
    assert f"-40000 is outside {reported}" in found.text()
    assert reported in found.remedy()
