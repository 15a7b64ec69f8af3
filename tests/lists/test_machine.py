# SPDX-License-Identifier: MIT
"""Machine folders: which lists are read, from where, and what comes of mistakes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nctakt.lists.format.without_effect import Detail
from nctakt.lists.machine.machine import Failure, Machine, load_machine

STARTUP = """\
kanal_anzahl 1
sda_mds[0] kanal.lis
zahl_mds 1
achs_mds[0] x.lis
rtconf_lis rtconf.lis
"""
CHANNEL = "gruppe[0].achse[0].log_achs_nr 1\ngruppe[0].achse[0].bezeichnung X\n"
RTCONF = """\
interrupt_source 3
external_object_name s
cycle_time 2000
time_slice 500
windows_time 500
thread[0].name GEO
thread[0].cycle 2000
thread[0].priority 115
thread[0].error_on_overflow 1
thread[0].function[0].name task_int
End
"""
FILES = {
    "hochlauf.lis": STARTUP,
    "kanal.lis": CHANNEL,
    "x.lis": "kopf.achs_nr 1\n",
    "rtconf.lis": RTCONF,
}


def write(folder: Path, files: dict[str, str]) -> Path:
    """A machine folder with these files, over those of a smallest machine."""
    for name, text in {**FILES, **files}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def load(folder: Path, *, detail: Detail = "summary") -> tuple[Machine, list[int]]:
    """The machine of ``folder``, and what was found."""
    machine = load_machine(folder, detail=detail)
    for found in machine.diagnostics:
        assert found.render("en") and found.render("de")
    return machine, [found.id for found in machine.diagnostics]


def failure(folder: Path) -> list[int]:
    """What a folder without a machine reports."""
    with pytest.raises(Failure) as caught:
        load_machine(folder)
    for found in caught.value.diagnostics:
        assert found.render("en") and found.render("de")
    return [found.id for found in caught.value.diagnostics]


def test_smallest_machine(tmp_path: Path) -> None:
    """A channel with an axis loads without any finding."""
    machine, found = load(write(tmp_path, {}))
    assert found == []
    assert (machine.name, machine.folder, machine.cycle_time_us) == (tmp_path.name, tmp_path, 2000)
    (channel,) = machine.channels
    assert channel.number == 1
    (axis,) = channel.axes
    assert (axis.name, axis.logical_number, axis.index) == ("X", 1, 0)
    assert channel.main_spindle is None


@pytest.mark.parametrize("name", ["startup.lis", "Hochlauf.LIS"])
def test_names_of_the_startup_list(tmp_path: Path, name: str) -> None:
    """hochlauf.lis or startup.lis, in any letter case, or the file itself."""
    write(tmp_path, {})
    (tmp_path / "hochlauf.lis").rename(tmp_path / name)
    assert load(tmp_path)[1] == []
    assert load(tmp_path / name)[1] == []


def test_no_folder_and_no_startup_list(tmp_path: Path) -> None:
    """A folder that does not exist, or that has no start-up list, is no machine."""
    assert failure(tmp_path / "nowhere") == [900060]
    assert failure(tmp_path) == [900061]


@pytest.mark.parametrize("format_", ["BINAER", "BINARY"])
def test_other_formats_are_refused_by_name(tmp_path: Path, format_: str) -> None:
    """Binary lists cannot be read."""
    folder = write(tmp_path, {"hochlauf.lis": f"listen {format_}\n{STARTUP}"})
    assert failure(folder) == [900064]


def test_no_channel_list_at_all(tmp_path: Path) -> None:
    """Without any channel list there is no machine."""
    folder = write(tmp_path, {"hochlauf.lis": "kanal_anzahl 2\n"})
    assert failure(folder) == [900068, 2024, 2024, 900077]


def test_paths_relative_to_the_parent_folder(tmp_path: Path) -> None:
    """Vendors keep all lists in one folder and name them from the folder above."""
    folder = tmp_path / "listen"
    write(folder, {"hochlauf.lis": STARTUP.replace("kanal.lis", "./listen/kanal.lis")})
    assert load(folder)[1] == []


def test_parent_of_the_working_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The machine in the working folder is searched above it too."""
    folder = write(tmp_path / "m", {})
    (folder / "x.lis").rename(tmp_path / "x.lis")
    (folder / "sub").mkdir()
    for working, name in ((folder, "."), (folder / "sub", "..")):
        monkeypatch.chdir(working)
        assert load(Path(name))[1] == []


