# SPDX-License-Identifier: MIT
"""Plans: variations and goals, read and checked, and their points as inputs."""
