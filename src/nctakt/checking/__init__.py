# SPDX-License-Identifier: MIT
"""Files and folders -> all diagnostics of all programs and lists, without a run."""