def test_own_folder_comes_before_the_parent(tmp_path: Path) -> None:
    """A path that exists in both is that of the list's own folder."""
    (tmp_path / "kanal.lis").write_text("bogus 1\n", encoding="utf-8")
    assert load(write(tmp_path / "listen", {}))[1] == []


@pytest.mark.parametrize("path", [".\\kanal.lis", "KANAL.LIS", "..\\m\\Kanal.lis", ".//kanal.lis"])
def test_paths_as_on_windows(tmp_path: Path, path: str) -> None:
    """Back-slashes and letter case are tolerated, with a note."""
    folder = write(tmp_path / "m", {"hochlauf.lis": STARTUP.replace("kanal.lis", path)})
    machine, found = load(folder)
    assert found == ([] if path == ".//kanal.lis" else [900063])
    assert machine.channels[0].axes


def test_absolute_paths(tmp_path: Path) -> None:
    """An absolute path is taken as it is."""
    other = tmp_path / "other.lis"
    other.write_text(CHANNEL, encoding="utf-8")
    folder = write(tmp_path / "m", {})
    for path, numbers in ((other, []), (tmp_path / "nothing.lis", [2001])):
        text = STARTUP.replace("kanal.lis", path.as_posix())
        (folder / "hochlauf.lis").write_text(text, encoding="utf-8")
        try:
            assert load(folder)[1] == numbers
        except Failure as error:
            assert [found.id for found in error.diagnostics] == [*numbers, 900077]


def test_missing_axis_list(tmp_path: Path) -> None:
    """An axis list that does not exist costs the axis, and the channel's axis with it."""
    folder = write(tmp_path, {"hochlauf.lis": STARTUP.replace("x.lis", "y.lis")})
    machine, found = load(folder)
    assert found == [2001, 20312]
    assert (machine.axes, machine.channels[0].axes) == ((), ())
    assert str(machine.diagnostics[0].span).endswith("hochlauf.lis:4:1")


def test_axis_list_that_is_not_named(tmp_path: Path) -> None:
    """zahl_mds may promise more lists than are named."""
    folder = write(tmp_path, {"hochlauf.lis": STARTUP.replace("zahl_mds 1", "zahl_mds 2")})
    machine, found = load(folder)
    assert (found, len(machine.axes)) == ([2024], 1)


@pytest.mark.parametrize(("number", "message"), [(0, 110076), (1, 110064)])
def test_logical_numbers_are_unique(tmp_path: Path, number: int, message: int) -> None:
    """A logical number that is 0 or used already costs the axis."""
    text = STARTUP.replace("zahl_mds 1", "zahl_mds 2") + "achs_mds[1] y.lis\n"
    files = {"hochlauf.lis": text, "y.lis": f"kopf.achs_nr {number}\n"}
    machine, found = load(write(tmp_path, files))
    assert (found, len(machine.axes)) == ([message], 1)


def test_missing_rtconf(tmp_path: Path) -> None:
    """Without rtconf.lis the tick is 1 ms, with a note."""
    folder = write(tmp_path, {"hochlauf.lis": STARTUP.replace("rtconf_lis rtconf.lis\n", "")})
    machine, found = load(folder)
    assert (found, machine.cycle_time_us, machine.rtconf) == ([900068], 1000, None)
    folder = write(tmp_path, {"hochlauf.lis": STARTUP.replace("rtconf.lis\n", "no.lis\n")})
    machine, found = load(folder)
    assert (found, machine.cycle_time_us) == ([2001, 900068], 1000)


