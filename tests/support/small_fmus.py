# SPDX-License-Identifier: MIT
"""FMUs for tests, built with the C compiler from ``small_fmu.c``."""

from __future__ import annotations

import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest

SOURCE = Path(__file__).with_name("small_fmu.c")
_DEFINED = re.compile(r"(?:API\(|\bfmi[23])(\w+)\)?\(")

#: Variables: name, reference, causality, type of FMI 3.0, further attributes.
VARIABLES = (
    ("u", 1, "input", "Float64", 'start="0" unit="m"'),
    ("y", 2, "output", "Float64", 'unit="m"'),
    ("gain", 3, "parameter", "Float64", 'start="1" variability="fixed"'),
    ("n", 4, "output", "Int32", 'variability="discrete"'),
    ("fault", 5, "parameter", "Int32", 'start="0" variability="fixed"'),
    ("above.ten", 6, "output", "Boolean", 'variability="discrete"'),
)
#: A variable that FMI 2.0 has no type for, and one that the library does not know.
SMALL = ("small", 7, "input", "UInt8", 'start="0" variability="discrete"')
ABSENT = ("absent", 99, "output", "Float64", "")

_TYPES_OF_2 = {"Float64": "Real", "Int32": "Integer", "Boolean": "Boolean"}


def description(
    version: int, *further: tuple[str, int, str, str, str], interface: str = 'modelIdentifier="m"'
) -> str:
    """Return the description of the FMU."""
    variables = (*VARIABLES, *further)
    if version == 2:
        rows = [_scalar_variable(*one) for one in variables]
        outputs = [i for i, one in enumerate(variables, 1) if one[2] == "output"]
        structure = "".join(f'<Unknown index="{index}"/>' for index in outputs)
        return (
            '<fmiModelDescription fmiVersion="2.0" modelName="m" guid="{1}">'
            f'<CoSimulation {interface}/><UnitDefinitions><Unit name="m"/></UnitDefinitions>'
            f"<ModelVariables>{''.join(rows)}</ModelVariables><ModelStructure><Outputs>{structure}"
            f"</Outputs><InitialUnknowns>{structure}</InitialUnknowns></ModelStructure>"
            "</fmiModelDescription>"
        )
    rows = [
        f'<{kind} name="{name}" valueReference="{reference}" causality="{causality}" {rest}/>'
        for name, reference, causality, kind, rest in variables
    ]
    time = (
        '<Float64 name="time" valueReference="0" causality="independent" variability="continuous"/>'
    )
    parts = [
        f'<{kind} valueReference="{one[1]}"/>'
        for kind in ("Output", "InitialUnknown")
        for one in variables
        if one[2] == "output"
    ]
    return (
        '<fmiModelDescription fmiVersion="3.0" modelName="m" instantiationToken="{1}">'
        f'<CoSimulation {interface}/><UnitDefinitions><Unit name="m"/></UnitDefinitions>'
        f"<ModelVariables>{time}{''.join(rows)}</ModelVariables>"
        f"<ModelStructure>{''.join(parts)}</ModelStructure></fmiModelDescription>"
    )


def _scalar_variable(name: str, reference: int, causality: str, kind: str, rest: str) -> str:
    """Return a variable as FMI 2.0 writes it."""
    words = rest.split()
    outside = [word for word in words if word.startswith("variability")]
    inside = [word for word in words if word not in outside]
    return (
        f'<ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}" '
        f"{' '.join(outside)}><{_TYPES_OF_2[kind]} {' '.join(inside)}/>"
        "</ScalarVariable>"
    )


def write_fmu(path: Path, text: str, library: Path | None, **entries: str) -> Path:
    """Write an FMU; ``entries``: further names in the archive, with their text."""
    fmpy = pytest.importorskip("fmpy", reason="FMUs need FMPy (extra fmi)")
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("modelDescription.xml", text)
        for platform in (fmpy.platform, fmpy.platform_tuple) if library else ():
            assert library is not None
            archive.write(library, f"binaries/{platform}/m{fmpy.sharedLibraryExtension}")
        for name, content in entries.items():
            archive.writestr(name, content)
    return path


def build_library(version: int, folder: Path) -> Path:
    """Return the compiled library; functions that it does not need fail."""
    pytest.importorskip("fmpy", reason="FMUs need FMPy (extra fmi)")
    from fmpy.fmi2 import FMU2Slave  # noqa: PLC0415 - an extra
    from fmpy.fmi3 import FMU3Slave  # noqa: PLC0415

    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("there is no C compiler")
    kind = FMU2Slave if version == 2 else FMU3Slave
    prefix = f"fmi{version}"
    text = SOURCE.read_text("utf-8")
    defined = {prefix + name for name in _DEFINED.findall(text)}
    for type_ in re.findall(r"^ACCESS\((\w+)", text, re.MULTILINE):
        defined |= {f"{prefix}Get{type_}", f"{prefix}Set{type_}"}
    if version == 2:
        defined -= {f"{prefix}{way}{kind}" for way in ("Get", "Set") for kind in ("Float64",)}
    stubs = [
        f"int {name}(void) {{ return 3; }}"
        for name in dir(kind)
        if name.startswith(prefix) and name not in defined
    ]
    source, library = folder / "m.c", folder / f"m{version}.so"
    source.write_text("\n".join([text, *stubs]), "utf-8")
    words = ["-DFMI_2"] if version == 2 else []
    subprocess.run(
        [compiler, "-shared", "-fPIC", "-O1", "-w", *words, "-o", str(library), str(source)],
        check=True,
    )
    return library
