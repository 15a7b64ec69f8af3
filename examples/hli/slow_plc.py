# SPDX-License-Identifier: MIT
"""The PLC of ../slow_plc.py in another process, through the HLI in shared memory.

In one shell: ``nctakt run examples/crossing.nc --hli cell_7``; in another one:
``python examples/hli/slow_plc.py cell_7``. It acknowledges each function after 200 ms; until then
the path runs at half speed.
"""

import mmap
import os
import struct
import sys
import time
from pathlib import Path

from nctakt.hli.layout import AXIS, CHANNEL, COMMAND, HEADER, LINK, MAGIC, UNIT, VERSION
from nctakt.hli.places import entries, entry, size_of, unit_offset
from nctakt.kernel.plc.technology_slots import SLOT_COUNT

FORMATS = {"BOOLEAN": "=B", "UNS08": "=B", "UNS32": "=I", "UNS64": "=Q", "REAL64": "=d"}


class Part:
    """One structure of the image: its values by name."""

    def __init__(self, memory, structure, offset):
        self.memory = memory
        self.offset = offset
        self.places = {one.entry.name: one for one in entries(structure)}

    def __getitem__(self, name):
        place = self.places[name]
        return struct.unpack_from(
            FORMATS[place.entry.type], self.memory, self.offset + place.offset
        )[0]

    def __setitem__(self, name, value):
        place = self.places[name]
        struct.pack_into(FORMATS[place.entry.type], self.memory, self.offset + place.offset, value)


def attach(name):
    """The image as soon as it is there."""
    path = Path("/dev/shm", name)
    for _ in range(1000):
        if path.exists() and path.stat().st_size:
            with path.open("r+b") as file:
                memory = mmap.mmap(file.fileno(), 0)
            if Part(memory, HEADER, 0)["ready"]:
                return memory
        time.sleep(0.01)
    sys.exit(f"there is no HLI {name}")


def main():
    memory = attach(sys.argv[1])
    header = Part(memory, HEADER, 0)
    if memory[: len(MAGIC)] != MAGIC or header["version"] != VERSION:
        sys.exit("another layout")
    link = Part(memory, LINK, header["link_offset"])
    command = Part(memory, COMMAND, header["command_offset"])
    x = Part(memory, AXIS, header["axis_offset"])
    units = [
        (Part(memory, UNIT, header["channel_offset"] + first + slot * size_of(UNIT)), acknowledge)
        for name in ("program", "realtime")
        for first in [unit_offset(CHANNEL, name)]
        for slot in range(SLOT_COUNT)
        for acknowledge in [
            header["command_offset"] + entry(COMMAND, f"ack_{name}").offset + 4 * slot
        ]
    ]
    seen = set()
    link["process"] = os.getpid()  # so that the CNC notices at once when it ends
    command["plc_present"] = 1
    while header["ready"]:
        turn = header["turn"]
        if turn == link["turn"]:
            time.sleep(0.00002)
            continue
        now_us = (header["tick"] - 1) * header["cycle_time_us"]
        waiting = [(unit, acknowledge) for unit, acknowledge in units if unit["serial"]]
        command["override"] = 50.0 if waiting else 100.0
        for unit, acknowledge in waiting:
            if (acknowledge, unit["serial"]) not in seen:
                seen.add((acknowledge, unit["serial"]))
                letter = "MH"[unit["letter"] - 1]
                print(f"{unit['time_us']} us {letter}{unit['number']} X {x['command']:.3f}")
            if now_us - unit["time_us"] >= 200_000:
                struct.pack_into("=I", memory, acknowledge, unit["serial"])
        link["turn"] = turn


main()
