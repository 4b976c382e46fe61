"""How results are shown in a notebook."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from fractions import Fraction
from html import escape

#: More rows than this are cut.
ROWS = 40


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table in HTML of texts, which are escaped."""
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><tr>{''.join(f'<th>{escape(name)}</th>' for name in head)}</tr>{body}</table>"


def told(title: str, lines: Iterable[str] = ()) -> str:
    """A line in bold and others below it."""
    return "<br>".join([f"<b>{escape(title)}</b>", *(escape(line) for line in lines)])


def latex(value: object) -> str:
    """A number, or a text that is one, in LaTeX: fractions as such, powers of ten written out."""
    if isinstance(value, Fraction) and value.denominator != 1:
        sign = "-" if value < 0 else ""
        return rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}"
    return re.sub(
        r"e([+-]?)0*(\d+)$", lambda found: rf"\times 10^{{{found[1].replace('+', '')}{found[2]}}}", str(value)
    )
