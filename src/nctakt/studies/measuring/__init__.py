# SPDX-License-Identifier: MIT
"""Measures and expectations: from their texts to the verdict on a run."""
