# SPDX-License-Identifier: MIT
"""The HLI as memory: layout, what the tick puts there and takes, partners in other processes."""

from __future__ import annotations

import itertools
import os
import secrets
import shutil
import struct
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from nctakt.hli.header import describe_hli_c
from nctakt.hli.layout import (
    AXIS,
    CHANNEL,
    COMMAND,
    HEADER,
    LINK,
    MAGIC,
    SPINDLE,
    SPINDLE_COMMAND,
    STRUCTURES,
    UNIT,
    VERSION,
    Structure,
)
from nctakt.hli.places import ImageLayout, entries, entry, image_layout, size_of, unit_offset
from nctakt.hli.process_watch import ProcessWatch
from nctakt.plc import PartnerPlc, PlcError
from nctakt.run.access.shared_image import SharedImage
from nctakt.run.controller import Controller, NcText

ROOT = Path(__file__).parent.parent.parent
EXAMPLES = ROOT / "examples"
DEMO = ROOT / "src" / "nctakt" / "machines" / "demo"
FORMATS = {
    "BOOLEAN": "=B",
    "UNS08": "=B",
    "UNS16": "=H",
    "UNS32": "=I",
    "SGN32": "=i",
    "UNS64": "=Q",
    "REAL64": "=d",
}

needs_shared_folder = pytest.mark.skipif(
    not Path("/dev/shm").is_dir(), reason="shared memory is seen as files on Linux only"
)


class Part:
    """One structure in an image, its values by name."""

    def __init__(self, image: SharedImage, structure: Structure, offset: int) -> None:
        self.image = image
        self.structure = structure
        self.offset = offset

    def __getitem__(self, name: str) -> float:
        place = entry(self.structure, name)
        form = FORMATS[place.entry.image_type]
        number = struct.unpack_from(form, self.image.memory, self.offset + place.offset)[0]
        return float(number) / place.entry.factor

    def __setitem__(self, name: str, value: float) -> None:
        place = entry(self.structure, name)
        form = FORMATS[place.entry.image_type]
        number = value if form == "=d" else int(value * place.entry.factor)
        struct.pack_into(form, self.image.memory, self.offset + place.offset, number)


class Memory:
    """The image of a controller with its structures."""

    def __init__(self, controller: Controller) -> None:
        self.controller = controller
        self.image = controller.interface_image()
        layout = self.layout = self.image.layout
        self.header = Part(self.image, HEADER, 0)
        self.link = Part(self.image, LINK, layout.link_offset)
        self.channel = Part(self.image, CHANNEL, layout.channel(0))
        self.command = Part(self.image, COMMAND, layout.command(0))
        self.x = Part(self.image, AXIS, layout.axis(0))
        self.spindles = [
            Part(self.image, SPINDLE, layout.spindle(i)) for i in range(layout.spindles)
        ]
        self.answers = [
            Part(self.image, SPINDLE_COMMAND, layout.spindle_command(i))
            for i in range(layout.spindles)
        ]

    def unit(self, section: str, slot: int) -> Part:
        """A place for a function."""
        offset = unit_offset(CHANNEL, section) + slot * size_of(UNIT)
        return Part(self.image, UNIT, self.layout.channel(0) + offset)

    def acknowledge(self, section: str, slot: int, serial: int) -> None:
        """The PLC's answer."""
        place = self.layout.command(0) + entry(COMMAND, f"ack_{section}").offset + 4 * slot
        struct.pack_into("=I", self.image.memory, place, serial)


def running(text: str) -> Memory:
    """A controller with an image that has started a program."""
    memory = Memory(Controller())
    memory.controller.start(NcText("p.nc", text))
    return memory


# --- layout -----------------------------------------------------------------------------------


def areas(layout: ImageLayout) -> list[tuple[int, int]]:
    """First and last byte + 1 of each structure in an image."""
    found = [(0, size_of(HEADER)), (layout.link_offset, layout.link_offset + size_of(LINK))]
    for index in range(layout.channels):
        found.append((layout.channel(index), layout.channel(index) + size_of(CHANNEL)))
        found.append((layout.command(index), layout.command(index) + size_of(COMMAND)))
    for index in range(layout.axes):
        found.append((layout.axis(index), layout.axis(index) + size_of(AXIS)))
    for index in range(layout.spindles):
        found.append((layout.spindle(index), layout.spindle(index) + size_of(SPINDLE)))
        answer = layout.spindle_command(index)
        found.append((answer, answer + size_of(SPINDLE_COMMAND)))
    return [*found, (layout.ve_offset, layout.size)]


