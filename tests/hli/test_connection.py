# SPDX-License-Identifier: MIT
"""The PLC's side of the HLI by names, attached from outside (docs/hli.md, "A PLC in Python")."""

from __future__ import annotations

import os
import secrets
import struct
import threading
from collections.abc import Iterator

import pytest

from nctakt import Controller, Failure, NcText, hli
from nctakt.cli.common.hli_partner import waiter
from nctakt.hli.connection import FOLDER, PlcConnection
from nctakt.hli.image_access import ImageAccess
from nctakt.hli.layout import COMMAND, HEADER, LINK
from nctakt.hli.places import entry, size_of
from nctakt.hli.plc_side import PlcSide
from nctakt.plc import AnyPlc, PartnerPlc
from nctakt.run.access.shared_image import SharedImage
from nctakt.run.plcs.plc_view import PlcView

pytestmark = pytest.mark.skipif(not FOLDER.is_dir(), reason="shared memory without files")


def new_name() -> str:
    """A name that nobody else uses."""
    return f"nctakt_{os.getpid()}_{secrets.token_hex(4)}"


class Cell:
    """A controller that shares its HLI, and a PLC at it, in one process."""

    def __init__(self, machine: str | None = None) -> None:
        self.controller = Controller(machine)
        self.image: SharedImage = self.controller.interface_image(new_name())
        assert self.image.name is not None
        self.plc: PlcConnection = hli.attach(self.image.name)

    def close(self) -> None:
        """The PLC leaves first."""
        self.plc.close()
        self.image.close()


@pytest.fixture
def cell() -> Iterator[Cell]:
    one = Cell()
    yield one
    one.close()


def number_of(caught: pytest.ExceptionInfo[Failure]) -> int:
    """The number of the first message."""
    return caught.value.diagnostics[0].id


# --- names ----------------------------------------------------------------------------------------


def test_axes_channels_and_spindles_have_their_names(cell: Cell) -> None:
    """The values are those that a scripted PLC sees."""
    cell.controller.start(NcText("p.nc", "G01 X10 F1000\nM30"))
    cell.controller.step(50)
    plc, scripted = cell.plc, cell.controller.hli
    assert plc.axes[:3] == ("X", "Y", "Z")
    assert plc.axis("X") == pytest.approx(dict(scripted.axis("X")), abs=5e-5)  # in 0.1 µm
    assert plc.axis("X")["command"] > 0.0
    assert plc.channel() == pytest.approx(dict(scripted.channel()), abs=5e-4)  # in µm/s
    assert plc.spindle("S")["speed"] == 0.0
    assert (plc.tick, plc.time_us, plc.cycle_time_us) == (49, 49_000, 1000)
    assert (plc.state, plc.is_paused, plc.error) == ("running", False, 0)


def test_the_override_of_a_spindle(cell: Cell) -> None:
    """By the same name as in a scripted PLC, each spindle its own."""
    names = [f"HLI.{spindle}.OVERRIDE" for spindle in ("S", "S2")]
    assert [cell.plc.read(name) for name in names] == [100.0, 100.0]
    cell.plc.write("HLI.S2.OVERRIDE", 50)
    cell.controller.step()
    assert [cell.plc.read(name) for name in names] == [100.0, 50.0]
    assert [cell.controller.hli.read(name) for name in names] == [100.0, 50.0]
    cell.controller.hli.write("HLI.S.OVERRIDE", 80)
    cell.controller.step()
    assert [cell.plc.read(name) for name in names] == [80.0, 50.0]
    for name, value in ((names[0], -1), ("HLI.S9.OVERRIDE", 50), (names[0], "fast")):
        with pytest.raises(Failure):
            cell.plc.write(name, value)


@pytest.mark.parametrize(
    ("ask", "number", "nearest"),
    [
        (lambda plc: plc.axis("XX"), 900656, "X"),
        (lambda plc: plc.axis("X")["comand"], 901012, "command"),
        (lambda plc: plc.spindle("S9"), 901437, "S"),
        (lambda plc: plc.of_channel(3), 900749, ""),
        (lambda plc: plc.read("V.E.VALU"), 901435, "V.E.VALUE"),
        (lambda plc: plc.read("V.G.TIMER[1]"), 901435, ""),
        (lambda plc: plc.write("HLI.OVERIDE", 5), 901435, "HLI.OVERRIDE"),
        (lambda plc: plc.write("HLI.STATE", 1), 900542, ""),
        (lambda plc: plc.write("HLI.OVERRIDE", -1), 20847, ""),
        (lambda plc: plc.write("V.E.FLAGS[99]", 1), 901436, "7"),
        (lambda plc: plc.write("V.E.VALUE", "text"), 900543, ""),
        (lambda plc: plc.write("V.E.VALUE", float("nan")), 50893, ""),
    ],
)
def test_a_wrong_name_or_value_is_refused(
    cell: Cell, ask: object, number: int, nearest: str
) -> None:
    """Each says what was meant, in both languages."""
    assert callable(ask)
    with pytest.raises(Failure) as caught:
        ask(cell.plc)
    assert number_of(caught) == number
    assert nearest in str(caught.value)
    assert caught.value.diagnostics[0].render("de") != caught.value.diagnostics[0].render("en")


