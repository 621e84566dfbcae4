"""Large batches in cache-sized blocks: fast, and with little memory beside the result."""

from collections.abc import Iterator

BLOCK = 8192


def blocks(count: int) -> Iterator[slice]:
    """Consecutive slices that cover `count` rows."""
    for start in range(0, count, BLOCK):
        yield slice(start, min(start + BLOCK, count))
