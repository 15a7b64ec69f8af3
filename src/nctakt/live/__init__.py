# SPDX-License-Identifier: MIT
"""The live page: a session in the browser, for a person who writes realtime cycles."""