def test_variables_go_both_ways(cell: Cell) -> None:
    """A write counts from the next tick on; integers are rounded as everywhere (RC-307)."""
    names = cell.plc.variables
    assert "V.E.VALUE" in names
    cell.plc.write("V.E.VALUE", 7)
    cell.plc.write("v.e.FLAGS[1]", True)
    cell.controller.step(1)
    assert cell.controller.read("V.E.VALUE") == 7
    assert cell.controller.read("V.E.FLAGS[1]") == cell.plc.read("V.E.FLAGS[1]")
    cell.controller.write("V.E.VALUE", 9)
    cell.controller.step(1)
    assert cell.plc.read("CH1.V.E.VALUE") == 9


def test_all_variables_are_those_of_the_machine(cell: Cell) -> None:
    """Each number and text that the image names reads as the controller's."""
    for name in cell.plc.variables:
        element = name
        try:
            value = cell.plc.read(name)
        except Failure:  # an array has no value of its own
            element = f"{name}[0]"
            value = cell.plc.read(element)
        assert value == cell.controller.read(element), name


def test_keys_and_lamps(cell: Cell) -> None:
    """The same attributes as those of ``controller.hli``."""
    cell.plc.override_pct = 50
    cell.plc.feed_hold = True
    cell.controller.step(1)
    assert (cell.controller.hli.override_pct, cell.controller.hli.feed_hold) == (50.0, True)
    cell.controller.select(NcText("p.nc", "M30"))
    cell.controller.step(1)
    assert cell.plc.is_armed
    cell.plc.start()
    cell.controller.step(1)
    assert not cell.plc.is_armed


# --- acknowledgements -----------------------------------------------------------------------------


def test_a_function_is_acknowledged_once(cell: Cell) -> None:
    """A serial that no longer waits is refused and has no effect."""
    cell.controller.start(NcText("p.nc", "M100\nM101\nM30"))
    cell.controller.step(5)
    first, second = cell.plc.functions()
    assert [first, second] == cell.controller.hli.functions()
    assert (first.name, second.name) == ("M100", "M101")
    assert cell.plc.acknowledge(first)
    cell.controller.step(1)
    assert not cell.plc.acknowledge(first)
    cell.controller.step(1)
    assert cell.plc.functions() == [second]
    with pytest.raises(ValueError, match="slot"):
        cell.plc.acknowledge(first.__class__("M", 1, 1, 0, False, 0.0, "", 99))


def test_a_spindle_job_is_acknowledged(cell: Cell) -> None:
    """The PLC turns S3; its job has the numbers that a scripted PLC sees."""
    cell.controller.start(NcText("p.nc", "S3[REV500 M3]\nM30"))
    cell.controller.step(5)
    (job,) = cell.plc.spindle_jobs()
    assert [job] == cell.controller.hli.spindle_jobs()
    assert cell.plc.acknowledge_spindle(job)
    cell.controller.step(2)
    assert cell.plc.spindle_jobs() == []
    assert not cell.plc.acknowledge_spindle(job)


# --- attaching and leaving ------------------------------------------------------------------------


def test_an_hli_that_nobody_shares_is_reported() -> None:
    """901430 names those that there are."""
    with Controller().interface_image(new_name()) as image:
        with pytest.raises(Failure) as caught:
            hli.attach("no_such_cell", within_s=0.0)
        assert number_of(caught) == 901430
        assert str(image.name) in str(caught.value)


