# SPDX-License-Identifier: MIT
"""What start-up, axis and channel lists yield."""

from __future__ import annotations

from math import inf

import pytest

from nctakt.lists.declared.schemas import AXIS, CHANNEL, STARTUP
from nctakt.lists.declared.startup import StartupConfiguration, startup_configuration
from nctakt.lists.format.list_check import load_list
from nctakt.lists.format.schema import Schema
from nctakt.lists.format.values import Values
from nctakt.lists.machine.axis_configuration import AxisConfiguration, AxisType, axis_configuration
from nctakt.lists.machine.channel_configuration import ChannelParameters, channel_parameters
from nctakt.messages import Collector


def load(schema: Schema, text: str) -> tuple[Values, Collector]:
    """The values of a list."""
    collector = Collector()
    return load_list(schema, "x.lis", text.encode(), collector), collector


def numbers(collector: Collector) -> list[int]:
    """What was found; each text can be shown."""
    for found in collector.diagnostics:
        assert found.render("en") and found.render("de")
    return [found.id for found in collector.diagnostics]


def axis(text: str) -> tuple[AxisConfiguration, list[int]]:
    """One axis."""
    values, collector = load(AXIS, text)
    return axis_configuration(values, collector), numbers(collector)


def channel(text: str) -> tuple[ChannelParameters, list[int]]:
    """One channel."""
    values, collector = load(CHANNEL, text)
    return channel_parameters(values, collector), numbers(collector)


def startup(text: str) -> tuple[StartupConfiguration, list[int]]:
    """A start-up list."""
    values, collector = load(STARTUP, text)
    return startup_configuration(values, collector), numbers(collector)


# --- axes ---


def test_axis_defaults() -> None:
    """An empty axis list is a linear axis with the manuals' defaults, in mm and seconds."""
    found, findings = axis("")
    assert findings == []
    assert (found.type, found.is_linear, found.is_modulo) == (AxisType.LINEAR, True, False)
    assert (found.max_speed, found.rapid_speed, found.max_acceleration) == (200, 166.666, 1000)
    assert (found.software_limit_low, found.software_limit_high) == (-10_000, 10_000)
    assert (found.modulo_range, found.kv, found.max_override_pct) == (0, 10, 100)
    assert (found.enable_single_axis, found.override_mode, found.follows_exactly) == (
        False,
        0,
        False,
    )


def test_axis_units() -> None:
    """0.1 µm, µm/s and 0.01/s become mm, mm/s and 1/s; 1e-4° and 1e-3°/s become degrees."""
    text = (
        "kenngr.swe_neg -12345\nkenngr.swe_pos 5\ngetriebe[0].dynamik.vb_max 1500\n"
        "getriebe[0].vb_eilgang 1250\ngetriebe[0].kv 4050\n"
    )
    found, _ = axis(text)
    assert (found.software_limit_low, found.software_limit_high) == (-1.2345, 0.0005)
    assert (found.max_speed, found.rapid_speed, found.kv) == (1.5, 1.25, 40.5)


def test_rapid_speed_is_never_above_the_highest_speed() -> None:
    """P-AXIS-00209 ends at P-AXIS-00212."""
    found, _ = axis("getriebe[0].vb_eilgang 900000\ngetriebe[0].dynamik.vb_max 500000\n")
    assert found.rapid_speed == found.max_speed == 500


@pytest.mark.parametrize(
    ("text", "feed", "rapid"),
    [
        ("a_max", 1000, 1000),
        ("a_stufe_1", 700, 1000),
        ("a_stufe_2", 600, 1000),
        ("vb_stufe_1_2", 1000, 1000),
        ("a_stufe_2 but never reached", 1000, 1000),
        ("a_grenz_stufe_1", 1000, 500),
        ("a_grenz_stufe_2", 1000, 400),
        ("a_grenz_stufe_2 but never reached", 1000, 1000),
    ],
)
def test_trapezoid_acceleration(text: str, feed: float, rapid: float) -> None:
    """The one acceleration of a trapezoid never exceeds a stage that the motion reaches."""
    slope = "getriebe[0].lslope_profil"
    lines = {
        "a_max": "",
        "a_stufe_1": f"{slope}.a_stufe_1 700",
        "a_stufe_2": f"{slope}.a_stufe_2 600",
        "vb_stufe_1_2": f"{slope}.vb_stufe_1_2 1",
        "a_stufe_2 but never reached": f"{slope}.a_stufe_2 600\n{slope}.vb_stufe_1_2 200000",
        "a_grenz_stufe_1": f"{slope}.a_grenz_stufe_1 500",
        "a_grenz_stufe_2": f"{slope}.a_grenz_stufe_2 400",
        "a_grenz_stufe_2 but never reached": (
            f"{slope}.a_grenz_stufe_2 400\n{slope}.vb_grenz_stufe_1_2 166666"
        ),
    }
    found, findings = axis(lines[text])
    assert findings == []
    assert found.dynamics.feed_acceleration == feed
    assert found.dynamics.rapid_acceleration == rapid
    assert found.max_acceleration == min(feed, rapid)