def test_areas_do_not_overlap_and_the_plcs_are_last() -> None:
    """What the tick has to latch is after what it only writes."""
    layout = image_layout(Controller().machine)
    places = sorted(areas(layout))
    assert all(before[1] <= after[0] for before, after in itertools.pairwise(places))
    assert layout.command_offset > layout.spindle(layout.spindles - 1) > layout.axis(0)
    assert layout.ve_offset > layout.spindle_command_offset > layout.command_offset


@pytest.mark.parametrize("structure", STRUCTURES)
def test_values_are_at_multiples_of_their_size(structure: Structure) -> None:
    """As a C compiler puts them; structures take a multiple of 8 bytes."""
    end = 0
    for placed in entries(structure):
        assert placed.offset >= end
        assert placed.offset % min(8, placed.size_bytes if not placed.entry.count else 1) == 0
        end = placed.offset + placed.size_bytes
    assert size_of(structure) % 8 == 0


def test_the_header_says_what_there_is() -> None:
    """Magic, version, sizes, places; ``ready`` is taken away when the image is closed."""
    memory = Memory(Controller())
    assert bytes(memory.image.memory[:8]) == MAGIC
    assert (memory.header["version"], memory.header["ready"]) == (VERSION, 1)
    assert memory.header["size"] == memory.layout.size == len(memory.image.memory)
    assert memory.header["cycle_time_us"] == 1000
    assert memory.header["ve_offset"] == memory.layout.ve_offset
    names = [
        bytes(memory.image.memory[memory.layout.axis(i) :][:16]).rstrip(b"\0").decode()
        for i in range(memory.layout.axes)
    ]
    assert names[:4] == ["X", "Y", "Z", "A"]
    assert memory.header["spindle_offset"] == memory.layout.spindle_offset
    assert memory.header["spindle_command_offset"] == memory.layout.spindle_command_offset
    assert memory.header["spindles"] == 3
    names = [
        bytes(memory.image.memory[memory.layout.spindle(i) :][:16]).rstrip(b"\0").decode()
        for i in range(3)
    ]
    assert names == ["S", "S2", "S3"]
    found = [(one["logical"], one["channel"], one["plc_controlled"]) for one in memory.spindles]
    assert found == [(5, 1, 0), (6, 1, 0), (10, 1, 1)]
    assert memory.x["logical"] == 1


def test_the_c_header_of_the_examples_is_that_of_the_declaration() -> None:
    """``examples/hli/nctakt_hli.h`` is what ``describe_hli_c`` writes."""
    assert (EXAMPLES / "hli" / "nctakt_hli.h").read_text("utf-8") == describe_hli_c()


# --- what the tick writes -----------------------------------------------------------------------


def test_state_and_positions_are_in_the_image_after_each_tick() -> None:
    """G00 X10: after 50 ticks X is half way, at 200 mm/s, with 5 mm to go (MO-14)."""
    memory = running("N7 G00 X10\nM30")
    memory.controller.step(50)
    assert memory.header["tick"] == 50
    assert memory.header["sequence"] % 2 == 0
    assert (memory.channel["state"], memory.channel["block"]) == (1, 7)
    assert memory.x["command"] == pytest.approx(5.0)
    assert memory.x["target"] == 10.0
    assert memory.x["distance_to_go"] == pytest.approx(5.0)
    assert memory.channel["path_speed"] == pytest.approx(200.0)
    assert memory.channel["distance_to_go"] == pytest.approx(5.0)
    assert memory.channel["override_total"] == 100
    memory.controller.step(60)
    assert memory.channel["state"] == 0


def test_the_sequence_counts_two_for_each_tick() -> None:
    """One before and one after what the CNC writes: a reader that sees it unchanged is right."""
    memory = running("G00 X10\nM30")
    before = memory.header["sequence"]
    memory.controller.step(7)
    assert memory.header["sequence"] == before + 14


