# SPDX-License-Identifier: MIT
"""Recorded signals and events: sinks that stream them, the trace as an object, files read back.

In: the rows that ``kernel/base/record.py`` recorded in the ticks. Out: ``Trace`` in memory, CSV or
JSONL files.
"""

from nctakt.trace.chunks import EventChunk
from nctakt.trace.events import Event, EventDecoder, EventNames
from nctakt.trace.reading import read_trace
from nctakt.trace.recorded import MemorySink, Trace
from nctakt.trace.sinks import CsvSink, JsonlSink, Signal, Sink, TraceHeader, file_sink

__all__ = [
    "CsvSink",
    "Event",
    "EventChunk",
    "EventDecoder",
    "EventNames",
    "JsonlSink",
    "MemorySink",
    "Signal",
    "Sink",
    "Trace",
    "TraceHeader",
    "file_sink",
    "read_trace",
]
