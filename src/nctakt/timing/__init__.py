# SPDX-License-Identifier: MIT
"""Where the time of a run goes: by block, tool, program, kind and cause; effect of other limits."""
