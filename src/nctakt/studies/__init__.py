# SPDX-License-Identifier: MIT
"""Many runs of one program: variations, measures, expectations."""
