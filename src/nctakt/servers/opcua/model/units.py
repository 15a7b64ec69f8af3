# SPDX-License-Identifier: MIT
"""Engineering units: their codes in UN/CEFACT, as OPC UA numbers them, and their signs."""

from __future__ import annotations

from asyncua import ua

_NAMESPACE = "http://www.opcfoundation.org/UA/units/un/cefact"

#: Sign -> code and name.
_UNITS = {
    "mm": ("MMT", "millimetre"),
    "°": ("DD", "degree [unit of angle]"),
    "%": ("P1", "percent"),
    "mm/min": ("H81", "millimetre per minute"),
    "mm/s": ("C16", "millimetre per second"),
    "1/min": ("RPM", "revolutions per minute"),
    "s": ("SEC", "second [unit of time]"),
    "ms": ("C26", "millisecond"),
    "µs": ("B98", "microsecond"),
    "N·m": ("NU", "newton metre"),
    "kW": ("KWT", "kilowatt"),
}


def unit(sign: str) -> ua.EUInformation:
    """Return a unit by its sign."""
    code, name = _UNITS[sign]
    return ua.EUInformation(
        NamespaceUri=_NAMESPACE,
        UnitId=int.from_bytes(code.encode(), "big"),
        DisplayName=ua.LocalizedText(sign, ""),
        Description=ua.LocalizedText(name, "en"),
    )


def is_unit(sign: str) -> bool:
    """Return whether there is a unit of this sign."""
    return sign in _UNITS
