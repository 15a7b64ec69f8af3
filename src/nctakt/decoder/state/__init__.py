# SPDX-License-Identifier: MIT
"""What the decoder keeps: modal state, offsets, tools, call stack, program variables."""
