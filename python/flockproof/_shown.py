"""How results are shown in a notebook."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from fractions import Fraction
from html import escape
from html.parser import HTMLParser
from typing import ClassVar

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


#: What means something else in LaTeX.
_ESCAPED = {
    **{sign: "\\" + sign for sign in "{}$&#_%"},
    "\\": r"\textbackslash{}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
}


class Shown:
    """What shows itself as HTML shows the same in LaTeX, for notebooks that become a paper."""

    def _repr_html_(self) -> str:
        raise NotImplementedError

    def _repr_latex_(self) -> str | None:
        return in_latex(self._repr_html_())


def in_latex(html: str) -> str:
    """What results show as HTML, in LaTeX; tables need the package `longtable`."""
    reader = _Latex()
    reader.feed(html)
    return re.sub(r"\n{3,}", "\n\n", "".join(reader.out)).strip()


class _Latex(HTMLParser):
    """Reads the few tags that results use."""

    BEFORE: ClassVar = {"b": r"\textbf{", "i": r"\emph{", "sub": r"\textsubscript{", "sup": r"\textsuperscript{"}

    def __init__(self) -> None:
        super().__init__()
        self.out: list[str] = []
        self.rows: list[list[str]] = []
        self.verbatim = False

    def handle_starttag(self, tag: str, attrs: object) -> None:
        if tag in self.BEFORE:
            self.out.append(self.BEFORE[tag])
        elif tag == "table":
            self.rows = []
        elif tag == "tr":
            self.rows.append([])
        elif tag in ("th", "td"):
            self.rows[-1].append("")
        elif tag == "pre":
            self.verbatim = True
        elif tag in ("br", "p"):
            self.out.append("\n\n")

    def handle_endtag(self, tag: str) -> None:
        if tag in self.BEFORE:
            self.out.append("}")
        elif tag == "table":
            self.out.append(_longtable(self.rows))
            self.rows = []
        elif tag == "pre":
            self.verbatim = False
        elif tag == "p":
            self.out.append("\n\n")

    def handle_data(self, data: str) -> None:
        text = "".join(_ESCAPED.get(sign, sign) for sign in data)
        if self.rows:
            self.rows[-1][-1] += text
        elif self.verbatim:
            lines = [r"\texttt{" + line.replace(" ", "~") + "}" for line in text.split("\n") if line]
            self.out.append("\n\n" + "\n\n".join(lines) + "\n\n")
        else:
            self.out.append(text)


def _longtable(rows: Sequence[Sequence[str]]) -> str:
    """The first row is the head; long columns share what the short ones leave of the line of some 80 letters."""
    widths = [min(max(len(row[k]) for row in rows), 120) for k in range(len(rows[0]))]
    long = [] if sum(widths) < 75 else [width for width in widths if width > 20]
    left = max(0.95 - (sum(widths) - sum(long) + 2 * len(widths)) / 80, 0.2)
    columns = "".join(f"p{{{left * width / sum(long):.3f}\\linewidth}}" if width in long else "l" for width in widths)
    head, *body = (" & ".join(row) + r" \\" for row in rows)
    lines = [rf"\begin{{longtable}}{{{columns}}}", head, r"\hline", r"\endhead", *body, r"\end{longtable}"]
    return "\n\n" + "\n".join(lines) + "\n\n"
