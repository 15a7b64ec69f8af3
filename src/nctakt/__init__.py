# SPDX-License-Identifier: MIT
"""nctakt: a virtual CNC controller that runs NC programs with realtime cycles tick by tick."""

__version__ = "0.1.0"
