# SPDX-License-Identifier: MIT
"""What a PLC writes into the image of the HLI as inputs of a run."""

from __future__ import annotations

import struct

import pytest

from nctakt import Controller, Failure, NcText
from nctakt.hli.layout import CHANNEL, COMMAND, UNIT
from nctakt.hli.places import entry, unit_offset
from nctakt.run.access.inputs import Cells, Input, unpack
from nctakt.run.access.tape import Tape
from nctakt.run.plcs.plc_view import PlcView


def test_what_a_plc_writes_into_the_image_is_on_the_tape_by_name() -> None:
    """What it writes after tick 3 is an input of tick 4 (RC-002), and a replay puts it there."""
    program = NcText("part.nc", "M100\nG01 X10 F6000\nM30")
    cells: Cells = []

    class Partner:
        """Acknowledges in the image, as another process does."""

        def __init__(self, controller: Controller) -> None:
            self.image = controller.interface_image()

        def cycle(self, hli: PlcView) -> None:
            memory, layout = self.image.memory, self.image.layout
            if hli.tick == 3:
                override = layout.command(0) + entry(COMMAND, "override").offset
                struct.pack_into("=H", memory, override, 500)  # 0.1 %
            if hli.tick == 5:
                serial = layout.channel(0) + unit_offset(CHANNEL, "program")
                serial += entry(UNIT, "serial").offset
                answer = layout.command(0) + entry(COMMAND, "ack_program").offset
                memory[answer : answer + 4] = memory[serial : serial + 4]

    controller = Controller()
    partner = Partner(controller)
    run = controller.run(program, plc=partner, record=cells.extend)
    partner.image.close()
    inputs = unpack(cells)
    assert [(one.tick, one.source, one.kind, one.values[0]) for one in inputs] == [
        (4, "hli", "image", "command[1].override"),
        (6, "hli", "image", "command[1].ack_program"),
    ]
    assert inputs[0].values[1] == struct.pack("=H", 500).hex()
    tape = Tape({}, {}, True, tuple(inputs), {}, run.ticks, run.state, {})
    again = Controller().run(program, replay=tape)
    assert again.ticks == run.ticks
    assert list(again.events) == list(run.events)


@pytest.mark.parametrize(
    "values",
    [
        ("command[1].nothing", "00"),
        ("command[1].feed_hold", "0000"),
        ("command[1].feed_hold", "x"),
        ("V.E.NOTHING", "00"),
    ],
)
def test_a_tape_for_another_image_is_refused(values: tuple[str, str]) -> None:
    """901077."""
    tape = Tape({}, {}, True, (Input(1, "hli", "image", values),), {}, 10, "ended", {})
    with pytest.raises(Failure) as caught:
        Controller().run(NcText("part.nc", "G01 X10 F6000\nM30"), replay=tape)
    assert caught.value.diagnostics[0].id == 901077
