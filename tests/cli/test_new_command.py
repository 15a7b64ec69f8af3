# SPDX-License-Identifier: MIT
"""``nctakt new``: the folder it writes loads without a finding and is the demo machine."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.machine import Machine, load_machine
from nctakt.machines.commented import DEMO


def without_files(machine: Machine) -> tuple[object, ...]:
    """What a machine is, whatever its files are called and whichever lines they have."""

    def bare(axis: AxisConfiguration) -> AxisConfiguration:
        return replace(axis, file="")

    channels = tuple(
        replace(
            one,
            startup=replace(
                one.startup,
                parameters=None,
                variables=None,
                tools=None,
                zero_offsets=None,
                clamp_offsets=None,
            ),
        )
        for one in machine.channels
    )
    axes = tuple(bare(axis) for axis in machine.axes)
    return machine.cycle_time_us, channels, axes, machine.global_variables


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_folder_is_the_demo_machine(
    language: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """No finding, not even a note; every value is that of the built-in machine."""
    folder = tmp_path / "new" / "machine"
    assert main(["new", str(folder), "--lang", language]) == 0
    told = capsys.readouterr()
    assert "15" in told.out
    assert f"nctakt check {folder}" in told.out
    machine = load_machine(folder)
    assert machine.diagnostics == ()
    assert without_files(machine) == without_files(load_machine(None))


def test_each_parameter_is_explained_where_it_first_stands(tmp_path: Path) -> None:
    """Once in each list, in the language that was asked for, with ID and unit."""
    assert main(["new", str(tmp_path / "en")]) == 0
    assert main(["new", str(tmp_path / "de"), "--lang", "de"]) == 0
    english = (tmp_path / "en" / "default_achs.lis").read_text("utf-8")
    assert "( P-AXIS-00212: Highest speed of the axis [µm/s, 1e-3°/s]" in english
    german = (tmp_path / "de" / "sda_mds1.lis").read_text("utf-8")
    assert german.count("P-CHAN-00006: Name einer Achse in NC-Programmen") == 1
    assert german.startswith("# Kanal der Demo-Maschine\n")


@pytest.mark.parametrize("path", sorted(DEMO.glob("*.lis")), ids=lambda path: path.name)
def test_each_line_of_the_demo_machine_is_kept(path: Path, tmp_path: Path) -> None:
    """Headings and entries in the same order, in both languages."""
    lines = path.read_text("utf-8").splitlines()
    for language in ("en", "de"):
        assert main(["new", str(tmp_path / language), "--lang", language]) == 0
        written = (tmp_path / language / path.name).read_text("utf-8").splitlines()
        assert [line.split()[0] for line in written] == [line.split()[0] for line in lines]


def test_a_folder_in_use_is_left_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Something is in it: nothing is written, exit code 2."""
    (tmp_path / "mine.txt").write_text("x")
    assert main(["new", str(tmp_path)]) == 2
    assert "900746" in capsys.readouterr().err
    assert [one.name for one in tmp_path.iterdir()] == ["mine.txt"]


def test_an_empty_folder_is_used(tmp_path: Path) -> None:
    """That it exists does not matter."""
    assert main(["new", str(tmp_path)]) == 0
    assert (tmp_path / "hochlauf.lis").is_file()


def test_what_cannot_be_written_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A file stands where the folder would be: exit code 2 with the system's reason."""
    (tmp_path / "file").write_text("x")
    assert main(["new", str(tmp_path / "file")]) == 2
    assert "900747" in capsys.readouterr().err