def test_highest_acceleration_bounds_the_slope() -> None:
    """P-AXIS-00008 bounds what the slope asks for."""
    found, _ = axis("getriebe[0].dynamik.a_max 300\n")
    assert found.max_acceleration == 300


def test_rotary_modulo_axis() -> None:
    """A modulo axis has a range and no software limits."""
    found, _ = axis("kenngr.achs_typ 2\nkenngr.achs_mode 0x4\n")
    assert (found.type, found.is_modulo, found.modulo_range) == (AxisType.ROTARY, True, 360)
    assert (found.software_limit_low, found.software_limit_high) == (-inf, inf)


def test_rotary_axis_without_modulo() -> None:
    """A rotary axis in linear mode has limits in degrees."""
    found, _ = axis("kenngr.achs_typ 2\nkenngr.achs_mode 0x400001\nkenngr.swe_pos 900000\n")
    assert (found.is_modulo, found.modulo_range, found.software_limit_high) == (False, 0, 90)


def test_spindle_is_modulo() -> None:
    """A spindle turns in its modulo range whatever its mode says."""
    found, _ = axis("kenngr.achs_typ 4\n")
    assert (found.type, found.modulo_range) == (AxisType.SPINDLE, 360)


@pytest.mark.parametrize(("low", "high"), [(5, 5), (9, 5)])
def test_empty_modulo_range(low: int, high: int) -> None:
    """A modulo range without length becomes 0 … 360°."""
    text = f"kenngr.achs_typ 4\ngetriebe[0].modulou {low}\ngetriebe[0].moduloo {high}\n"
    found, findings = axis(text)
    assert (found.modulo_range, findings) == (360, [110052])


def test_swapped_software_limits() -> None:
    """Software limits in the wrong order are put in order."""
    found, findings = axis("kenngr.swe_neg 10000\nkenngr.swe_pos -10000\n")
    assert findings == [900075]
    assert (found.software_limit_low, found.software_limit_high) == (-1, 1)


def test_gear_steps() -> None:
    """P-AXIS-00079 chooses a gear step by its number; the first has number 1."""
    text = "getriebe[1].nummer 2\ngetriebe[1].dynamik.vb_max 90000\n"
    found, findings = axis(f"{text}kenngr.getriebe_stufe 2\n")
    assert (found.max_speed, findings) == (90, [])
    found, findings = axis(text)
    assert (found.max_speed, findings) == (200, [])
    found, findings = axis(f"{text}kenngr.getriebe_stufe 3\n")
    assert (found.max_speed, findings) == (200, [110066])


# --- channels ---


def test_channel_defaults() -> None:
    """An empty channel list has the manuals' defaults and the internal M functions."""
    found, findings = channel("")
    assert findings == []
    assert (found.axes, found.spindles, found.h_functions) == ((), (), {})
    assert list(found.m_functions) == [0, 1, 2, 3, 4, 17, 19, 29, 30]
    assert {one.synchronisation for one in found.m_functions.values()} == {"NO_SYNCH"}
    start = found.program_start
    assert start.g_functions == {0: 0, 4: 17, 12: 71, 14: 90, 23: 162}
    assert (start.feed_mm_min, start.feed_unit_mm_min, start.slope_profile) == (0, 1, 0)
    assert (found.exact_stop_after_g00, found.max_override_pct) == (False, 100)
    limits = found.realtime_cycles
    assert (limits.enable, limits.memory_bytes, limits.buffers) == (False, 48_000, 5)
    assert (limits.max_duration_pct, limits.cont_steps, limits.max_steps) == (75, 100, 2**32 - 2)


AXES = "gruppe[0].achse[0].log_achs_nr 1\ngruppe[0].achse[0].bezeichnung X\n"
SECOND = "gruppe[0].achse[1].log_achs_nr 2\ngruppe[0].achse[1].bezeichnung {name}\n"


@pytest.mark.parametrize(
    ("count", "names", "findings"),
    [("", "XY", []), ("2", "XY", []), ("1", "X", [20428]), ("3", "XY", [20428])],
)
def test_number_of_axes(count: str, names: str, findings: list[int]) -> None:
    """P-CHAN-00003: the lesser of the number and what is described counts."""
    line = f"gruppe[0].achs_anzahl {count}\n" if count else ""
    found, reported = channel(AXES + SECOND.format(name="Y") + line)
    assert ("".join(one.name for one in found.axes), reported) == (names, findings)


