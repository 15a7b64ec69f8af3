# SPDX-License-Identifier: MIT
"""How the direction of the tool is programmed (``#ORI MODE``, P-CHAN-00177)."""

from __future__ import annotations

#: Modes: angles of the rotary axes; a vector from the tip to the clamp.
ANGLE, VECTOR = "ANGLE", "VECTOR_2DOF"

#: The words of the vector's components.
VECTOR_WORDS = ("A", "B", "C")