def test_list_that_is_a_folder(tmp_path: Path) -> None:
    """A folder in place of a list is no list."""
    folder = write(tmp_path, {"hochlauf.lis": STARTUP.replace("x.lis", "d")})
    (folder / "d").mkdir()
    assert load(folder)[1] == [2001, 20312]


def refuse(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """Make the operating system refuse to read files of that name."""

    plain_open = Path.open

    def refusing_open(path: Path, *words: Any, **named: Any) -> Any:
        if path.name == name:
            raise PermissionError(13, "Permission denied")
        return plain_open(path, *words, **named)

    monkeypatch.setattr(Path, "open", refusing_open)


def test_list_that_cannot_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the operating system refuses is reported with its reason."""
    folder = write(tmp_path, {})
    refuse(monkeypatch, "x.lis")
    machine, found = load(folder)
    assert found == [900503, 20312]
    assert "Permission denied" in machine.diagnostics[0].text("en")


def test_startup_list_that_cannot_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without its start-up list there is no machine."""
    folder = write(tmp_path, {})
    refuse(monkeypatch, "hochlauf.lis")
    assert failure(folder) == [900503]


def test_path_through_a_file(tmp_path: Path) -> None:
    """A file in place of a folder leads nowhere."""
    folder = write(tmp_path, {"hochlauf.lis": STARTUP.replace("x.lis", "kanal.lis/y.lis")})
    assert load(folder)[1] == [2001, 20312]


@pytest.mark.parametrize(
    ("path", "file", "numbers"),
    [
        ("x.lis", "mach/cnc/x.lis", []),
        ("./listen/x.lis", "mach/cnc/listen/x.lis", []),
        ("./listen/x.lis", "mach/cnc/x.lis", [900063]),
        ("listen\\X.LIS", "mach/cnc/listen/x.lis", [900063]),
        ("x.lis", "mach/x.lis", []),
        ("listen/x.lis", "listen/x.lis", []),
        ("C:\\TwinCAT\\CNC\\listen\\x.lis", "mach/listen/x.lis", [900063]),
        ("C:/TwinCAT/CNC/listen/x.lis", "mach/cnc/x.lis", [900063]),
        ("CncKernelRootDir/listen/x.lis", "mach/cnc/listen/x.lis", []),
        ("../other/x.lis", "mach/other/x.lis", []),
        ("deep/x.lis", "work/deep/x.lis", []),
        ("deep/x.lis", "root/deep/x.lis", []),
    ],
)
def test_where_a_list_is_searched(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, path: str, file: str, numbers: list[int]
) -> None:
    """Own folder, parents up to the named one, working folder, root; then without first parts."""
    files = {
        "mach/cnc/hochlauf.lis": STARTUP.replace("x.lis", path),
        "mach/cnc/kanal.lis": CHANNEL,
        "mach/cnc/rtconf.lis": RTCONF,
        "work/readme.txt": "",
        "root/readme.txt": "",
        file: "kopf.achs_nr 1\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path / "work")
    machine = load_machine(tmp_path, root=tmp_path / "root")
    found = [diagnostic.id for diagnostic in machine.diagnostics]
    # The first note: the start-up list is somewhere in the named tree.
    assert found == [900974, *numbers]
    assert len(machine.axes) == 1


def test_files_are_named_by_their_shortest_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """``..`` after a folder takes that away, in notes, in lists of files and beside mistakes."""
    startup = STARTUP.replace("x.lis", "..\\listen\\X.LIS").replace(
        "kanal.lis", "../listen/kanal.lis"
    )
    write(tmp_path / "listen", {"hochlauf.lis": startup, "x.lis": "kopf.achs_nr 0\n"})
    monkeypatch.chdir(tmp_path)
    machine, found = load(Path())
    assert sorted(found) == [20312, 110076, 900063, 900974]
    files = [path.as_posix() for _, path in machine.lists]
    assert "listen/kanal.lis" in files
    assert not any(".." in file for file in files)
    by_number = {one.id: one for one in machine.diagnostics}
    assert (by_number[900063].values["count"], by_number[900063].values["file"]) == (
        1,
        "listen/x.lis",
    )
    assert str(by_number[110076].span).startswith("listen/x.lis:")


def test_a_link_is_no_way_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The folder above what a link leads to is not the one that the link lies in."""
    startup = STARTUP.replace("x.lis", "../other/x.lis")
    write(tmp_path / "far" / "listen", {"hochlauf.lis": startup})
    write(tmp_path / "far" / "other", {})
    (tmp_path / "listen").symlink_to(tmp_path / "far" / "listen", target_is_directory=True)
    monkeypatch.chdir(tmp_path)
    machine, found = load(Path("listen"))
    assert (found, len(machine.axes)) == ([], 1)
    assert ("axis", Path("listen/../other/x.lis")) in machine.lists


def test_a_missing_list_names_the_paths_that_were_tried(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each once, in the order of the search: first the path as a whole."""
    startup = STARTUP.replace("x.lis", "..\\listen\\y.lis")
    write(tmp_path / "listen", {"hochlauf.lis": startup})
    monkeypatch.chdir(tmp_path)
    machine, _ = load(Path("listen"))
    (missing,) = [one for one in machine.diagnostics if one.id == 2001]
    assert missing.remedy("en") == (
        "Searched: listen/y.lis, ../listen/y.lis, listen/listen/y.lis, y.lis; correct the path, or "
        "name another folder with --root."
    )


def test_a_parent_above_the_named_folder_is_not_searched(tmp_path: Path) -> None:
    """Only the folder above the start-up list is, in any case."""
    folder = write(tmp_path / "a" / "b" / "c", {"hochlauf.lis": STARTUP, "x.lis": ""})
    (folder / "x.lis").rename(tmp_path / "a" / "x.lis")
    assert 2001 in load(folder)[1]


def test_tolerated_paths_are_one_note(tmp_path: Path) -> None:
    """Two paths in other spellings, one note that names the first."""
    text = STARTUP.replace("x.lis", "listen/X.lis").replace("kanal.lis", "listen\\kanal.lis")
    folder = write(tmp_path, {"hochlauf.lis": text})
    machine, numbers = load(folder)
    assert numbers == [900063]
    assert machine.diagnostics[0].values["count"] == 2


def test_several_start_up_lists_in_a_tree(tmp_path: Path) -> None:
    """None is taken; one that lies in the folder itself under the usual name counts."""
    for name in ("m1", "m2"):
        (tmp_path / name).mkdir()
        write(tmp_path / name, {})
    assert failure(tmp_path) == [900973]
    (tmp_path / "m2" / "hochlauf.lis").unlink()
    assert load(tmp_path)[1] == [900974]
    write(tmp_path, {})
    assert load(tmp_path)[1] == []


@pytest.mark.parametrize("name", ["hochlauf_a.lis", "Startup.LIS", "start-up.lis", "HOCHLAUF.lis"])
def test_names_of_start_up_lists(tmp_path: Path, name: str) -> None:
    """Those of the field beside the two usual ones."""
    folder = write(tmp_path, {})
    (folder / "hochlauf.lis").rename(folder / name)
    machine = load_machine(folder)
    assert len(machine.axes) == 1


def test_defaults_lists_come_first(tmp_path: Path) -> None:
    """default_sda_mds and default_achs_mds hold what the specific lists do not name."""
    files = {
        "hochlauf.lis": STARTUP + "default_sda_mds d.lis\ndefault_achs_mds a.lis\n",
        "d.lis": "m_synch[100] MOS\nprog_start.feedrate 5\n",
        "kanal.lis": f"{CHANNEL}prog_start.feedrate 7\n",
        "a.lis": "kenngr.enable_single_axis 1\nkenngr.swe_pos 10000\n",
        "x.lis": "kopf.achs_nr 1\nkenngr.swe_pos 20000\n",
    }
    machine, found = load(write(tmp_path, files))
    assert found == []
    parameters = machine.channels[0].parameters
    assert parameters.program_start.feed_mm_min == 7
    assert 100 in parameters.m_functions
    (axis,) = machine.axes
    assert (axis.enable_single_axis, axis.software_limit_high) == (True, 2)


def test_channel_without_a_list_of_its_own(tmp_path: Path) -> None:
    """The defaults list alone makes a channel; its axis belongs to the first one of two."""
    text = "kanal_anzahl 2\ndefault_sda_mds kanal.lis\nachs_mds[0] x.lis\nrtconf_lis rtconf.lis\n"
    machine, found = load(write(tmp_path, {"hochlauf.lis": text}))
    assert found == [900750]
    assert [[axis.name for axis in channel.axes] for channel in machine.channels] == [["X"], []]


SHARED = "number_used_variables 2\nvar[0].name A\nvar[0].scope GLOBAL\nvar[1].name OWN\n"


def test_several_channels_share_global_variables(tmp_path: Path) -> None:
    """A GLOBAL variable is one for all channels, CHANNEL variables are each channel's own."""
    files = {
        "hochlauf.lis": STARTUP.replace("anzahl 1", "anzahl 2")
        + "sda_mds[1] other.lis\nve_var[0] v.lis\nve_var[1] v.lis\n",
        "other.lis": "max_vb_override 1000\n",
        "v.lis": SHARED,
    }
    machine, found = load(write(tmp_path, files))
    assert found == [900818]  # the second channel has no axis
    assert [one.name for one in machine.global_variables] == ["A"]
    for channel in machine.channels:
        assert [one.name for one in channel.external_variables] == ["A", "OWN"]
    assert [channel.number for channel in machine.channels] == [1, 2]


def test_global_variables_that_differ(tmp_path: Path) -> None:
    """Channels that declare a GLOBAL variable differently get the first declaration."""
    files = {
        "hochlauf.lis": STARTUP.replace("anzahl 1", "anzahl 2")
        + "sda_mds[1] other.lis\nve_var[0] v.lis\nve_var[1] w.lis\n",
        "other.lis": "max_vb_override 1000\n",
        "v.lis": SHARED,
        "w.lis": f"{SHARED}var[0].type REAL64\n",
    }
    machine, found = load(write(tmp_path, files))
    assert found == [900078, 900818]
    assert machine.channels[1].external_variables[0].node.type == "UNS32"


@pytest.mark.parametrize(("memory", "fits"), [(72, True), (71, False), (0, False)])
def test_memory_of_channel_variables(tmp_path: Path, memory: int, fits: bool) -> None:
    """RC-309: V.CH variables need P-CHAN-00424 for data and management, else 22079."""
    files = {
        "hochlauf.lis": f"{STARTUP}ve_var[0] v.lis\n",
        "kanal.lis": f"{CHANNEL}configuration.decoder.v_ch_memory {memory}\n",
        "v.lis": "vch[0].name A\nvch[0].type REAL64\n",
    }
    machine, found = load(write(tmp_path, files))
    assert found == ([] if fits else [22079])
    assert len(machine.channels[0].channel_variables) == int(fits)


def test_no_memory_needed_without_channel_variables(tmp_path: Path) -> None:
    """A variables list without vch needs no memory."""
    files = {"hochlauf.lis": f"{STARTUP}ve_var[0] v.lis\n", "v.lis": SHARED}
    assert load(write(tmp_path, files))[1] == []


def test_spindles_need_an_axis_list_unless_the_plc_turns_them(tmp_path: Path) -> None:
    """An NC spindle without an axis list is left out, a PLC spindle needs none."""
    spindles = (
        "spindel[0].bezeichnung S1\nspindel[0].log_achs_nr 1\n"
        "spindel[1].bezeichnung S2\nspindel[1].log_achs_nr 2\n"
        "spindel[2].bezeichnung S3\nspindel[2].log_achs_nr 10\nspindel[2].plc_control 1\n"
    )
    machine, found = load(write(tmp_path, {"kanal.lis": CHANNEL + spindles}))
    assert found == [20312]
    assert [(one.name, one.index) for one in machine.channels[0].spindles] == [
        ("S1", 0),
        ("S3", None),
    ]


def test_tools_and_offsets_belong_to_their_channel(tmp_path: Path) -> None:
    """The lists that the start-up list names for a channel are used; a missing one is reported.

    X is linear: 0.1 µm; the list of clamp offsets does not exist.
    """
    files = {
        "hochlauf.lis": f"{STARTUP}werkz_data[0] t.lis\nnullp_data[0] n.lis\npzv_data[0] p.lis\n",
        "t.lis": "wz[3].gueltig 1\nwz[3].laenge 1234500\nwz[3].radius 50000\n",
        "n.lis": "np_grp[1].achse[0].versch -250000\n",
    }
    machine, found = load(write(tmp_path, files))
    channel = machine.channels[0]
    assert found == [2001]
    tool = channel.tools[3]
    assert (tool.valid, tool.length, tool.radius) == (True, 123.45, 5.0)
    assert channel.zero_offsets.offset(1, 0) == -25.0
    assert channel.clamp_offsets.groups == {}


def test_each_unknown_entry_is_named(tmp_path: Path) -> None:
    """One warning each, at its line."""
    folder = write(tmp_path, {"x.lis": "kopf.achs_nr 1\nbogus.one 1\nbogus.two 2\n"})
    assert load(folder)[1] == [110303, 110303]
    assert load(folder, detail="all")[1] == [110303, 110303]


def test_loading_twice_gives_the_same(tmp_path: Path) -> None:
    """Nothing is kept between two loads."""
    folder = write(tmp_path, {"x.lis": "kopf.achs_nr 1\nbogus 1\n"})
    assert load_machine(folder) == load_machine(folder)


@pytest.mark.parametrize(
    ("share", "windows", "count"),
    [(75, 500, 0), (76, 500, 1), (100, 0, 0), (100, 500, 1), (75, 1000, 1)],
)
def test_realtime_cycles_keep_out_of_windows_time(
    tmp_path: Path, share: int, windows: int, count: int
) -> None:
    """P-CHAN-00425 with P-RTCF-00004: 75 % of 2 ms and 500 µs, the manual's values, just fit."""
    channel = f"configuration.rt_cycles.enable 1\nrt_cycles.max_duration {share}\n"
    rtconf = RTCONF.replace("windows_time 500", f"windows_time {windows}")
    files = {"kanal.lis": f"{CHANNEL}{channel}", "rtconf.lis": rtconf}
    assert load(write(tmp_path, files))[1].count(900697) == count


def test_contexts_of_a_channel_need_their_threads(tmp_path: Path) -> None:
    """P-RTCF-00017 with P-CHAN-00410: a context without a thread is a warning."""
    channel = f"{CHANNEL}schedule.context.geo 1\n"
    assert load(write(tmp_path, {"kanal.lis": channel}))[1] == [260102]
    rtconf = RTCONF.replace("thread[0].cycle", "thread[0].context_info 1\nthread[0].cycle")
    assert load(write(tmp_path, {"rtconf.lis": rtconf, "kanal.lis": channel}))[1] == []
    assert load(write(tmp_path, {"rtconf.lis": rtconf, "kanal.lis": CHANNEL}))[1] == [260103]


@pytest.mark.parametrize(
    ("entries", "found"),
    [
        ("m_synch[50] MET_SVS", True),
        ("h_synch[50] MET_SVS\nh_pre_outp[50] 999", True),
        ("m_synch[50] MET_SVS\nm_pre_outp[50] 2000", False),
        ("m_synch[50] MEP_SVS", False),
    ],
)
def test_an_early_output_is_at_least_a_tick_early(
    tmp_path: Path, entries: str, found: bool
) -> None:
    """21203, with P-CHAN-00070 and P-CHAN-00107; the tick is 2 ms."""
    reported = load(write(tmp_path, {"kanal.lis": f"{CHANNEL}{entries}\n"}))[1]
    assert (21203 in reported) is found


@pytest.mark.parametrize(("elements", "found"), [(3, []), (4, [21520])])
def test_memory_of_external_variables(tmp_path: Path, elements: int, found: list[int]) -> None:
    """P-STUP-00037: one block has room for three REAL64, not for four; all four are there."""
    variables = (
        "number_used_variables 1\nvar[0].name LIST\nvar[0].type REAL64\n"
        f"var[0].array_elements {elements}\n"
    )
    startup = f"{STARTUP}ext_var_max 1\nve_var[0] var.lis\n"
    machine, reported = load(write(tmp_path, {"hochlauf.lis": startup, "var.lis": variables}))
    assert reported == found
    (variable,) = machine.channels[0].external_variables
    assert variable.node.array_elements == elements


@pytest.mark.parametrize(
    ("scope", "offset", "found"),
    [("CHANNEL", 16, []), ("CHANNEL", 17, [21518]), ("GLOBAL", 20, [21519])],
)
def test_a_place_outside_the_memory_is_no_variable(
    tmp_path: Path, scope: str, offset: int, found: list[int]
) -> None:
    """P-EXTV-00002 with P-STUP-00037: 24 bytes have room for a REAL64 from byte 16 on, no later."""
    variables = (
        f"number_used_variables 1\nvar[0].name A\nvar[0].type REAL64\nvar[0].scope {scope}\n"
        f"var[0].byte_offset {offset}\n"
    )
    startup = f"{STARTUP}ext_var_max 1\nve_var[0] var.lis\n"
    machine, reported = load(write(tmp_path, {"hochlauf.lis": startup, "var.lis": variables}))
    assert reported == found
    assert len(machine.channels[0].external_variables) == (0 if found else 1)


@pytest.mark.parametrize("name", ["kanal.lis", "x.lis", "rtconf.lis"])
def test_a_list_that_is_no_text(tmp_path: Path, name: str) -> None:
    """A binary file is reported once, where it is named, and is left out."""
    write(tmp_path, {})
    (tmp_path / name).write_bytes(bytes(range(256)) * 4)
    try:
        machine = load_machine(tmp_path)
    except Failure as error:
        found = error.diagnostics
    else:
        found = machine.diagnostics
    these = [one for one in found if one.id == 900581]
    assert [one.span.file for one in these if one.span] == [(tmp_path / "hochlauf.lis").as_posix()]
    assert {one.id for one in found} <= {900581, 20312, 900068, 900077}


def test_a_start_up_list_that_is_no_text(tmp_path: Path) -> None:
    """There is no machine then."""
    write(tmp_path, {})
    (tmp_path / "hochlauf.lis").write_bytes(bytes(range(256)))
    assert failure(tmp_path) == [900581]


@pytest.mark.parametrize("text", ["\0" * 20, "# a\0b\n", "Ende\n" + "\0" * 500])
def test_a_text_with_nuls_is_no_binary_file(tmp_path: Path, text: str) -> None:
    """Vendors fill lists up with NULs."""
    found = load(write(tmp_path, {"x.lis": f"kopf.achs_nr 1\n{text}"}))[1]
    assert 900581 not in found


def test_an_empty_channel_list(tmp_path: Path) -> None:
    """A channel without an axis is reported at its list."""
    machine = load_machine(write(tmp_path, {"kanal.lis": ""}))
    (reported,) = machine.diagnostics
    assert (reported.id, reported.span and Path(reported.span.file).name) == (900818, "kanal.lis")
