# SPDX-License-Identifier: MIT
"""The live image of V.E: what the tick takes from it and puts into it, shared or not."""

from __future__ import annotations

import math
import os
import secrets
import signal
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path

import pytest
from support.variable_machines import DEMO, NESTED, folder_with, machine_with

from nctakt.base.failure import Failure
from nctakt.hli.variables_memory import describe, sections
from nctakt.run.access.shared_image import SharedImage
from nctakt.run.controller import Controller, NcText

pytestmark = pytest.mark.slow

SHARED_FOLDER = Path("/dev/shm")
needs_shared_folder = pytest.mark.skipif(
    not SHARED_FOLDER.is_dir(), reason="shared memory is seen as files on Linux only"
)


@pytest.fixture
def name() -> Iterator[str]:
    """A name for shared memory that nobody has."""
    yield f"nctakt_{os.getpid()}_{secrets.token_hex(4)}"


class Plc:
    """Reads and writes the demo machine's variables in an image."""

    def __init__(self, controller: Controller, memory: memoryview) -> None:
        self.memory = memory
        self.places = {
            field.path: (section.offset + field.offset, field)
            for section in sections(controller.machine)
            for field in describe(controller.machine, section.channel)
        }

    def real(self, path: str, value: float | None = None) -> float:
        """The REAL64 at ``path``, after writing it if a value is given."""
        offset = self.places[path][0]
        if value is not None:
            struct.pack_into("=d", self.memory, offset, value)
        return float(struct.unpack_from("=d", self.memory, offset)[0])

    def bytes(self, path: str, value: bytes | None = None) -> bytes:
        """The bytes at ``path``, after writing them if they are given."""
        offset, field = self.places[path]
        if value is not None:
            self.memory[offset : offset + len(value)] = value
        return bytes(self.memory[offset : offset + field.size_bytes])


def attached(controller: Controller | None = None) -> tuple[Controller, Plc]:
    """A controller with an image in this process."""
    controller = controller or Controller()
    return controller, Plc(controller, controller.interface_image().external)


# --- the two ways -----------------------------------------------------------------------------


NUMBERS = [
    ("FLAG", "B", [0, 1]),
    ("SMALL", "b", [-128, -1, 127]),
    ("BYTE", "B", [0, 200, 255]),
    ("SHORT", "h", [-32768, 32767]),
    ("WORD", "H", [0, 65535]),
    ("COUNT_POS", "i", [-(2**31), 2**31 - 1]),
    ("COUNT", "I", [0, 2**31 - 1, 2**31, 2**32 - 1]),
    ("SYNC", "d", [-1.5, 1e300, 0.1]),
]


@pytest.mark.parametrize(("path", "code", "values"), NUMBERS)
def test_numbers_go_both_ways(path: str, code: str, values: list[float]) -> None:
    """Each type has its bytes in the image; both ends of its range pass in both directions."""
    controller, plc = attached()
    for value in values:
        controller.write(f"V.E.{path}", value)
        controller.step(1)
        assert plc.bytes(path) == struct.pack(f"={code}", value)
    for value in values:
        plc.bytes(path, struct.pack(f"={code}", value))
        controller.step(1)
        assert controller.read(f"V.E.{path}") == value
        assert plc.bytes(path) == struct.pack(f"={code}", value)


def test_what_the_plc_writes_counts_from_the_next_tick_on() -> None:
    """RC-002: latched at the start of a tick; until then the old value is read."""
    controller, plc = attached()
    plc.real("SYNC", 47.0)
    assert controller.read("V.E.SYNC") == 0.0
    controller.step(1)
    assert controller.read("V.E.SYNC") == 47.0


def test_texts_go_both_ways() -> None:
    """A string is its characters in Windows-1252 and a zero byte; the rest is no text."""
    controller, plc = attached()
    controller.write("V.E.TEXT", "Größe €")
    controller.step(1)
    assert plc.bytes("TEXT") == b"Gr\xf6\xdfe \x80".ljust(128, b"\0")
    plc.bytes("TEXT", b"ab\0cd")
    controller.step(1)
    assert controller.read("V.E.TEXT") == "ab"
    plc.bytes("TEXT", b"x" * 128)
    controller.step(1)
    assert controller.read("V.E.TEXT") == "x" * 128


