# SPDX-License-Identifier: MIT
"""The state of the decoder: modal state, offsets, tools, call stack, program variables."""
