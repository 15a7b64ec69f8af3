# SPDX-License-Identifier: MIT
# C types of command_bounds.py: the numbers of a row are Python's here, which may be anything.
cimport cython
from nctakt.kernel cimport cells, codes, rows
from nctakt.kernel.base cimport bounds
from nctakt.kernel.tick.command_execution cimport CommandExecutor

cpdef check_command(CommandExecutor executor, list command)
@cython.locals(axes=Py_ssize_t)
cpdef check_column(CommandExecutor executor, int column, number)
@cython.locals(count=Py_ssize_t)
cpdef check_axes(list command, Py_ssize_t axes)
cpdef check_text(list command, Py_ssize_t size)
