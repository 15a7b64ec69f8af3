# SPDX-License-Identifier: MIT
"""The debugger of editors: ``nctakt dap`` speaks the Debug Adapter Protocol over a session."""
