# SPDX-License-Identifier: MIT
"""Recorded signals and events: sinks that stream them, the trace as an object, files read back.

In: the rows that ``kernel/base/record.py`` recorded in the ticks. Out: ``Trace`` in memory, CSV or
JSONL files.
"""
