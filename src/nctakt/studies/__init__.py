# SPDX-License-Identifier: MIT
"""Many runs of one program: what is varied, what is measured, what is expected."""
