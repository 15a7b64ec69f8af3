# SPDX-License-Identifier: MIT
"""rtconf.lis written anew: what counts is there, and nothing else has changed."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.schedule_examples import EXAMPLE_1, EXAMPLE_2, with_line
from support.scheduling_entries import KEYS, VALUES

from nctakt.lists.declared.rtconf import RtconfConfiguration
from nctakt.lists.machine.schedules.scheduling import read_rtconf
from nctakt.lists.machine.schedules.scheduling_profile import PROFILES, RtconfOptions
from nctakt.messages import Collector
from nctakt.schedule.rewrite import RewrittenList, rewrite


def fixed(
    data: bytes, options: RtconfOptions | None = None
) -> tuple[RewrittenList, RtconfConfiguration, list[int]]:
    """The list anew, what it meant, and the numbers of what was found."""
    collector = Collector()
    options = options or RtconfOptions()
    values, configuration = read_rtconf("rtconf.lis", data, collector, options)
    required = {one.entry for one in collector.diagnostics}
    found = [one.id for one in collector.diagnostics]
    convention = options.convention
    anew = rewrite("rtconf.lis", data, values, configuration, required, convention)
    return anew, configuration, found


@pytest.mark.parametrize("text", [EXAMPLE_1, EXAMPLE_2])
def test_a_list_without_faults_stays(text: str) -> None:
    """Not a byte is changed."""
    anew, _, _ = fixed(text.encode())
    assert (anew.data, anew.is_changed) == (text.encode(), False)


BEFORE = """\
# Our list
cycle_time 1750 # of the drives
time_slice\t500\t( the timer
windows_time 999
windows_time 499
thread[0].name   GEO (the first
thread[0].context 1
thread[0].priority 500 # HIGHEST
thread[0].function[0].name task_int
thread[0].function[0].trace_bit 9
thread[0].function[1].trace_bit 1
colour red

external_thread[0].semaphore_name plc one
external_object_name unused
"""
AFTER = """\
# Our list
interrupt_source 2 # 1: hardware interrupt, 2: timer, 3: semaphore
cycle_time 2000 # of the drives
time_slice\t500\t( the timer
# windows_time 999
windows_time 500
thread[0].name   GEO (the first
thread[0].context_info 1
thread[0].priority 0 # HIGHEST
thread[0].function[0].name task_int
thread[0].function[0].trace_bit 0
# thread[0].function[1].trace_bit 1
thread[0].cycle 2000
thread[0].error_on_overflow 0
# colour red

external_thread[0].semaphore_name plc one
external_thread[0].cycle 2000
# external_object_name unused
End
"""


def test_what_becomes_of_each_line() -> None:
    """Corrected, made a comment, added; comments and blanks stay."""
    anew, _, _ = fixed(BEFORE.encode())
    assert anew.data.decode() == AFTER
    assert (anew.corrected, anew.commented, anew.added) == (5, 4, 5)


@pytest.mark.parametrize("end", ["\r\n", "\r", "\n"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "cp1252", "utf-16"])
def test_line_ends_and_encoding_stay(end: str, encoding: str) -> None:
    """As they are in the list; added lines end as its first one does."""
    text = BEFORE.replace("Our", "Übliche").replace("\n", end)
    anew, _, _ = fixed(text.encode(encoding))
    expected = AFTER.replace("Our", "Übliche").replace("\n", end).encode(encoding)
    assert anew.data == expected


def test_text_after_the_end_stays() -> None:
    """Text after End or the character that ends a file is nobody's."""
    for tail in ("End\nnotes\n", "End\n\x1acycle_time x"):
        text = BEFORE + tail
        assert fixed(text.encode())[0].data.decode() == AFTER.removesuffix("End\n") + tail


def test_a_last_line_without_an_end() -> None:
    """It gets one before the line that is added after it."""
    anew, _, _ = fixed(BEFORE.rstrip("\n").encode())
    assert anew.data.decode() == AFTER


#: A value that is no number, out of range, twice there, missing, rounded, replaced.
CORRECTIONS = {2022, 900019, 900023, 900030, 900031, 900035, 900036, 900044, 1000153}


@pytest.mark.slow
@given(
    st.sampled_from([EXAMPLE_1, EXAMPLE_2, BEFORE, "", "End\n"]),
    st.lists(st.tuples(st.sampled_from(KEYS), st.sampled_from(VALUES)), max_size=6),
    st.sampled_from(sorted(PROFILES)),
    st.sampled_from(["auto", "table", "field"]),
)
@settings(max_examples=300, deadline=None)
def test_the_list_anew_means_the_same(
    text: str, changes: list[tuple[str, str]], name: str, convention: str
) -> None:
    """It is read as the list before, needs no correction, and stays as it is the next time."""
    assert convention in ("auto", "table", "field")
    options = RtconfOptions(PROFILES[name], convention)
    data = with_line(text, *(f"{key} {value}" for key, value in changes)).encode()
    anew, meant, _ = fixed(data, options)
    again, means, found = fixed(anew.data, options)
    assert means == meant
    assert not again.is_changed
    # A time that is too long for its parameter is an error that no value corrects.
    assert 900052 in found or not CORRECTIONS & set(found)
