# SPDX-License-Identifier: MIT
"""Plans: what is varied and searched for, read and checked, its points as inputs."""
