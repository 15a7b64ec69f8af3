# SPDX-License-Identifier: MIT
"""An FMU's description of itself: version, identity, variables with types and units."""

from __future__ import annotations

import io
import math
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nctakt.base.dataclass import dataclass, field
from nctakt.base.diagnostics import Text
from nctakt.files.access import FileAccess
from nctakt.fmu.archive import not_readable, platforms_of
from nctakt.fmu.archive import read_description as read_text
from nctakt.fmu.failures import FmuError, fmpy
from nctakt.messages import diagnostic
from nctakt.messages.plcs.fmu import (
    FMU_KIND_NOT_POSSIBLE,
    FMU_REFERENCE_SHARED,
    FMU_WITHOUT_BINARY,
)

#: Types of variables -> the part of the functions' names that get and set them, by version.
_ACCESS = {
    2: {
        "Real": "Real", "Integer": "Integer", "Enumeration": "Integer", "Boolean": "Boolean",
        "String": "String",
    },
    3: {
        **{name: name for name in (
            "Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64",
            "UInt64", "Boolean", "String",
        )},
        "Enumeration": "Int64",
    },
}  # fmt: skip
_REALS = ("Real", "Float32", "Float64")
#: Bits of whole numbers, and whether they have a sign.
_WHOLES = {
    "Integer": (32, True), "Int8": (8, True), "UInt8": (8, False), "Int16": (16, True),
    "UInt16": (16, False), "Int32": (32, True), "UInt32": (32, False), "Int64": (64, True),
    "UInt64": (64, False),
}  # fmt: skip

#: Causalities of variables that a run sets, and why two variables cannot share a reference.
_SETTABLE = ("input", "parameter")
_BOTH_SET = Text(
    "of aliases only one can be set, and both are inputs or parameters",
    "von Aliasen lässt sich nur einer setzen, und beide sind Eingänge oder Parameter",
)
_TWO_UNITS = Text("aliases have one unit", "Aliase haben eine gemeinsame Einheit")


@dataclass(frozen=True, slots=True)
class FmuVariable:
    """A variable; ``access``: the functions that get and set it, empty for arrays and unused types.

    ``low``, ``high``: the limits of its value.
    """

    name: str
    reference: int
    type: str
    access: str
    causality: str
    is_fixed: bool = False
    unit: str = ""
    low: float = -math.inf
    high: float = math.inf

    @property
    def is_real(self) -> bool:
        """Whether it is a floating-point number."""
        return self.type in _REALS

    def converted(self, value: float | bool | str) -> float | bool | str:
        """Return a value of nctakt as this variable takes it; raises ``ValueError``."""
        if isinstance(value, str) or self.access == "String":
            if self.access != "String" or not isinstance(value, str):
                raise ValueError(value)
            return value
        if self.access == "Boolean":
            return bool(value)
        if self.is_real:
            return float(value)
        return self._whole(value)

    def begun_with(self, value: float | bool | str) -> float | bool | str:
        """Return a start value; raises ``ValueError`` for one of another type or out of limits."""
        is_truth = isinstance(value, bool) or (self.access == "Boolean" and value in (0, 1))
        if is_truth != (self.access == "Boolean"):
            raise ValueError(value)
        found = self.converted(value)
        if isinstance(value, str) or is_truth:
            return found
        if found != value or not self.low <= float(found) <= self.high:
            raise ValueError(value)
        return found

    def limits(self) -> str:
        """Return type and limits as text."""
        if self.low == -math.inf and self.high == math.inf:
            return self.type
        low, high = ("" if math.isinf(one) else f"{one:g}" for one in (self.low, self.high))
        return f"{self.type}, {low} … {high}".replace(",  …", ", …").rstrip()

    def _whole(self, value: float | bool) -> int:
        """Return the whole number next to a value; raises ``ValueError`` beyond the type's."""
        bits, is_signed = _WHOLES[self.access]
        low = -(1 << (bits - 1)) if is_signed else 0
        number = round(float(value)) if math.isfinite(value) else low - 1
        if not low <= number < low + (1 << bits):
            raise ValueError(value)
        return number


@dataclass(frozen=True, slots=True)
class FmuDescription:
    """The description of an FMU; ``step_us``: its fixed internal step, 0 without one."""

    file: Path
    version: int
    identifier: str
    token: str
    variables: Mapping[str, FmuVariable] = field(repr=False)
    step_us: float = 0.0

    def of(self, causality: str) -> list[FmuVariable]:
        """Return the variables of a causality that can be read and written."""
        return [one for one in self.variables.values() if one.causality == causality and one.access]


