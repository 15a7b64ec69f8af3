# SPDX-License-Identifier: MIT
"""Messages about what a user asks for: commands, inputs, studies, results."""
