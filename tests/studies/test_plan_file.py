# SPDX-License-Identifier: MIT
"""Plans in files: what is wrong in them is reported with its line, all at once, before any run."""

from __future__ import annotations

from pathlib import Path

import pytest

from nctakt.base.diagnostics import Severity
from nctakt.base.failure import Failure
from nctakt.studies.plans.plan_file import read_plan
from nctakt.studies.study import Study


def plan(folder: Path, text: str) -> Path:
    """A plan in a folder with a program."""
    (folder / "part.nc").write_text("G01 X10 F6000\nM30\n")
    path = folder / "plan.toml"
    path.write_text(text)
    return path


def failure_of(path: Path) -> list[tuple[int, int]]:
    """Number and line of each mistake of a plan."""
    with pytest.raises(Failure) as raised:
        Study(path).run()
    errors = [one for one in raised.value.diagnostics if one.severity is Severity.ERROR]
    return [(one.id, 0 if one.span is None else one.span.line) for one in errors]


def test_every_mistake_is_reported_with_its_line(tmp_path: Path) -> None:
    """Unknown words, wrong values, measures and expectations."""
    path = plan(
        tmp_path,
        'program = "part.nc"\nmetod = "grid"\nexpect = ["X nowhere"]\n'
        '[measure]\na = "time of nothing"\n'
        '[[vary]]\nvariable = "V.E.VALUE"\nvalues = 5\n'
        '[[vary]]\nvariabel = "V.E.VALUE"\n',
    )
    assert failure_of(path) == [
        (901301, 2),
        (901307, 3),
        (901306, 5),
        (901302, 8),
        (901303, 9),
        (901301, 10),
    ]


def test_what_is_not_toml_is_reported_with_its_place(tmp_path: Path) -> None:
    """The reader of TOML names line and column."""
    assert failure_of(plan(tmp_path, "program = \n")) == [(901300, 1)]


@pytest.mark.parametrize("values", ["values = []", "from = 5\nto = 1\nstep = 1"])
def test_an_empty_grid_is_reported(tmp_path: Path, values: str) -> None:
    """A dimension without a value leaves no run."""
    text = f'program = "part.nc"\n[[vary]]\nvariable = "V.E.VALUE"\n{values}\n'
    assert [number for number, _ in failure_of(plan(tmp_path, text))] == [901304]


VALUE = '[[vary]]\nvariable = "V.E.VALUE"\nvalues = [1]\n'


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (f"{VALUE}[[find]]\nboundary = 'V.E.VALUE'\nbudget = 0\n", (901302, 7)),
        (f"{VALUE}[[find]]\nminimize = [1]\n", (901302, 6)),
        (f"{VALUE}[[find]]\nbudget = 5\n", (901303, 5)),
        (f"count = 0\n{VALUE}", (901302, 2)),
        (f"{VALUE}[measure]\nstate = 'ticks'\n", (901390, 6)),
        (f"{VALUE}[measure]\na = 'count of error 1.5'\n", (901306, 6)),
        (f"{VALUE}from = 1\nto = 2\n", (901302, 4)),
        (f"{VALUE}noise = 'V.E.VALUE'\n", (901302, 5)),
        ('[[vary]]\nvariable = ""\nvalues = [1]\n', (901302, 3)),
        ('[[vary]]\nvariable = "V.E.VALU"\nvalues = [1]\n', (900541, 3)),
        ('[[vary]]\nvariable = "HLI.NOSUCH"\nvalues = [1]\n', (900540, 3)),
        ('[[vary]]\nacknowledge = "M"\nvalues = ["never"]\n', (901302, 3)),
        ('[[vary]]\nacknowledge = "M8"\nvalues = ["sometimes"]\n', (901302, 4)),
        ('[[vary]]\nparameter = "P-AXIS-00008 of Q"\nvalues = [1]\n', (901312, 3)),
        ('[[vary]]\nprogram_variable = "V.P.NO"\nvalues = [1]\n', (901313, 3)),
        ("[set]\n'V.E.VALU' = 1\n", (900541, 3)),
        ('at = [["1 ms", "V.E.VALU = 1"]]\n', (900541, 2)),
        ("expect = ['max NOSUCH < 5']\n", (900544, 2)),
        ("[measure]\na = 'max NOSUCH'\n", (900544, 3)),
        ("[measure]\n\"a\\nb\" = 'ticks'\n", (901302, 2)),
        ('os = "rtx"\n', (901303, 0)),
        (
            f'method = "list"\n{VALUE}[[vary]]\nnoise = "V.E.VALUE"\nvalues = [1, 2]\nfor = "1 s"\n'
            'name = "b"\n',
            (901302, 8),
        ),
        (
            '[measure]\na = "ticks"\n[[find]]\nminimize = "a"\n'
            '[[vary]]\nvariable = "V.E.VALUE"\nvalues = []\n',
            (901304, 6),
        ),
        ('[[vary]]\nvariable = "V.E.VALUE"\nfrom = nan\nto = 2\n', (901302, 4)),
        ('[[vary]]\nvariable = "V.E.VALUE"\nvalues = [inf]\n', (901302, 4)),
        ('[[vary]]\nvariable = "V.E.VALUE"\nfrom = 0\nto = 2\nstep = "x"\n', (901302, 6)),
        ('[[vary]]\nvariable = "V.E.VALUE"\nfrom = 0\nto = 2\nstep = -1\n', (901302, 6)),
        ('[[vary]]\nplc_returns = "yes"\nvalues = ["1 s"]\n', (901303, 2)),
        ('[[vary]]\nseries = "a"\nvalues = ["nowhere.csv"]\n', (901302, 4)),
        ('method = "latin"\ncount = 100000000\n', (901302, 3)),
        ('plc = "nowhere.py"\n', (901302, 2)),
    ],
)
def test_values_that_no_entry_takes(tmp_path: Path, text: str, found: tuple[int, int]) -> None:
    """Each is reported in its line, before anything runs."""
    assert failure_of(plan(tmp_path, f'program = "part.nc"\n{text}')) == [found]


