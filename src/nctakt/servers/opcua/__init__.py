# SPDX-License-Identifier: MIT
"""OPC UA: the companion model for CNC, served to HMIs and control systems."""
