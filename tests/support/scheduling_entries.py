# SPDX-License-Identifier: MIT
"""Entries of scheduling lists and values that they may have."""

from __future__ import annotations

KEYS = (
    "interrupt_source",
    "cycle_time",
    "time_slice",
    "windows_time",
    "schedule",
    "thread[0].cycle",
    "thread[1].cycle",
    "thread[2].cycle",
    "thread[1].priority",
    "thread[2].cpu",
    "thread[0].cpu",
    "thread[5].name",
    "thread[0].function[0].name",
    "thread[1].function[0].calls_per_cycle",
    "thread[1].function[0].trace_bit",
    "external_thread[1].semaphore_name",
    "external_thread[0].cycle",
)


VALUES = ("0", "1", "2", "3", "7", "99", "500", "501", "2000", "65534", "4294967294", "x", "-1", "")