@pytest.mark.parametrize("name", ["X", "S", "1", "Ä", "X-1", '""'])
def test_unusable_axis_names(name: str) -> None:
    """P-CHAN-00006: axis names begin with their letters and are unique."""
    found, findings = channel(AXES + SECOND.format(name=name))
    number = 20424 if name == "X" else 20425
    assert ([one.name for one in found.axes], findings) == (["X"], [number])


@pytest.mark.parametrize("name", ["Y", "X1", "QUER", "C_1", "U"])
def test_usable_axis_names(name: str) -> None:
    """P-CHAN-00006: a letter of axes, then letters, digits, underscores."""
    assert channel(AXES + SECOND.format(name=name))[1] == []


SPINDLES = (
    "main_spindle_ax_nr 6\nspindel[0].bezeichnung S1\nspindel[0].log_achs_nr 6\n"
    "spindel[0].m3_synch PLC_INFO | MVS_SVS\nspindel[0].m3_prozess_zeit 25\n"
    "spindel[1].bezeichnung S2\nspindel[1].log_achs_nr 7\nspindel[1].plc_control 1\n"
)


def test_spindles() -> None:
    """The main spindle has the main spindle's name; functions carry their synchronisation."""
    found, findings = channel(SPINDLES + "spdl_anzahl 2\n")
    assert findings == []
    main, second = found.spindles
    assert (main.name, main.list_name, main.is_main, main.plc_controlled) == (
        "S",
        "S1",
        True,
        False,
    )
    assert (second.name, second.is_main, second.plc_controlled) == ("S2", False, True)
    assert (main.functions["m3"].synchronisation, main.functions["m3"].modifiers) == (
        "MVS_SVS",
        ("PLC_INFO",),
    )
    assert (main.functions["m3"].number, main.functions["m3"].process_time_us) == (3, 2.5)
    assert main.functions["m19"].synchronisation == "NO_SYNCH"


@pytest.mark.parametrize(
    ("text", "findings"),
    [
        ("main_spindle_ax_nr 9\n", [21037, 900023]),
        ("spdl_anzahl 1\n", [20418]),
        ("spindel[1].bezeichnung X\n", [20971, 900023]),
        ("main_spindle_name S2\n", [20419]),
    ],
)
def test_spindles_that_contradict(text: str, findings: list[int]) -> None:
    """Numbers and names that do not fit are reported."""
    assert sorted(channel(SPINDLES + text)[1]) == findings


def test_a_function_for_an_unknown_axis_is_the_channels() -> None:
    """21131, P-CHAN-00039, P-CHAN-00025."""
    found, findings = channel("m_synch[100] MOS\nm_default_outp_ax_name[100] Q\n")
    assert findings == [21131]
    assert found.m_functions[100].axis_name == ""


def test_m_and_h_functions() -> None:
    """P-CHAN-00041, 00027: only functions that the list names are defined."""
    text = (
        "gruppe[0].achs_anzahl 1\ngruppe[0].achse[0].log_achs_nr 1\n"
        "gruppe[0].achse[0].bezeichnung X\n"
        "m_synch[100] MVS_SVS\nm_prozess_zeit[100] 15\nm_default_outp_ax_name[100] X\n"
        "m_synch[999] PLC_INFO\nm_synch[101] NOT_VALID\nh_synch[0] MNS_SNS\nm_synch[30] MOS\n"
        "m_prozess_zeit[7] 5\n"
    )
    found, findings = channel(text)
    assert findings == []
    assert list(found.m_functions) == [0, 1, 2, 3, 4, 17, 19, 29, 30, 100, 999]
    function = found.m_functions[100]
    assert (function.synchronisation, function.process_time_us, function.axis_name) == (
        "MVS_SVS",
        1.5,
        "X",
    )
    assert found.m_functions[30].synchronisation == "MOS"
    assert (found.m_functions[999].synchronisation, found.m_functions[999].modifiers) == (
        "NO_SYNCH",
        ("PLC_INFO",),
    )
    assert found.h_functions[0].synchronisation == "MNS_SNS"


@pytest.mark.parametrize("index", [1000, 1001])
def test_functions_end_at_999(index: int) -> None:
    """M and H functions are 0 … 999."""
    assert channel(f"m_synch[{index}] MOS\n")[1] == [2009]
    assert channel("m_synch[999] MOS\n")[1] == []


