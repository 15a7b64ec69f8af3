# SPDX-License-Identifier: MIT
# C types of command_bounds.py: the numbers of a row are Python's here, which may be anything.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport bounds
from nctakt.kernel.tick.command_execution cimport CommandExecutor

@cython.locals(axes=Py_ssize_t, cell_count=Py_ssize_t, count=Py_ssize_t)
cpdef check_command(CommandExecutor executor, list command)
cpdef check_text(list command, Py_ssize_t size)
