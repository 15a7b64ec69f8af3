# SPDX-License-Identifier: MIT
"""The command that installs the libraries of an extra, as remedies name it.

It names the libraries and not nctakt, so that it works in any folder and rebuilds nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

#: The runner of a project's tests.
PYTEST = "pytest>=9"

#: The requirements of each extra that a message may ask for, as in pyproject.toml.
_REQUIREMENTS: Mapping[str, Sequence[str]] = {
    "cluster": ("distributed>=2024.8",),
    "data": ("fsspec>=2024.2", "pandas>=2.2", "polars>=1", "pyarrow>=16"),
    "editor": ("pygls>=2",),
    "fmi": ("fmpy>=0.3.20", "pythonfmu>=0.7,<0.8", "pythonfmu3>=0.3.4,<0.4"),
    "live": ("lsprotocol>=2025", "markdown2>=2.4", "nicegui>=3.18"),
    "measure": ("asammdf>=8", "pylibfst>=0.2.1"),
    "mqtt": ("aiomqtt>=2,<3", "paho-mqtt>=2,<2.3"),
    "opcua": ("asyncua>=2.1,<2.2", "cryptography>=42"),
    "plot": ("matplotlib>=3.8", "pyvcd>=0.4"),
    "pytest": (PYTEST,),
    "studies": ("optuna>=5", "SALib>=1.5", "scipy>=1.13"),
    "watch": ("watchfiles>=0.21",),
}


def install_command(extra: str) -> str:
    """Return the command that installs the libraries of an extra."""
    return " ".join(("pip install", *(f'"{one}"' for one in _REQUIREMENTS[extra])))
