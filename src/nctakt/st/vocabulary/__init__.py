# SPDX-License-Identifier: MIT
"""What Structured Text knows without a declaration: elementary types, functions, libraries."""
