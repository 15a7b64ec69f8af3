# SPDX-License-Identifier: MIT
"""Times of the functions of a schedule that all tests know."""

from __future__ import annotations

NOMINAL = {
    "task_int": 300,
    "task_rnd": 600,
    "task_mmi_driver": 200,
    "task_com": 200,
    "external_sps": 150,
}
