# SPDX-License-Identifier: MIT
"""Which single change of a machine brings the run of a program nearer to a log."""