def test_functions_stay_in_units_until_they_are_acknowledged() -> None:
    """Serial, letter, number, sequence and stamp; the slot is free in the tick after (RC-403)."""
    memory = running("#RT CYCLE\n$IF ONCE TRUE\nM101\nH102\n$ENDIF\n#RT CYCLE END\nG04 X1\nM30")
    memory.command["plc_present"] = 1
    memory.controller.step(3)
    first, second = memory.unit("realtime", 0), memory.unit("realtime", 1)
    found = [(one["serial"], one["letter"], one["number"]) for one in (first, second)]
    assert found == [(1, 1, 101), (2, 2, 102)]
    assert [one["sequence"] for one in (first, second)] == [1, 2]
    assert [one["time_us"] for one in (first, second)] == [0, 0]
    memory.acknowledge("realtime", 1, 2)
    memory.acknowledge("realtime", 0, 7)
    memory.controller.step(1)
    assert (first["serial"], second["serial"]) == (1, 0)
    assert [one.number for one in memory.controller.hli.functions()] == [101]


def test_a_unit_names_who_has_commanded_it_and_how_it_is_synchronised() -> None:
    """Manual 4.3: POS_RT and always MOS in a cycle, whatever the list says; else by the list."""
    program = "#RT CYCLE\n$IF ONCE TRUE\nM111\nH102\n$ENDIF\n#RT CYCLE END\nM118 M111\nM30"
    memory = running(program)
    memory.command["plc_present"] = 1
    memory.controller.step(3)
    names = ("letter", "number", "identifier", "synchronisation")
    realtime = [memory.unit("realtime", slot) for slot in (0, 1)]
    assert [tuple(one[name] for name in names) for one in realtime] == [
        (1, 111, 2, 0x1),
        (2, 102, 2, 0x1),
    ]
    of_program = [memory.unit("program", slot) for slot in (0, 1)]
    found = {tuple(one[name] for name in names) for one in of_program}
    assert found == {(1, 118, 1, 0x20001), (1, 111, 1, 0x2)}
    seen = {
        (one.name, one.identifier, one.synchronisation) for one in memory.controller.hli.functions()
    }
    assert seen == {
        ("M118", "", "MOS"),
        ("M111", "", "MVS_SVS"),
        ("M111", "POS_RT", "MOS"),
        ("H102", "POS_RT", "MOS"),
    }


def test_what_waits_before_there_is_an_image_is_in_it() -> None:
    """One function, so that nothing changes any more that would be written anew."""
    controller = Controller()
    controller.write("HLI.PLC_PRESENT", 1)
    controller.start(NcText("p.nc", "M111\nM30"))
    controller.step(3)
    (function,) = controller.hli.functions()
    memory = Memory(controller)
    controller.step(1)
    assert memory.unit("program", function.slot)["serial"] == function.serial


def test_without_a_plc_the_cnc_acknowledges() -> None:
    """``plc_present`` 0: what appears in a tick is free in the next one."""
    memory = running("#RT CYCLE\n$IF ONCE TRUE\nM101\n$ENDIF\n#RT CYCLE END\nG04 X1\nM30")
    memory.controller.step(1)
    assert memory.unit("realtime", 0)["serial"] == 1
    memory.controller.step(1)
    assert memory.unit("realtime", 0)["serial"] == 0


def test_the_main_program_waits_for_the_acknowledgement_in_the_image() -> None:
    """M111 (MVS_SVS) holds its block until its serial is written."""
    memory = running("M111 G00 X1\nM30")
    memory.command["plc_present"] = 1
    memory.controller.step(20)
    assert memory.x["command"] == 0.0
    assert memory.unit("program", 0)["number"] == 111
    memory.acknowledge("program", 0, 1)
    memory.controller.step(1)
    assert memory.x["command"] > 0.0


def test_a_spindle_of_the_cnc_is_shown() -> None:
    """M3 S1000 from rest: 36 °/s a tick, 6 revolutions a minute."""
    memory = running("M3 S1000\nG04 X1\nM30")
    memory.controller.step(10)
    assert memory.spindles[0]["speed"] == pytest.approx(60.0)
    assert memory.spindles[0]["position"] == pytest.approx(0.018 * 10**2)
    assert memory.spindles[0]["job"] == 0


