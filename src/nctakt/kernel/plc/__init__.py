# SPDX-License-Identifier: MIT
"""The PLC's side: panel, technology functions, requests and the interface image."""
