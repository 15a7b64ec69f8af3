# SPDX-License-Identifier: MIT
"""The description of an FMU of nctakt, for FMI 2.0 and 3.0, the same bytes for the same content."""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from nctakt.base.dataclass import dataclass
from nctakt.base.version import __version__

#: Units of signals in units of the SI: exponents and factor.
_BASES: dict[str, dict[str, str]] = {
    "mm": {"m": "1", "factor": "0.001"},
    "mm/s": {"m": "1", "s": "-1", "factor": "0.001"},
    "mm/s²": {"m": "1", "s": "-2", "factor": "0.001"},
    "°": {"rad": "1", "factor": "0.017453292519943295"},
    "°/s": {"rad": "1", "s": "-1", "factor": "0.017453292519943295"},
    "1/min": {"rad": "1", "s": "-1", "factor": "0.10471975511965977"},
    "ms": {"s": "1", "factor": "0.001"},
    "us": {"s": "1", "factor": "1e-06"},
    "s": {"s": "1"},
    "%": {"factor": "0.01"},
}


@dataclass(frozen=True, slots=True)
class CellVariable:
    """A variable of the FMU; ``start``: of an input, ``None`` for an output."""

    name: str
    unit: str
    text: str
    is_whole: bool
    start: float | None = None


def model_description(
    version: int, identifier: str, token: str, tick_s: float, variables: Sequence[CellVariable]
) -> bytes:
    """Return the description; variables have their indices as references, counted from 1."""
    root = Element(
        "fmiModelDescription",
        {
            "fmiVersion": f"{version}.0",
            "modelName": identifier,
            "guid" if version == 2 else "instantiationToken": token,
            "generationTool": f"nctakt {__version__}",
        },
    )
    state = "FMUstate" if version == 2 else "FMUState"
    SubElement(
        root,
        "CoSimulation",
        {
            "modelIdentifier": identifier,
            "needsExecutionTool": "true",
            "canHandleVariableCommunicationStepSize": "true",
            f"canGetAndSet{state}": "true",
            f"canSerialize{state}": "true",
            **({} if version == 2 else {"fixedInternalStepSize": repr(tick_s)}),
        },
    )
    units = dict.fromkeys(one.unit for one in variables if one.unit)
    if units:
        definitions = SubElement(root, "UnitDefinitions")
        for unit in units:
            node = SubElement(definitions, "Unit", {"name": unit})
            if unit in _BASES:
                SubElement(node, "BaseUnit", _BASES[unit])
    if version == 2:
        categories = SubElement(root, "LogCategories")
        for name in ("logAll", "logStatusError"):
            SubElement(categories, "Category", {"name": name})
    SubElement(root, "DefaultExperiment", {"startTime": "0", "stepSize": repr(tick_s)})
    (_variables_of_2 if version == 2 else _variables_of_3)(root, variables)
    ElementTree.indent(root)
    text: bytes = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
    return text


def _common(index: int, one: CellVariable) -> dict[str, str]:
    return {
        "name": one.name,
        "valueReference": str(index),
        **({"description": one.text} if one.text else {}),
        "causality": "output" if one.start is None else "input",
        "variability": "discrete" if one.is_whole else "continuous",
    }


def _typed(one: CellVariable) -> dict[str, str]:
    return {
        **({"unit": one.unit} if one.unit else {}),
        **({} if one.start is None else {"start": repr(float(one.start))}),
    }


def _variables_of_2(root: Element, variables: Sequence[CellVariable]) -> None:
    listed = SubElement(root, "ModelVariables")
    for index, one in enumerate(variables, 1):
        SubElement(SubElement(listed, "ScalarVariable", _common(index, one)), "Real", _typed(one))
    structure = SubElement(root, "ModelStructure")
    outputs = [str(index) for index, one in enumerate(variables, 1) if one.start is None]
    for name in ("Outputs", "InitialUnknowns") if outputs else ():
        node = SubElement(structure, name)
        for number in outputs:
            SubElement(node, "Unknown", {"index": number})


def _variables_of_3(root: Element, variables: Sequence[CellVariable]) -> None:
    listed = SubElement(root, "ModelVariables")
    time = {"name": "time", "valueReference": "0", "causality": "independent"}
    SubElement(listed, "Float64", {**time, "variability": "continuous"})
    for index, one in enumerate(variables, 1):
        SubElement(listed, "Float64", {**_common(index, one), **_typed(one)})
    structure = SubElement(root, "ModelStructure")
    for name in ("Output", "InitialUnknown"):
        for index, one in enumerate(variables, 1):
            if one.start is None:
                SubElement(structure, name, {"valueReference": str(index)})
