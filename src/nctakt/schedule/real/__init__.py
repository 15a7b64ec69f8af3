# SPDX-License-Identifier: MIT
"""A schedule run for real on Linux: one process per thread of the list.

In: a model of ``nctakt.schedule``. Out: the results, in the same form as those of a simulation. The
processes are written in C (``processes``, compiled at installation if there is a compiler);
everything before and after a run is Python.
"""
