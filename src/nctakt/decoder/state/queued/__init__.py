# SPDX-License-Identifier: MIT
"""Commands as they go down the queue, and the rows that they become."""