def test_a_job_of_a_plc_spindle_waits_for_its_number() -> None:
    """RC-404: function, speed, place in time; the next job comes when the first is over."""
    memory = running(
        "#RT CYCLE\n$IF ONCE TRUE\nS3[M4 REV=250]\n$ENDIF\n"
        "$IF ONCE V.E.TRIGGER\nS3[M4 M19 REV=100 POS=90]\n$ENDIF\n#RT CYCLE END\nG04 X1\nM30"
    )
    memory.command["plc_present"] = 1
    memory.controller.step(5)
    spindle, answer = memory.spindles[2], memory.answers[2]
    assert (spindle["job"], spindle["function"], spindle["job_speed"]) == (1, 4, 250.0)
    assert (spindle["job_time_us"], spindle["job_duration_us"]) == (0, 0)
    answer["ack_job"] = 7
    memory.controller.step(1)
    assert spindle["job"] == 1
    answer["ack_job"] = 1
    memory.controller.write("V.E.TRIGGER", 1)
    memory.controller.step(1)
    assert (spindle["job"], spindle["function"], spindle["direction"]) == (2, 19, 2)
    assert (spindle["job_speed"], spindle["job_position"]) == (100.0, 90.0)
    assert spindle["job_time_us"] == 6000
    answer["ack_job"] = 2
    memory.controller.step(1)
    assert spindle["job"] == 0


def test_without_a_plc_the_cnc_acknowledges_spindles_too() -> None:
    """``plc_present`` 0: the job is over in the next tick."""
    memory = running("S3[M3 REV=250]\nG04 X1\nM30")
    memory.controller.step(1)
    assert memory.spindles[2]["job"] == 1
    memory.controller.step(1)
    assert memory.spindles[2]["job"] == 0


def test_a_function_for_an_axis_names_it(tmp_path: Path) -> None:
    """P-CHAN-00039: the unit has the logical number of the axis or spindle, 0 the channel's."""
    folder = tmp_path / "machine"
    shutil.copytree(DEMO, folder)
    file = folder / "sda_mds1.lis"
    lines = "m_default_outp_ax_name[100] Z\nm_default_outp_ax_name[101] S2\n"
    file.write_text(lines + file.read_text("utf-8"), "utf-8")
    memory = Memory(Controller(folder))
    memory.controller.start(NcText("p.nc", "M100 M101 M102\nG04 X1\nM30"))
    memory.command["plc_present"] = 1
    memory.controller.step(1)
    units = [memory.unit("program", slot) for slot in range(3)]
    assert [(one["number"], one["axis"]) for one in units] == [(100, 3), (101, 6), (102, 0)]
    assert [one.axis for one in memory.controller.hli.functions()] == ["Z", "S2", ""]


def test_the_tool_of_t_is_in_a_unit(tmp_path: Path) -> None:
    """P-CHAN-00086: letter 3, the channel's; its serial in the PLC's place frees the program."""
    folder = tmp_path / "machine"
    shutil.copytree(DEMO, folder)
    file = folder / "sda_mds1.lis"
    file.write_text("tool.synch MVS_SVS\n" + file.read_text("utf-8"), "utf-8")
    memory = Memory(Controller(folder))
    memory.controller.start(NcText("p.nc", "T2\nG04 X1\nM30"))
    memory.command["plc_present"] = 1
    memory.controller.step(1)
    unit = memory.unit("program", 0)
    assert (unit["letter"], unit["number"], unit["axis"]) == (3, 2, 0)
    assert [one.name for one in memory.controller.hli.functions()] == ["T2"]
    assert {"T1", "T2", "T3"} <= set(memory.controller.hli.known_functions())


# --- what the PLC writes ------------------------------------------------------------------------


