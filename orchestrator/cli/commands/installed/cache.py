"""The command that shows and empties the cache."""

from __future__ import annotations

from typing import Annotated

import typer

from ...options import app

SHOWN = {"fmus": "unpacked FMUs", "kernels": "compiled kernels"}


@app.command()
def cache(
    clear: Annotated[bool, typer.Option("--clear", help="Throw away what no running process needs.")] = False,
) -> None:
    """Show what is kept between runs: unpacked FMUs and compiled kernels. ROVBRUSH_CACHE names another folder."""
    from ....cache.cache import cache_folder, entries, limit
    from ....cache.cache import clear as empty

    print(f"cache folder {cache_folder()}")
    if clear:
        gone, left = empty()
        kept = f"; running processes need what stays: {_megabytes(sum(entry.size for entry in left))}" if left else ""
        print(f"{_megabytes(gone)} thrown away{kept}")
        return
    found = entries()
    for kind, name in SHOWN.items():
        those = [entry for entry in found if entry.kind == kind]
        needed = sum(entry.needed for entry in those)
        running = f", {needed} needed by running processes" if needed else ""
        print(f"  {name:<18} {len(those):>6}  {_megabytes(sum(entry.size for entry in those)):>10}{running}")
    total = _megabytes(sum(entry.size for entry in found))
    print(f"  {'all':<18} {len(found):>6}  {total:>10} of {_megabytes(limit())} (ROVBRUSH_CACHE_LIMIT)")


def _megabytes(size: int) -> str:
    return f"{size / 1e6:.1f} MB"
