# SPDX-License-Identifier: MIT
"""``nctakt new``: the folder it writes loads without a finding and is the demo machine."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from nctakt.cli import main
from nctakt.lists.machine.axis_configuration import AxisConfiguration
from nctakt.lists.machine.files import DEMO_FOLDER
from nctakt.lists.machine.machine import Machine, load_machine

pytestmark = pytest.mark.slow


def without_files(machine: Machine) -> tuple[object, ...]:
    """What a machine is, whatever its files are called and whichever lines they have."""

    def bare(axis: AxisConfiguration) -> AxisConfiguration:
        return replace(axis, file="")

    channels = tuple(
        replace(
            one,
            ignored_variables=(),
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
    reported = capsys.readouterr()
    assert "15" in reported.out
    assert f"nctakt check {folder}" in reported.out
    machine = load_machine(folder)
    assert machine.diagnostics == ()
    assert without_files(machine) == without_files(load_machine(None))


def test_half_a_machine_is_not_left_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A full disk, Ctrl-C: what was made is removed, what was there stays."""
    opened, count = Path.open, 0

    def broken(path: Path, mode: str = "r", *words: object, **options: object) -> object:
        nonlocal count
        count += mode == "xb"
        if mode == "xb" and count % 4 == 0:
            raise OSError(28, "No space left on device") if count < 5 else KeyboardInterrupt
        return opened(path, mode, *words, **options)  # type: ignore[call-overload]

    monkeypatch.setattr(Path, "open", broken)
    assert main(["new", str(tmp_path / "new" / "machine")]) == 2
    assert "No space left" in capsys.readouterr().err
    (tmp_path / "empty").mkdir()
    assert main(["new", str(tmp_path / "empty")]) == 1
    assert "interrupted" in capsys.readouterr().err
    assert [path.name for path in tmp_path.rglob("*")] == ["empty"]


def test_each_parameter_is_explained_where_it_first_occurs(tmp_path: Path) -> None:
    """Once in each list, in the language that was asked for, with ID and unit."""
    assert main(["new", str(tmp_path / "en")]) == 0
    assert main(["new", str(tmp_path / "de"), "--lang", "de"]) == 0
    english = (tmp_path / "en" / "default_achs.lis").read_text("utf-8")
    assert "( P-AXIS-00212: Highest speed of the axis [µm/s, 1e-3°/s]" in english
    german = (tmp_path / "de" / "sda_mds1.lis").read_text("utf-8")
    assert german.count("P-CHAN-00006: Name einer Achse in NC-Programmen") == 1
    assert german.startswith("# Kanal der Demo-Maschine\n")


@pytest.mark.parametrize("path", sorted(DEMO_FOLDER.glob("*.lis")), ids=lambda path: path.name)
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


