# SPDX-License-Identifier: MIT
"""ADS: PLCs and HMIs of the TwinCAT world find the controller (AD-1 … AD-6)."""