def read_fmu(file: Path, access: FileAccess) -> FmuDescription:
    """Return the description of an FMU.

    Raises ``FmuError`` for a file that cannot be read (902601), leaves its folder (902602), cannot
    run here (902603, 902604), and without FMPy (902600).
    """
    library = fmpy()
    text = read_text(file, access)
    try:
        found = library.read_model_description(_Described(text))
    except KeyError as error:
        raise not_readable(file, _no_variable(error.args[0])) from error
    except Exception as error:  # it has no exception class for faults
        raise not_readable(file, " ".join(str(error).split())) from error
    for one in found.modelVariables:
        _check_start(file, one)
    _check_references(file, found)
    version = int(found.fmiVersion.partition(".")[0])
    if version not in _ACCESS or found.coSimulation is None:
        kinds = [
            name
            for name, one in (
                ("model exchange", found.modelExchange),
                ("co-simulation", found.coSimulation),
                ("scheduled execution", getattr(found, "scheduledExecution", None)),
            )
            if one is not None
        ]
        kind = f"FMI {found.fmiVersion} {', '.join(kinds)}"
        raise FmuError(diagnostic(FMU_KIND_NOT_POSSIBLE, file=str(file), kind=kind))
    platform = library.platform if version == 2 else library.platform_tuple
    platforms = platforms_of(file)
    if platform not in platforms:
        raise FmuError(
            diagnostic(
                FMU_WITHOUT_BINARY,
                file=str(file),
                platform=platform,
                platforms=", ".join(platforms) or "-",
            )
        )
    fixed = found.coSimulation.fixedInternalStepSize
    return FmuDescription(
        file,
        version,
        found.coSimulation.modelIdentifier,
        found.guid,
        {one.name: _variable(one, version) for one in found.modelVariables},
        0.0 if fixed is None else float(fixed) * 1e6,
    )


def _no_variable(reference: object) -> Text:
    return Text(
        f"its structure names the value reference {reference}, which no variable has",
        f"ihre Struktur nennt die Wertreferenz {reference}, die keine Variable hat",
    )


def _check_start(file: Path, found: Any) -> None:
    """Raise ``FmuError`` (902601) for a start value beyond the limits of its variable."""
    try:
        start = float(found.start)
        low, high = float(found.min or -math.inf), float(found.max or math.inf)
    except (TypeError, ValueError):  # none, an array, a truth, a text
        return
    if not low <= start <= high:
        reason = Text(
            f"{found.name} begins with {start:g}, which is not within {low:g} … {high:g}",
            f"{found.name} beginnt mit {start:g}, was nicht in {low:g} … {high:g} liegt",
        )
        raise not_readable(file, reason)


def _check_references(file: Path, found: Any) -> None:
    """Raise ``FmuError`` (902950) for variables of FMI 2.0 that wrongly share a value reference.

    Variables of a type may, if at most one of them can be set, and all are in one unit. In FMI 3.0
    each has its own, which FMPy checks.
    """
    first: dict[tuple[str, int], Any] = {}
    for one in found.modelVariables if found.fmiVersion.startswith("2") else ():
        key = _ACCESS[2].get(str(one.type), ""), one.valueReference
        before = first.setdefault(key, one)
        reason = None if before is one else _shared(before, one)
        if reason is not None:
            raise FmuError(
                diagnostic(
                    FMU_REFERENCE_SHARED,
                    file=str(file),
                    name=before.name,
                    other=one.name,
                    reference=one.valueReference,
                    reason=reason,
                )
            )
        if one.causality in _SETTABLE:
            first[key] = one


def _shared(before: Any, one: Any) -> Text | None:
    """Return why two variables of FMI 2.0 cannot be aliases, ``None`` if they can."""
    if before.causality in _SETTABLE and one.causality in _SETTABLE:
        return _BOTH_SET
    return None if before.unit == one.unit else _TWO_UNITS


class _Described(io.BytesIO):
    """A zip archive in memory that holds nothing but the description, as FMPy takes it."""

    def __init__(self, text: bytes) -> None:

        super().__init__()
        with zipfile.ZipFile(self, "w") as packed:
            packed.writestr("modelDescription.xml", text)
        self.seek(0)


def _variable(found: Any, version: int) -> FmuVariable:
    """Return a variable of FMPy's description."""
    is_array = bool(getattr(found, "dimensions", None))
    declared = found.declaredType
    unit = found.unit or (declared.unit if declared is not None else None) or ""
    low, high = (
        _limit(getattr(found, name) or getattr(declared, name, None), otherwise)
        for name, otherwise in (("min", -math.inf), ("max", math.inf))
    )
    causality = str(found.causality or "local")
    return FmuVariable(
        found.name,
        int(found.valueReference),
        str(found.type),
        "" if is_array else _ACCESS[version].get(str(found.type), ""),
        causality,
        str(found.variability) in ("fixed", "tunable") or "arameter" in causality,
        unit,
        low,
        high,
    )


def _limit(text: str | None, otherwise: float) -> float:
    """Return a limit of a value; an entry that is not a number sets no limit."""
    try:
        return otherwise if text is None else float(text)
    except ValueError:
        return otherwise
