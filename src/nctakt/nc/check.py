# SPDX-License-Identifier: MIT
"""Tree -> diagnostics: what can be known of a program before it runs."""
