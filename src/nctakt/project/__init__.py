# SPDX-License-Identifier: MIT
"""The project around a program: its file of settings, and the machine that it runs on."""
