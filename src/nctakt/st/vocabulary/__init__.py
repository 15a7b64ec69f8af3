# SPDX-License-Identifier: MIT
"""Names of Structured Text without a declaration: elementary types, functions, libraries."""
