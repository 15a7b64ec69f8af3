# SPDX-License-Identifier: MIT
"""The progress and the results of ``nctakt study`` on a terminal."""