@pytest.mark.parametrize(
    ("name", "reason"),
    [("missing", "AttributeError"), ("number", "not a function"), ("f", "ModuleNotFoundError")],
)
def test_a_python_measure_that_is_not_there(tmp_path: Path, name: str, reason: str) -> None:
    """The file is loaded before any run."""
    (tmp_path / "own.py").write_text("number = 5\n" if name != "f" else "import nowhere_at_all\n")
    text = f'program = "part.nc"\n[measure]\na = "python own.py:{name}"\n'
    with pytest.raises(Failure) as raised:
        Study(plan(tmp_path, text)).run()
    (found,) = raised.value.diagnostics
    assert found.id == 901306
    assert reason in found.text()


def test_what_a_python_measure_returns(tmp_path: Path) -> None:
    """What is neither a finite number nor a text is no value, and ends no study."""
    results = {
        "nan": "float('nan')",
        "lists": "[1]",
        "complex": "1j",
        "none": "None",
        "big": "1e999",
    }
    own = [f"def {name}(run):\n    return {value}\n" for name, value in results.items()]
    (tmp_path / "own.py").write_text("".join([*own, "def ok(run):\n    return True\n"]))
    lines = "".join(f'{name} = "python own.py:{name}"\n' for name in [*results, "ok"])
    row = Study(plan(tmp_path, f'program = "part.nc"\n[measure]\n{lines}')).run().rows[0]
    assert [row[name] for name in results] == [None] * len(results)
    assert row["ok"] == 1


def test_parameters_of_whole_numbers_are_rounded(tmp_path: Path) -> None:
    """Between from and to without a step a list gets no fraction that it refuses."""
    text = (
        'program = "part.nc"\nmethod = "random"\ncount = 9\n'
        '[[vary]]\nparameter = "P-AXIS-00012 of X"\nfrom = 20\nto = 40\n'
    )
    values = Study(plan(tmp_path, text)).run().column("P-AXIS-00012 of X")
    assert all(isinstance(value, int) and 20 <= value <= 40 for value in values)


def test_unknown_names_are_reported_before_any_run(tmp_path: Path) -> None:
    """A variable that the machine does not have, with the nearest one."""
    text = 'program = "part.nc"\n[[vary]]\nvariable = "V.E.VALU"\nvalues = [1]\n'
    with pytest.raises(Failure) as raised:
        Study(plan(tmp_path, text)).run()
    assert raised.value.diagnostics[0].id == 900541
    assert "V.E.VALUE" in raised.value.diagnostics[0].remedy()


def test_points_of_each_method(tmp_path: Path) -> None:
    """A grid has each with each, a list one with one, chance as many as are asked for."""
    head = 'program = "part.nc"\n'
    tail = (
        '[[vary]]\nvariable = "V.E.VALUE"\nfrom = 0\nto = 1\nstep = 0.5\n'
        '[[vary]]\nvariable = "V.E.VALUE1"\nvalues = [7, 8, 9]\n'
    )
    grid = read_plan(plan(tmp_path, head + tail))
    assert [grid.point(i) for i in (0, 1, 3, 8)] == [(0, 7), (0, 8), (0.5, 7), (1, 9)]
    pairs = read_plan(plan(tmp_path, f'{head}method = "list"\n{tail}'))
    assert (pairs.size, pairs.point(1)) == (3, (0.5, 8))
    by_chance = read_plan(
        plan(tmp_path, f'{head}method = "random"\ncount = 1000\nseed = 3\n{tail}')
    )
    points = [by_chance.point(i) for i in range(1000)]
    assert points == [by_chance.point(i) for i in range(1000)]
    assert 300 < sum(point == (0, 7) or point[0] == 1 for point in points) < 600


@pytest.mark.parametrize("method", ["latin", "sobol"])
def test_designs_fill_the_space(tmp_path: Path, method: str) -> None:
    """Latin hypercube and Sobol points lie spread over each dimension."""
    pytest.importorskip("scipy")
    text = (
        f'program = "part.nc"\nmethod = "{method}"\ncount = 64\nseed = 1\n'
        '[[vary]]\nvariable = "V.E.VALUE"\nfrom = 0\nto = 64\n'
    )
    design = read_plan(plan(tmp_path, text))
    values = sorted(float(design.point(i)[0]) for i in range(64))
    assert [int(value) for value in values] == list(range(64))
