# SPDX-License-Identifier: MIT
"""The parts of the page in one browser."""