def test_nested_members_and_elements_have_their_places(tmp_path: Path) -> None:
    """Every number of an array of structures goes to its own place, both ways."""
    controller, plc = attached(Controller(machine_with(tmp_path, NESTED, 1)))
    controller.write("V.E.OUTERS[1].INNER[1].LONG", 4_000_000_000)
    controller.write("V.E.OUTERS[1].INNER[1].BYTES[2]", 7)
    controller.write("V.E.OUTERS[0].INNER[0].TEXT", "abcd")
    plc.bytes("OUTERS[0].SHORT", struct.pack("=h", -2))
    controller.step(1)
    assert plc.bytes("OUTERS[1].INNER[1].LONG") == struct.pack("=I", 4_000_000_000)
    place = plc.places["OUTERS[1].INNER[1].BYTES"][0]
    assert bytes(plc.memory[place : place + 3]) == b"\0\0\x07"
    assert plc.bytes("OUTERS[0].INNER[0].TEXT") == b"abcd\0"
    assert controller.read("V.E.OUTERS[0].SHORT") == -2


def test_only_what_the_plc_has_changed_counts() -> None:
    """A cycle's value is not set back by the old bytes of the image; what is not written stays."""
    controller, plc = attached()
    plc.real("VALUE1", 5.0)
    cycle = "#RT CYCLE [SCOPE=PROG]\nV.E.VALUE = V.E.VALUE + 1\n#RT CYCLE END\n#TIME 0.01\nM30"
    controller.run(NcText("p.nc", cycle))
    assert plc.real("VALUE") == controller.read("V.E.VALUE") > 5.0
    assert controller.read("V.E.VALUE1") == plc.real("VALUE1") == 5.0


def test_a_cycle_sees_the_plcs_value_and_the_image_shows_the_cycles_value() -> None:
    """In one tick: latched before the cycles, published after them (RC-002)."""
    controller, plc = attached()
    program = "#RT CYCLE [SCOPE=PROG]\nV.E.VALUE2 = V.E.SYNC * 2\n#RT CYCLE END\n#TIME 1\nM30"
    controller.start(NcText("p.nc", program))
    controller.step(2)
    plc.real("SYNC", 21.0)
    controller.step(1)
    assert plc.real("VALUE2") == 42.0


def test_the_api_wins_over_the_image() -> None:
    """Both written before one tick: the image first, then what was written by name."""
    controller, plc = attached()
    plc.real("SYNC", 1.0)
    controller.write("V.E.SYNC", 2.0)
    controller.step(1)
    assert controller.read("V.E.SYNC") == plc.real("SYNC") == 2.0


def test_rights_bind_programs_only() -> None:
    """P-EXTV-00006: the PLC writes a READ_ONLY variable and reads a WRITE_ONLY one."""
    controller, plc = attached()
    plc.real("INPUT", 3.0)
    controller.run(NcText("p.nc", "V.E.OUTPUT = V.E.INPUT + 1\n#TIME 0.002\nM30"))
    assert plc.real("OUTPUT") == 4.0


def test_what_is_neither_0_nor_1_is_true() -> None:
    """A BOOLEAN byte other than 0 is TRUE, and is shown as 1."""
    controller, plc = attached()
    plc.bytes("FLAG", b"\x05")
    controller.step(1)
    assert controller.read("V.E.FLAG") is True
    assert plc.bytes("FLAG") == b"\x01"


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), float("-inf")])
def test_numbers_that_are_not_finite_are_refused(wrong: float) -> None:
    """RC-307: the variable keeps its value, the image gets it back; reported once for a variable.

    The controller has a number for infinite values and one for NaN.
    """
    controller, plc = attached()
    controller.write("V.E.SYNC", 5.0)
    controller.step(1)
    for _ in range(3):
        plc.real("SYNC", wrong)
        plc.real("LIST", wrong)
        controller.step(1)
        assert controller.read("V.E.SYNC") == plc.real("SYNC") == 5.0
    number = 21821 if math.isnan(wrong) else 21820
    assert [one.id for one in controller.diagnostics] == [number, number]
    texts = [one.text("en") for one in controller.diagnostics]
    assert "V.E.SYNC" in texts[0]
    assert "V.E.LIST[0]" in texts[1]
    plc.real("SYNC", 6.0)
    controller.step(1)
    assert controller.read("V.E.SYNC") == 6.0


def test_bytes_between_variables_mean_nothing() -> None:
    """What is written into gaps is left alone."""
    controller, plc = attached()
    gap = plc.places["LIST"][0] - 4
    plc.memory[gap : gap + 4] = b"\xff" * 4
    controller.step(3)
    assert bytes(plc.memory[gap : gap + 4]) == b"\xff" * 4
    assert controller.read("V.E.COUNT") == 0


# --- runs -------------------------------------------------------------------------------------

