# SPDX-License-Identifier: MIT
"""Consequences of rtconf.lis: the schedule simulated, analysed and drawn.

In: the effective configuration (``lists.declared.rtconf``) and a load, the threads' execution
times. Out: response times, overflows, suspensions, Windows' share; pictures and traces. All times
inside are integer nanoseconds; same inputs give the same results.
"""

from nctakt.base import mode as mode