def test_the_operators_commands_are_latched_from_the_image() -> None:
    """Override, feed hold, RESET: in force in the next tick, the key is taken back."""
    memory = running("G00 X100\nM30")
    memory.controller.step(10)
    memory.command["override"] = 40.0
    memory.command["feed_hold"] = 1
    memory.controller.step(1)
    assert memory.channel["override_total"] == 40
    assert memory.controller.hli.feed_hold
    assert memory.controller.hli.override_pct == 40.0
    memory.command["reset"] = 1
    memory.controller.step(1)
    assert memory.command["reset"] == 0
    assert memory.channel["state"] == 3
    memory.controller.step(60)
    assert memory.channel["state"] == 0


def test_what_python_commands_is_in_the_image() -> None:
    """Both sides see one panel."""
    memory = running("G00 X100\nM30")
    memory.controller.hli.override_pct = 30.0
    memory.controller.step(1)
    assert memory.command["override"] == 30.0


def test_what_the_plc_writes_into_the_cncs_places_is_not_taken() -> None:
    """A position that somebody overwrites moves nothing, and the next one is right."""
    memory = running("G00 X10\nM30")
    memory.controller.step(10)
    memory.x["command"] = 77.0
    memory.controller.step(1)
    assert memory.x["command"] == pytest.approx(0.002 * 11**2)


def test_start_through_the_image() -> None:
    """The lamp shows that a program waits; START begins it."""
    controller = Controller()
    memory = Memory(controller)
    controller.select(NcText("p.nc", "G00 X1\nM30"))
    controller.step(1)
    assert memory.channel["armed"] == 1
    memory.command["start"] = 1
    controller.step(2)
    assert (memory.channel["armed"], memory.channel["state"]) == (0, 1)


def test_feed_hold_for_a_run_with_and_without_an_image_is_the_same() -> None:
    """An image at which nobody looks changes nothing."""

    def positions(*, image: bool) -> list[float]:
        controller = Controller()
        if image:
            controller.interface_image()
        run = controller.run(EXAMPLES / "crossing.nc", signals=["X.ACS.ACT_POS"])
        assert run.trace is not None
        return list(run.trace["X.ACS.ACT_POS"])

    assert positions(image=True) == positions(image=False)


# --- partners -----------------------------------------------------------------------------------


def partner(memory: Memory, answer: Callable[[], None]) -> PartnerPlc:
    """A partner whose other side does ``answer`` while the CNC waits."""

    def wait(condition: Callable[[], bool]) -> bool:
        answer()
        return condition()

    return PartnerPlc(memory.image, wait)


def test_a_partner_has_its_turn_after_each_tick() -> None:
    """It answers with the number of the turn."""
    controller = Controller()
    memory = Memory(controller)
    ticks = []

    def answer() -> None:
        memory.command["plc_present"] = 1
        memory.link["turn"] = memory.header["turn"]
        ticks.append(memory.header["tick"])

    plc = partner(memory, answer)
    plc.await_presence()
    controller.run(NcText("p.nc", "G04 X0.003\nM30"), plc=plc)
    assert ticks[1:] == [1, 2, 3, 4]


def left(memory: Memory) -> None:
    """The partner goes."""
    memory.command["plc_present"] = 0


@pytest.mark.parametrize(("answer", "number"), [(lambda _: None, 900651), (left, 900652)])
def test_a_partner_that_does_not_answer_ends_the_run(
    answer: Callable[[Memory], None], number: int
) -> None:
    """900651 no answer, 900652 gone."""
    controller = Controller()
    memory = Memory(controller)
    memory.command["plc_present"] = 1
    with pytest.raises(PlcError) as caught:
        controller.run(NcText("p.nc", "M30"), plc=partner(memory, lambda: answer(memory)))
    assert caught.value.diagnostics[0].id == number


@pytest.mark.skipif(not hasattr(os, "pidfd_open"), reason="a system call of Linux")
def test_a_partner_whose_process_ends_ends_the_run() -> None:
    """900652 as soon as the process is gone, however long an answer is waited for."""
    controller = Controller()
    memory = Memory(controller)
    memory.command["plc_present"] = 1
    turns = 0

    def wait(condition: Callable[[], bool]) -> bool:
        """Answer twice, then die; never end by itself."""
        nonlocal turns
        turns += 1
        if turns < 3:
            memory.link["turn"] = memory.header["turn"]
        else:
            process.kill()
            process.wait()
        assert condition()
        return True

    with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as process:
        memory.link["process"] = process.pid
        plc = PartnerPlc(memory.image, wait)
        with pytest.raises(PlcError) as caught:
            controller.run(NcText("p.nc", "G04 X0.010\nM30"), plc=plc)
        plc.close()
        plc.close()
    assert caught.value.diagnostics[0].id == 900652
    assert controller.tick == 3


