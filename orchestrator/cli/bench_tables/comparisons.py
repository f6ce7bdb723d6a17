"""This installation and its FMUs beside others."""

from __future__ import annotations

from ..console import print_table
from .words import Rows


def print_against(rows: Rows) -> None:
    """This installation over another one."""
    cells = [
        (
            r["figure"], f"{r['here_s']:.4g}", f"{r['there_s']:.4g}", f"{r['ratio']:.3f}",
            f"{r['ratio_of_fastest']:.3f}",
        ) for r in rows
    ]  # fmt: skip
    title = f"This installation and the other, medians of {rows[0]['rounds']} runs in turns"
    print_table(title, ("", "here [s]", "there [s]", "ratio", "of the\nfastest"), cells)


def print_folders(rows: Rows) -> None:
    """The FMUs of two folders: time per call, first start, size."""
    cells = [
        (
            r["fmu"], f"{r['us_per_call_here']:.4g}", f"{r['us_per_call_there']:.4g}", f"{r['us_per_call_ratio']:.3f}",
            f"{r['ratio_of_fastest']:.3f}",
            *(f"{r[key]:.2f}" if key in r else "" for key in ("first_s_here", "first_s_there", "first_s_ratio")),
            f"{r['kB_ratio']:.3f}",
        ) for r in rows
    ]  # fmt: skip
    title = f"These FMUs and the others: one call, medians of {rows[0]['rounds']} runs in turns, and the first start"
    headings = ("", "here [us]", "there [us]", "ratio", "of the\nfastest", "first [s]", "there [s]", "ratio", "size")
    print_table(title, headings, cells)
