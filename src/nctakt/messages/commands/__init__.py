# SPDX-License-Identifier: MIT
"""Messages about a user's requests: commands, inputs, studies, results."""