PROGRAM = """
#RT CYCLE [SCOPE=PROG]
  V.E.COUNT += 1
  $IF EDGE V.E.COUNT > 5
    V.E.LIST[V.E.COUNT] = V.RTA.ACS.ACT_POS.X
    V.E.FLAG = TRUE
  $ENDIF
#RT CYCLE END
V.E.TEXT = "moving"
G01 X5 F3000
V.E.TEXT = "done"
V.E.ASYNC = 3
G01 X0
M30
"""


def run_in_pieces(pieces: list[int], *, image: bool) -> tuple[list[str], bytes]:
    """Events of a run cut into these pieces, and the image at its end."""
    controller = Controller()
    live = controller.interface_image() if image else None
    controller.start(NcText("p.nc", PROGRAM))
    for ticks in pieces:
        controller.step(ticks)
    values = [repr(controller.read(f"V.E.{one}")) for one in ("COUNT", "LIST[6]", "TEXT", "FLAG")]
    return values, b"" if live is None else bytes(live.external)


def test_the_cutting_of_a_run_changes_nothing() -> None:
    """As long as nobody writes: the same values and the same bytes, whatever the pieces."""
    whole = run_in_pieces([400], image=True)
    assert whole == run_in_pieces([1] * 400, image=True)
    assert whole == run_in_pieces([7, 150, 3, 240], image=True)
    assert whole[0] == run_in_pieces([400], image=False)[0]


def test_texts_of_the_program_come_in_their_tick() -> None:
    """A synchronous text travels in the queue: it is in the image when the blocks before are."""
    controller, plc = attached()
    controller.start(NcText("p.nc", PROGRAM))
    controller.step(2)
    assert plc.bytes("TEXT").startswith(b"moving\0")
    while float(controller.read("V.RTA.ACS.ACT_POS.X")) < 4.99:
        assert plc.bytes("TEXT").startswith(b"moving\0")
        controller.step(1)
    controller.step(5)
    assert plc.bytes("TEXT") == b"done".ljust(128, b"\0")


# --- life -------------------------------------------------------------------------------------


def test_a_controller_has_one_image_at_a_time() -> None:
    """A second one is refused (900347); after closing the first there can be another."""
    controller = Controller()
    first = controller.interface_image()
    with pytest.raises(Failure) as caught:
        controller.interface_image()
    assert caught.value.diagnostics[0].id == 900347
    first.close()
    assert first.is_closed
    first.close()
    with controller.interface_image() as second:
        assert not second.is_closed
    assert second.is_closed
    controller.step(1)


def test_two_controllers_have_two_images() -> None:
    """Controllers of one process do not know of each other."""
    (one, plc), (_, other) = attached(), attached()
    plc.real("SYNC", 1.0)
    one.step(1)
    assert other.real("SYNC") == 0.0


def test_the_image_begins_with_the_values_of_now() -> None:
    """Attached in the middle of a controller's life it shows what the variables hold."""
    controller = Controller()
    controller.write("V.E.SYNC", 9.0)
    controller.step(1)
    _, plc = attached(controller)
    assert plc.real("SYNC") == 9.0


def test_a_section_is_the_bytes_of_one_scope() -> None:
    """``section``: 0 for GLOBAL, else the number of the channel; writable."""
    controller = Controller()
    with controller.interface_image() as image:
        section = image.section(0)
        assert len(section) == sections(controller.machine)[0].size_bytes
        struct.pack_into("=d", section, 0, 4.5)
        controller.step(1)
        section.release()
    assert controller.read("V.E.VALUE") == 4.5


READER = """
import mmap, struct, sys, time
with open("/dev/shm/" + sys.argv[1], "r+b") as file:
    memory = mmap.mmap(file.fileno(), 0)
place, answer = int(sys.argv[2]), int(sys.argv[3])
end = time.monotonic() + 60
while struct.unpack_from("=d", memory, place)[0] != 12.5 and time.monotonic() < end:
    time.sleep(0.002)
struct.pack_into("=d", memory, answer, 2 * struct.unpack_from("=d", memory, place)[0])
"""


@needs_shared_folder
def test_another_process_sees_the_variables_live(name: str) -> None:
    """In named shared memory: it reads what a cycle writes, and what it writes comes here."""
    controller = Controller()
    with controller.interface_image(name) as image:
        plc = Plc(controller, image.external)
        first = image.layout.ve_offset
        places = [str(first + plc.places[path][0]) for path in ("VALUE", "SYNC")]
        with subprocess.Popen([sys.executable, "-c", READER, name, *places]) as other:
            controller.write("V.E.VALUE", 12.5)
            controller.step(1)
            assert other.wait(60) == 0
        controller.step(1)
        assert controller.read("V.E.SYNC") == 25.0
    assert not (SHARED_FOLDER / name).exists()