@pytest.mark.parametrize(
    ("low", "high", "tolerance", "found"),
    [
        (0, 100, 0, []),
        (10, 100, 9, [110055]),
        (10, 100, 10, []),
        (-100, -10, 9, [110054]),
        (-100, -10, 10, []),
        (-100, 2**31 - 5, 4, []),
        (-100, 2**31 - 5, 5, [110317]),
        (-(2**31), 100, 1, [110318]),
        (3, 100, 4_294_967_295, [110317]),
    ],
)
def test_the_tolerance_widens_the_software_limits(
    low: int, high: int, tolerance: int, found: list[int]
) -> None:
    """P-AXIS-00179: for an axis that is at 0; the limits of commands are as they were."""
    text = f"kenngr.swe_neg {low}\nkenngr.swe_pos {high}\nkenngr.swe_toleranz {tolerance}\n"
    made, reported = axis(text)
    assert reported == found
    assert (made.software_limit_low, made.software_limit_high) == (low / 10_000, high / 10_000)


def test_a_modulo_axis_has_no_software_limits() -> None:
    """P-AXIS-00015: nothing is beyond them."""
    text = "kenngr.achs_typ 2\nkenngr.achs_mode 4\nkenngr.swe_neg 10\nkenngr.swe_toleranz 0\n"
    assert axis(text)[1] == []


def test_program_paths_come_in_order_of_priority() -> None:
    """P-CHAN-00401 … 00404."""
    text = (
        "path[0].dir late\npath[0].priority 2\npath[0].type 0x02\n"
        "path[1].dir early\npath[1].priority 1\npath[1].type 3\npath[2].priority 0\n"
    )
    early, late = channel(text)[0].program_paths
    assert (early.folder, late.folder) == ("early", "late")
    assert (early.has_main_programs, early.has_subprograms) == (True, True)
    assert (late.has_main_programs, late.has_subprograms) == (False, True)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("path[0].id 1\npath[1].id 1", [20771]),
        ("path[0].id 1\npath[1].id 2", []),
        ("path[0].type 1\npath[0].priority 4\npath[1].type 3\npath[1].priority 4", [20707]),
        ("path[0].type 1\npath[0].priority 4\npath[1].type 2\npath[1].priority 4", []),
        ("path[0].type 1\npath[1].type 1", []),
    ],
)
def test_folders_of_programs_have_numbers_and_priorities_of_their_own(
    text: str, found: list[int]
) -> None:
    """20771, 20707: where the list gives them, and for one type."""
    assert channel(f"path[0].dir a\npath[1].dir b\n{text}\n")[1] == found


def test_a_function_that_nothing_waits_for_takes_no_time() -> None:
    """20760: 0 is used."""
    text = "m_synch[50] MOS\nm_prozess_zeit[50] 500\nm_synch[51] MVS_SVS\nm_prozess_zeit[51] 500\n"
    functions, found = channel(text)[0].m_functions, channel(text)[1]
    assert (functions[50].process_time_us, functions[51].process_time_us) == (0.0, 50.0)
    assert found == [20760]


def test_implicit_programs() -> None:
    """P-CHAN-00119, 00252, 00118, 00160 … 00169, 00187."""
    text = "start_init_prog_file a.nc\nfinal_prog_file b.nc (x\nm6_prog_file c\n"
    text += "g800_prog_file[3] d.nc\ng81_prog_file e.nc\n"
    found = channel(text)[0].implicit_programs
    assert (found.program_start, found.program_end, found.m6, found.g) == (
        "a.nc",
        "b.nc",
        "c",
        {81: "e.nc", 803: "d.nc"},
    )


def test_g80_has_a_parameter_of_its_own() -> None:
    """P-CHAN-00160: G80 does not call the program of G800."""
    found = channel("g800_prog_file[0] d.nc\n")[0].implicit_programs
    assert found.g == {800: "d.nc"}


@pytest.mark.parametrize(
    ("value", "unit", "findings"),
    [("100", 1, []), ("0.1", 1000, []), ("-1", 1, []), ("0", 1, [21262])],
)
def test_unit_of_the_feed(value: str, unit: float, findings: list[int]) -> None:
    """P-CHAN-00108: 100 is mm/min, 0.1 is m/min, 0 is none."""
    found, reported = channel(f"prog_start.feedrate_factor {value}\n")
    assert found.program_start.feed_unit_mm_min == pytest.approx(unit)
    assert reported == findings