@pytest.mark.parametrize(
    ("offset", "data", "number"),
    [
        (0, b"OTHER", 901431),
        (entry(HEADER, "version").offset, struct.pack("=I", 5), 901432),
        (entry(HEADER, "axis_size").offset, struct.pack("=I", 8), 901433),
        (entry(HEADER, "axes").offset, struct.pack("=I", 2**32 - 1), 901433),
        (entry(HEADER, "link_offset").offset, struct.pack("=I", 2**31), 901433),
        (entry(HEADER, "names_size").offset, struct.pack("=I", 17), 901433),
        (entry(HEADER, "size").offset, struct.pack("=I", 2**31), 901433),
    ],
)
def test_memory_of_another_kind_is_refused(offset: int, data: bytes, number: int) -> None:
    """Another layout is never read by these offsets; the memory stays usable for others."""
    with Controller().interface_image(new_name()) as image:
        image.memory[offset : offset + len(data)] = data
        with pytest.raises(Failure) as caught:
            hli.attach(str(image.name), within_s=0.0)
        assert number_of(caught) == number


def test_random_bytes_are_refused_or_read(cell: Cell) -> None:
    """A flipped byte of the header is a failure with a message, never another exception."""
    header = bytes(cell.image.memory[: entry(HEADER, "sequence").offset])
    for offset in range(8, len(header)):
        for flipped in (0x01, 0x80):
            copy = bytearray(cell.image.memory)
            copy[offset] ^= flipped
            try:
                ImageAccess("copy", memoryview(copy))
            except Failure as failure:
                assert failure.diagnostics[0].id in (901431, 901432, 901433)


def test_an_image_that_is_cut_off_is_refused(cell: Cell) -> None:
    """901433 before anything after its end is touched, which would end the process (SIGBUS)."""
    whole = bytearray(cell.image.memory)
    ImageAccess("copy", memoryview(whole))
    for length in (len(whole) - 1, len(whole) // 2, size_of(HEADER)):
        with pytest.raises(Failure) as caught:
            ImageAccess("copy", memoryview(whole)[:length])
        assert number_of(caught) == 901433


def test_a_second_plc_is_refused(cell: Cell) -> None:
    """901434 while the process of the first one lives."""
    with pytest.raises(Failure) as caught:
        hli.attach(str(cell.image.name))
    assert number_of(caught) == 901434
    cell.plc.close()
    with hli.attach(str(cell.image.name)) as second:
        assert second.is_running


def test_leaving_is_reported_to_the_cnc(cell: Cell) -> None:
    """After the end of the context manager the CNC acknowledges by itself."""
    access = ImageAccess("cell", cell.image.memory[:])
    assert access.number(LINK, access.offset(LINK), "process") == os.getpid()
    assert access.number(COMMAND, access.offset(COMMAND), "plc_present") == 1
    with cell.plc:
        pass
    assert access.number(LINK, access.offset(LINK), "process") == 0
    assert access.number(COMMAND, access.offset(COMMAND), "plc_present") == 0
    access.release()


# --- ticks ----------------------------------------------------------------------------------------


def test_without_lockstep_a_tick_is_noticed(cell: Cell) -> None:
    """901439 while none comes; the latest one counts; the end of the CNC ends the ticks."""
    assert not cell.plc.is_lockstep
    with pytest.raises(Failure) as caught:
        cell.plc.next_tick(within_s=0.0)
    assert number_of(caught) == 901439
    cell.controller.step(3)
    assert cell.plc.next_tick()
    assert cell.plc.tick == 2
    cell.image.close()
    assert not cell.plc.next_tick()
    assert list(cell.plc.ticks()) == []


class Acknowledger:
    """A PLC of a user: the same class works as a scripted one."""

    def cycle(self, view: PlcSide | PlcView) -> None:
        """Acknowledge everything at half speed."""
        view.override_pct = 50
        view.acknowledge_all()


def test_in_lockstep_a_class_does_what_the_scripted_one_does() -> None:
    """The CNC waits for the PLC after each tick: both runs have the same positions."""
    program = NcText("p.nc", "G01 X5 F5000\nM100\nS3[REV500 M3]\nX0\nM30")

    def positions(controller: Controller, plc: AnyPlc) -> list[float]:
        run = controller.run(program, plc=plc, signals=["X.ACS.ACT_POS"])
        assert run.trace is not None
        return list(run.trace["X.ACS.ACT_POS"])

    controller = Controller()
    with controller.interface_image(new_name()) as image:
        partner = PartnerPlc(image, waiter(60.0))
        name = str(image.name)

        def answer() -> None:
            with hli.attach(name) as plc:
                plc.run(Acknowledger())

        thread = threading.Thread(target=answer)
        thread.start()
        partner.await_presence()
        outside = positions(controller, partner)
    thread.join(60.0)
    assert outside == positions(Controller(), Acknowledger())