def test_what_cannot_be_written_is_reported(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """There is a file where the folder would be: exit code 2 with the system's reason."""
    (tmp_path / "file").write_text("x")
    assert main(["new", str(tmp_path / "file")]) == 2
    assert "900747" in capsys.readouterr().err


# --- the other format ----------------------------------------------------------------------------


@pytest.mark.parametrize("language", ["en", "de"])
def test_the_demo_machine_in_xml(language: str, tmp_path: Path) -> None:
    """The same machine without a finding, with the meanings after the elements."""
    folder = tmp_path / "xml"
    assert main(["new", str(folder), "--format", "xml", "--lang", language]) == 0
    machine = load_machine(folder)
    assert machine.diagnostics == ()
    assert without_files(machine) == without_files(load_machine(None))
    text = (folder / "default_achs.xml").read_text("utf-8")
    assert '<P-AXIS-00212.0 Value="500000" />' in text
    meaning = {"en": "Highest speed of the axis", "de": "Höchste Geschwindigkeit der Achse"}
    assert f"<!-- getriebe[0].dynamik.vb_max: {meaning[language]} [µm/s, 1e-3°/s] -->" in text


@pytest.mark.parametrize("first", ["ascii", "xml"])
def test_there_and_back(first: str, tmp_path: Path) -> None:
    """From one format into the other and back: the same machine, the same text."""
    second = "xml" if first == "ascii" else "ascii"
    folders = [tmp_path / name for name in ("a", "b", "c")]
    assert main(["new", str(folders[0]), "--format", first]) == 0
    assert main(["new", str(folders[1]), "--from", str(folders[0]), "--format", second]) == 0
    assert main(["new", str(folders[2]), "--from", str(folders[1]), "--format", first]) == 0
    machines = [without_files(load_machine(folder)) for folder in folders]
    assert machines[0] == machines[1] == machines[2]
    for path in folders[0].iterdir():
        assert (folders[2] / path.name).read_text("utf-8") == path.read_text("utf-8")


def test_a_machine_of_ones_own(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """From folders into one; comments are kept, unknown entries become comments."""
    files = {
        "cnc/hochlauf.lis": (
            "sda_mds[0] .\\\\listen\\\\A.lis ( of the channel\nachs_mds[0] axes/a.lis\n"
            "error_text_user_of_id texts.txt\nour_own 1\n"
        ),
        "cnc/listen/a.lis": (
            "# -- Axes --\ngruppe[0].achs_anzahl 1\ngruppe[0].achse[0].bezeichnung X\n"
            "gruppe[0].achse[0].log_achs_nr 1\nm_synch[5] PLC_INFO | MVS_SVS ( waits\n"
            'v_ch_memory 100\npath[0].dir "my programs"\n'
        ),
        "cnc/axes/a.lis": 'kopf.achs_nr 1\nkopf.log_achs_name "A & <B>"\n',
        "cnc/texts.txt": "7 Seven\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    target = tmp_path / "xml"
    assert main(["new", str(target), "--from", str(tmp_path), "--format", "xml"]) == 0
    assert "900979" in capsys.readouterr().err
    names = sorted(path.name.casefold() for path in target.iterdir())
    assert names == ["a.xml", "a_2.xml", "hochlauf.xml", "texts.txt"]
    before, after = load_machine(tmp_path / "cnc"), load_machine(target)
    assert without_files(before) == without_files(after)
    assert after.user_texts == {7: "Seven"}
    first, second = (
        path.read_text("utf-8") for path in sorted(target.glob("*.xml")) if path.stem[0] in "aA"
    )
    channel, axis = (first, second) if "<SDA_MDS>" in first else (second, first)
    assert "<!-- - - Axes - -  -->" in channel
    assert "m_synch[5]: waits -->" in channel
    assert "v_ch_memory: Memory for V.CH" in channel
    assert 'Value="A &amp; &lt;B&gt;"' in axis
    assert "<!-- our_own 1 -->" in (target / "hochlauf.xml").read_text("utf-8")


def test_the_source_of_the_interrupt_keeps_its_meaning(tmp_path: Path) -> None:
    """A comment says what the number means; in XML it has the number of the manual's table."""
    source = tmp_path / "ascii"
    assert main(["new", str(source)]) == 0
    rtconf = source / "rtconf.lis"
    lines = rtconf.read_text("utf-8").splitlines()
    lines = [
        "interrupt_source 1 ( 1: internal timer, 2: IRQ" if "interrupt_source" in line else line
        for line in lines
    ]
    rtconf.write_text("\n".join(lines) + "\n", encoding="utf-8")
    target = tmp_path / "xml"
    assert main(["new", str(target), "--from", str(source), "--format", "xml"]) == 0
    before, after = load_machine(source).rtconf, load_machine(target).rtconf
    assert before is not None and after is not None
    assert before.interrupt_source is after.interrupt_source


@pytest.mark.parametrize("list_format", ["ascii", "xml"])
@pytest.mark.parametrize("name", ["workshop", "centre"])
def test_a_full_folder_stays_what_it_is(name: str, list_format: str, tmp_path: Path) -> None:
    """Hundreds of entries of all kinds: the same machine, and no finding that was not there."""
    source = Path(__file__).parent.parent / "machines" / name
    target = tmp_path / "lists"
    assert main(["new", str(target), "--from", str(source), "--format", list_format]) == 0
    before, after = load_machine(source), load_machine(target)
    assert without_files(before) == without_files(after)
    new = Counter(one.id for one in after.diagnostics)
    assert new - Counter(one.id for one in before.diagnostics) == Counter()
