# SPDX-License-Identifier: MIT
"""``python -m benchmarks.lists``: how fast a complete machine folder is read and checked.

The folder is invented: 20 lists with 3,000 entries, most of them in the tables of parameters
without effect. Measured in a new process each time, as a user has it: the first reading, in which
the tables are read as well, and the next one. The goal is 0.15 s.
"""

from __future__ import annotations

import platform
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from nctakt.lists.all_parameters import SCHEMA_BY_KIND
from nctakt.lists.format.parameter import Effect, Parameter, ValueType, shown, with_indices

REPEATS = 5
AXES = 8
#: Kind of list -> the entry of the start-up list, how many of them, entries of each.
LISTS = (
    ("channel", "sda_mds[{}]", 2, 370),
    ("axis", "achs_mds[{}]", AXES, 206),
    ("tools", "werkz_data[{}]", 2, 160),
    ("axis_compensation", "achs_kw[{}]", 3, 60),
    ("manual_mode", "hand_mds", 1, 20),
    ("scene", "scene_mds[{}]", 1, 60),
    ("hardware", "hw_configuration_list", 1, 10),
)
_HEADS = {
    "channel": "gruppe[0].achs_anzahl 1\ngruppe[0].achse[0].log_achs_nr {n}\n"
    "gruppe[0].achse[0].bezeichnung X\n",
    "axis": "kopf.achs_nr {n}\n",
}
_MEASURE = """
import sys, time
from nctakt.lists.machine.machine import load_machine
begin = time.perf_counter()
machine = load_machine(sys.argv[1])
middle = time.perf_counter()
load_machine(sys.argv[1])
end = time.perf_counter()
print(middle - begin, end - middle, len(machine.lists))
"""


def entries(kind: str, count: int) -> Iterator[str]:
    """Lines with parameters of a kind without effect, at their defaults; indices go up."""
    parameters = [
        parameter
        for parameter in SCHEMA_BY_KIND[kind].parameters
        if parameter.effect is Effect.WITHOUT_EFFECT
        and parameter.default is not None
        and parameter.type is not ValueType.STRING
        and parameter.at_least is parameter.at_most is None
    ]
    for number in range(count):
        parameter = parameters[number % len(parameters)]
        yield f"{_name(parameter, number // len(parameters))} {shown(parameter.default)}"


def _name(parameter: Parameter, round_: int) -> str:
    indices = tuple(min(low + round_, high) for low, high in parameter.index_ranges)
    return with_indices(parameter.pattern, indices)


def write(folder: Path) -> tuple[int, int]:
    """Write the folder; return how many lists and entries it has."""
    startup = [f"kanal_anzahl 2\nzahl_mds {AXES}\nrtconf_lis rtconf.lis"]
    rtconf = "interrupt_source 2\ncycle_time 1000\ntime_slice 500\nwindows_time 500\n"
    texts = {"rtconf.lis": rtconf}
    for kind, name, lists, count in LISTS:
        for index in range(lists):
            file = f"{kind}_{index}.lis"
            startup.append(f"{name.format(index)} {file}")
            head = _HEADS.get(kind, "").format(n=index + 1)
            texts[file] = head + "".join(f"{line}\n" for line in entries(kind, count))
    texts["hochlauf.lis"] = "\n".join(startup) + "\n"
    for file, text in texts.items():
        (folder / file).write_text(f"{text}End\n", "utf-8")
    return len(texts), sum(len(text.splitlines()) for text in texts.values())


def main() -> None:
    """Measure and print."""
    print(f"{platform.python_implementation()} {platform.python_version()}, {platform.machine()}")
    with tempfile.TemporaryDirectory() as folder:
        lists, count = write(Path(folder))
        print(f"{lists} lists, {count} entries")
        times = []
        for _ in range(REPEATS):
            output = subprocess.run(
                [sys.executable, "-c", _MEASURE, folder], check=True, capture_output=True, text=True
            ).stdout.split()
            assert int(output[2]) == lists
            times.append((float(output[0]), float(output[1])))
    print(f"first reading  {min(first for first, _ in times):8.3f} s")
    print(f"next reading   {min(second for _, second in times):8.3f} s")


if __name__ == "__main__":
    main()
