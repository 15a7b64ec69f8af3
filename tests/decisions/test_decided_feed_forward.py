# SPDX-License-Identifier: MIT
"""What is decided about feed-forward control (G135, G136, G137): docs/conformance/lists.md."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.decided import numbers

from nctakt.lists.machine.machine import load_machine
from nctakt.results.run import Run
from nctakt.run.controller import Controller, NcText

#: X has feed-forward control, Y has it forever, Z has none.
SHARES = {
    "x": "vorsteuer.vorsteuerung VEL\nvorsteuer.vs_v_faktor 4\nvorsteuer.vs_v_nenner 5\n",
    "y": "vorsteuer.vorsteuerung VEL\nvorsteuer.default_active 1\n",
    "z": "vorsteuer.vs_v_faktor 1\n",
}


def machine(folder: Path, extra: str = "") -> Path:
    """Three axes whose position control has kv 50/s: 1 mm behind at 50 mm/s."""
    lists = {
        "hochlauf.lis": "kanal_anzahl 1\nsda_mds[0] kanal.lis\nzahl_mds 3\nachs_mds[0] x.lis\n"
        "achs_mds[1] y.lis\nachs_mds[2] z.lis\n",
        "kanal.lis": "gruppe[0].achs_anzahl 3\n",
    }
    for index, name in enumerate("xyz"):
        lists["kanal.lis"] += (
            f"gruppe[0].achse[{index}].bezeichnung {name.upper()}\n"
            f"gruppe[0].achse[{index}].log_achs_nr {index + 1}\n"
        )
        entries = SHARES[name] + (extra if name == "x" else "")
        lists[f"{name}.lis"] = f"kopf.achs_nr {index + 1}\ngetriebe[0].kv 5000\n{entries}"
    for file, text in lists.items():
        (folder / file).write_text(text + "Ende\n")
    return folder


def errors(found: Run, at: str) -> list[float]:
    """The following errors of all axes in mm, where X is at ``at`` mm."""
    assert found.trace is not None
    x = found.trace["X.ACS.ACT_POS"].tolist()
    tick = next(i for i, value in enumerate(x) if value >= float(at))
    return [
        round(
            found.trace[f"{axis}.ACS.ACT_POS"].tolist()[tick]
            - found.trace[f"{axis}.ACS.CUR_POS"].tolist()[tick],
            3,
        )
        for axis in "XYZ"
    ]


def run(controller: Controller, *lines: str) -> Run:
    """A run of these lines; in each axis 50 mm/s."""
    signals = [f"{axis}.ACS.{kind}" for axis in "XYZ" for kind in ("ACT_POS", "CUR_POS")]
    text = "\n".join([*lines, "M30", ""])
    return controller.run(NcText("part.nc", text), signals=signals, ticks=20_000)


F = "G01 G91 F5196.1524"


def test_it_acts_where_programs_ask_for_it(tmp_path: Path) -> None:
    """G135: on, G136: weights, which stay, G137: off; forever by P-AXIS-00255."""
    controller = Controller(load_machine(machine(tmp_path)))
    way = "X100 Y100 Z100"
    found = run(controller, F, way, "G135", way, "G136 X50 Z0", way, "G137", way, "G135", way)
    assert numbers(found) == [900068]
    assert errors(found, "90") == [1.0, 0.0, 1.0]
    assert errors(found, "190") == [0.2, 0.0, 1.0]
    assert errors(found, "290") == [0.6, 0.0, 1.0]
    assert errors(found, "390") == [1.0, 0.0, 1.0]
    assert errors(found, "490") == [0.6, 0.0, 1.0]


def test_on_and_weights_in_one_block_and_anew_with_each_program(tmp_path: Path) -> None:
    controller = Controller(load_machine(machine(tmp_path)))
    way = "X100 Y100 Z100"
    found = run(controller, F, "G135 G136 X25 Y200", way)
    assert errors(found, "90") == [0.8, 0.0, 1.0]
    found = run(controller, F, way)
    assert errors(found, "190") == [1.0, 0.0, 1.0]


def test_off_forever_is_more_than_on(tmp_path: Path) -> None:
    """P-AXIS-00256; with P-AXIS-00255 it is reported (110354)."""
    loaded = load_machine(machine(tmp_path, "vorsteuer.global_disable 1\n"))
    assert [one.id for one in loaded.diagnostics if one.severity.name != "NOTE"] == []
    found = run(Controller(loaded), F, "G135", "X100 Y100 Z100")
    assert errors(found, "90") == [1.0, 0.0, 1.0]
    both = "vorsteuer.global_disable 1\nvorsteuer.default_active 1\n"
    loaded = load_machine(machine(tmp_path, both))
    assert [one.id for one in loaded.diagnostics if one.severity.name != "NOTE"] == [110354]


@pytest.mark.parametrize(("line", "expected"), [("G136 X-1", [901550]), ("G135 G137", [900210])])
def test_wrong_words(tmp_path: Path, line: str, expected: list[int]) -> None:
    found = run(Controller(load_machine(machine(tmp_path))), line)
    assert [one for one in numbers(found) if one != 900068] == expected