@pytest.mark.parametrize(
    ("line", "group", "number", "findings"),
    [
        ("prog_start.g_gruppe[12].nr 70", 12, 70, []),
        ("prog_start.g_gruppe[14].nr -1", 14, 90, []),
        ("prog_start.g_gruppe[4].nr 20", 4, 17, [2021]),
        ("prog_start.g_gruppe[8].nr 52", 8, 52, []),
        ("prog_start.g_gruppe[0].nr -2", 0, 0, [20819]),
    ],
)
def test_g_functions_at_program_start(
    line: str, group: int, number: int, findings: list[int]
) -> None:
    """P-CHAN-00063: -1 and what the group does not have leave the built-in function."""
    found, reported = channel(f"{line}\n")
    assert (found.program_start.g_functions[group], reported) == (number, findings)


@pytest.mark.parametrize(("value", "findings"), [(100, []), (101, [900086])])
def test_share_of_the_tick(value: int, findings: list[int]) -> None:
    """P-CHAN-00425 above 100 % is taken, with a warning."""
    found, reported = channel(f"rt_cycles.max_duration {value}\n")
    assert (found.realtime_cycles.max_duration_pct, reported) == (value, findings)


@pytest.mark.parametrize(
    ("profile", "findings"), [(0, []), (1, []), (2, [900885]), (3, [900885]), (4, [1023])]
)
def test_slope_at_program_start(profile: int, findings: list[int]) -> None:
    """P-CHAN-00071: SIN2 and HSC count as TRAPEZ, with a warning."""
    found, reported = channel(f"prog_start.slope.profile {profile}\n")
    assert (found.program_start.slope_profile, reported) == (
        0 if profile == 4 else profile,
        findings,
    )


def test_spindle_without_a_number_is_not_the_main_spindle() -> None:
    """main_spindle_ax_nr 0 means none."""
    (spindle,) = channel("spindel[0].bezeichnung S1\nspindel[0].log_achs_nr 0\n")[0].spindles
    assert (spindle.name, spindle.is_main) == ("S1", False)


# --- start-up ---


def test_startup_defaults() -> None:
    """An empty start-up list is one channel without axes."""
    found, findings = startup("")
    assert findings == []
    assert (len(found.channels), found.axes, found.rtconf) == (1, (), None)
    assert found.channels[0].look_ahead_blocks == 120
    assert found.channels[0].backward_memory_bytes == 0
    assert found.member_alignment == 0


def test_number_of_axes_may_be_missing() -> None:
    """Without zahl_mds each axis list that is named counts; with it only this many."""
    text = "achs_mds[0] a.lis\nachs_mds[2] c.lis\n"
    found = startup(text)[0]
    assert [one and one.path for one in found.axes] == ["a.lis", None, "c.lis"]
    assert len(startup(f"{text}zahl_mds 1\n")[0].axes) == 1


@pytest.mark.parametrize(
    ("function", "parameter", "blocks"),
    [
        ("FCT_LOOK_AHEAD_LOW", "", 30),
        ("FCT_IPO_DEFAULT | FCT_LOOK_AHEAD_HIGH", "", 190),
        ("FCT_LOOK_AHEAD_STANDARD", "", 120),
        ("FCT_LOOK_AHEAD_CUSTOM", "configuration.channel[0].interpolator.parameter 33", 33),
        ("FCT_LOOK_AHEAD_CUSTOM", "", 120),
        ("FCT_IPO_DEFAULT", "configuration.channel[0].interpolator.parameter 33", 120),
    ],
)
def test_look_ahead(function: str, parameter: str, blocks: int) -> None:
    """P-STUP-00070/71: the flag gives the number of blocks, CUSTOM takes the parameter's."""
    text = f"configuration.channel[0].interpolator.function {function}\n{parameter}\n"
    found, findings = startup(text)
    assert (found.channels[0].look_ahead_blocks, findings) == (blocks, [])


@pytest.mark.parametrize("value", [0, 1, 2, 4, 8])
def test_alignment(value: int) -> None:
    """P-STUP-00145 has five values."""
    found, findings = startup(f"ext_var_struct_member_alignment {value}\n")
    assert (found.member_alignment, findings) == (value, [])


@pytest.mark.parametrize("value", [3, 16])
def test_wrong_alignment(value: int) -> None:
    """Another alignment is 1000178, and the controller chooses."""
    found, findings = startup(f"ext_var_struct_member_alignment {value}\n")
    assert (found.member_alignment, findings) == (0, [1000178])


@pytest.mark.parametrize(("count", "findings"), [(0, [1024]), (12, []), (13, [1023])])
def test_number_of_channels(count: int, findings: list[int]) -> None:
    """A controller has 1 … 12 channels."""
    found, reported = startup(f"kanal_anzahl {count}\n")
    assert reported == findings
    assert len(found.channels) == (1 if findings else count)