@pytest.mark.parametrize("process", [0, 2**22 + 1, 2**63])
def test_a_process_that_nobody_has_is_not_watched(process: int) -> None:
    """Such a number says nothing about the partner."""
    watch = ProcessWatch(process)
    assert not watch.is_gone
    watch.close()


def test_a_partner_that_never_comes_is_reported() -> None:
    """900650 before the first tick."""
    with pytest.raises(PlcError) as caught:
        PartnerPlc(Memory(Controller()).image, lambda _: False).await_presence()
    assert caught.value.diagnostics[0].id == 900650


def nctakt(*words: str) -> list[str]:
    """The command line."""
    return [sys.executable, "-m", "nctakt", *words]


def run_with_partner(tmp_path: Path, command: list[str]) -> tuple[bytes, str]:
    """The trace of a run with a partner, and what the partner has printed."""
    name = f"nctakt_{os.getpid()}_{secrets.token_hex(4)}"
    trace = tmp_path / "trace.csv"
    words = ["run", str(EXAMPLES / "crossing.nc"), "--quiet", "--hli", name, "--trace", str(trace)]
    words += ["--record", str(tmp_path / "run.tape")]
    with subprocess.Popen(nctakt(*words), stdout=subprocess.DEVNULL) as cnc:
        done = subprocess.run(
            [*command, name], check=True, capture_output=True, text=True, timeout=120
        )
        assert cnc.wait(120) == 0
    return trace.read_bytes(), done.stdout


def scripted(tmp_path: Path) -> bytes:
    """The trace of the same run with the PLC of ``examples/slow_plc.py``."""
    trace = tmp_path / "scripted.csv"
    words = ["run", str(EXAMPLES / "crossing.nc"), "--quiet", "--trace", str(trace)]
    subprocess.run(
        [*nctakt(*words), "--plc", str(EXAMPLES / "slow_plc.py")], check=True, capture_output=True
    )
    return trace.read_bytes()


@pytest.mark.slow
@needs_shared_folder
@pytest.mark.skipif(shutil.which("cc") is None, reason="there is no C compiler")
def test_a_plc_in_c_does_what_the_scripted_one_does(tmp_path: Path) -> None:
    """The example in C sees M100 at its place, and the run is the same byte for byte."""
    program = tmp_path / "slow_plc"
    words = ["cc", "-std=c11", "-O2", "-Wall", "-Wextra", "-Werror", "-o", str(program)]
    subprocess.run([*words, str(EXAMPLES / "hli" / "slow_plc.c")], check=True)
    trace, printed = run_with_partner(tmp_path, [str(program)])
    assert printed == "463000 us M100 X 200.748\n"
    assert trace == scripted(tmp_path)


@pytest.mark.nightly
@pytest.mark.slow
@needs_shared_folder
def test_a_plc_in_python_does_what_the_scripted_one_does(tmp_path: Path) -> None:
    """The example in Python, in its own process: the same."""
    trace, printed = run_with_partner(
        tmp_path, [sys.executable, str(EXAMPLES / "hli" / "slow_plc.py")]
    )
    assert printed == "463000 us M100 X 200.748\n"
    assert trace == scripted(tmp_path)
    replayed = tmp_path / "replayed.csv"
    words = ["replay", str(tmp_path / "run.tape"), "--quiet", "--root", str(EXAMPLES)]
    words += ["--trace", str(replayed)]
    subprocess.run(nctakt(*words), check=True, capture_output=True)
    assert replayed.read_bytes() == trace


def test_two_plcs_are_refused() -> None:
    """900653: a script and a partner at once."""
    words = ["run", str(EXAMPLES / "crossing.nc"), "--hli", "x", "--plc"]
    done = subprocess.run(
        nctakt(*words, str(EXAMPLES / "slow_plc.py")), check=False, capture_output=True, text=True
    )
    assert done.returncode == 2
    assert "900653" in done.stderr
