# SPDX-License-Identifier: MIT
"""The rows of a study in files, while its runs are made and afterwards."""