def test_shared_memory_goes_when_the_image_is_closed(name: str) -> None:
    """Nobody can open it any longer; the name is free again."""
    controller = Controller()
    controller.interface_image(name).close()
    with pytest.raises(FileNotFoundError):
        SharedMemory(name)
    with controller.interface_image(name):
        controller.step(1)


def test_shared_memory_goes_with_its_controller(name: str) -> None:
    """Also when nobody has closed the image."""
    controller = Controller()
    controller.interface_image(name)
    del controller
    with pytest.raises(FileNotFoundError):
        SharedMemory(name)


def test_a_view_that_lives_keeps_the_memory_and_is_reported(name: str) -> None:
    """900348; the name is gone all the same, and closing again is all that is left to do."""
    image = Controller().interface_image(name)
    view = image.section(1)
    with pytest.raises(Failure) as caught:
        image.close()
    assert caught.value.diagnostics[0].id == 900348
    view.release()
    image.close()


def test_a_name_in_use_is_reported(name: str) -> None:
    """900349: two controllers cannot have one name."""
    with Controller().interface_image(name):
        with pytest.raises(Failure) as caught:
            Controller().interface_image(name)
        assert caught.value.diagnostics[0].id == 900349


@pytest.mark.parametrize("wrong", ["a/b/c", "x" * 300, "", "é" * 9, "a:b", "a\nb", "a\0b"])
def test_a_name_that_cannot_be_is_reported(wrong: str) -> None:
    """900350 has the system's reason; nothing is left behind."""
    controller = Controller()
    with pytest.raises(Failure) as caught:
        controller.interface_image(wrong)
    assert caught.value.diagnostics[0].id == 900350
    controller.interface_image().close()
    assert wrong not in {path.name for path in SHARED_FOLDER.glob("*")}


KILLED = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # also in the background
from nctakt.run.controller import Controller
controller = Controller()
image = controller.interface_image(sys.argv[1])
print("ready", flush=True)
while True:
    controller.step(1000)
"""


@needs_shared_folder
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_shared_memory_goes_when_the_process_is_killed(name: str, how: signal.Signals) -> None:
    """In the middle of a run, however hard, and Python's own process says nothing of it."""
    command = [sys.executable, "-c", KILLED, name]
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with subprocess.Popen(command, **streams) as process:  # type: ignore[call-overload]
        assert process.stdout.readline() == b"ready\n"
        assert (SHARED_FOLDER / name).exists()
        process.send_signal(how)
        try:
            process.wait(60)
        finally:
            process.kill()
        # It ends when the process that removes the memory has ended.
        assert b"UserWarning" not in process.stderr.read()
    end = time.monotonic() + 60
    while (SHARED_FOLDER / name).exists() and time.monotonic() < end:
        time.sleep(0.02)
    assert not (SHARED_FOLDER / name).exists()


def test_an_image_is_reported_from_what_describes_it() -> None:
    """What the controller gives is an ``SharedImage`` without a name, or with that one."""
    controller = Controller()
    with controller.interface_image() as image:
        assert isinstance(image, SharedImage)
        assert image.name is None


def two_channels(tmp_path: Path) -> Controller:
    """The demo machine twice: two channels with GLOBAL variables in common."""
    folder = folder_with(
        tmp_path,
        (DEMO / "ext_var1.lis").read_text("utf-8").replace("Ende", ""),
        kanal_anzahl=2,
        **{"sda_mds[1]": "./sda_mds2.lis", "ve_var[1]": "./ext_var1.lis"},
    )
    (folder / "sda_mds2.lis").write_text("Ende\n", "utf-8")
    return Controller(folder)


def test_each_channel_has_a_section_of_its_own(tmp_path: Path) -> None:
    """GLOBAL variables are there once, those of the channels once for each."""
    controller = two_channels(tmp_path)
    machine = controller.machine
    assert [one.channel for one in sections(machine)] == [0, 1, 2]
    assert describe(machine, 1) == describe(machine, 2)
    with controller.interface_image() as image:
        place = next(field.offset for field in describe(machine, 2) if field.path == "SYNC")
        second = sections(machine)[2].offset + place
        struct.pack_into("=d", image.external, second, 8.0)
        controller.step(1)
        assert controller.read("V.E.SYNC") == 0.0
        assert struct.unpack_from("=d", image.external, second) == (8.0,)
        struct.pack_into("=d", image.external, second, float("nan"))
        controller.step(1)
        assert struct.unpack_from("=d", image.external, second) == (8.0,)
        assert controller.diagnostics[-1].id == 21821
        assert "V.E.SYNC" in controller.diagnostics[-1].text("en")
