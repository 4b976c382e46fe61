#!/usr/bin/env python3
"""Says which links of the documentation lead nowhere: those of its own pages, into the site of claims and the pages
of cargo doc.

links.py FOLDER
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Targets(HTMLParser):
    """The places that a page leads to."""

    def __init__(self, page: Path) -> None:
        super().__init__()
        self.page, self.missing = page, []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            parts = urlsplit(value or "")
            if name in ("href", "src") and not parts.scheme and not parts.netloc and parts.path:
                target = self.page.parent / unquote(parts.path)
                if not target.exists():
                    self.missing.append(value)


def main(folder: str) -> None:
    root = Path(folder)
    wrong = []
    pages = [page for page in root.rglob("*.html") if page.relative_to(root).parts[0] not in ("rust", "site")]
    for page in pages:
        targets = Targets(page)
        targets.feed(page.read_text(encoding="utf-8"))
        wrong += [f"{page.relative_to(root)}: {target}" for target in targets.missing]
    if wrong:
        raise SystemExit("links that lead nowhere:\n" + "\n".join(wrong))
    print(f"{len(pages)} pages, every link leads somewhere")


if __name__ == "__main__":
    main(*sys.argv[1:])
