# SPDX-License-Identifier: MIT
"""The subcommands of ``nctakt schedule``."""
