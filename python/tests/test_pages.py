"""The Python that the pages for readers show runs as it stands there."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(os.environ.get("FLOCKPROOF_ROOT", Path(__file__).resolve().parents[2]))
PAGES = [page for folder in ("", "notes", "python") for page in sorted((ROOT / folder).glob("*.md"))]


def programs() -> list[str]:
    """All blocks of Python, and what stands after `python3 -c`."""
    found = []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        found += re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        found += re.findall(r"^python3 -c \"(.*)\"$", text, re.MULTILINE)
    return found


def test_there_are_some() -> None:
    assert len(programs()) >= 2


@pytest.mark.parametrize("program", programs())
def test_what_is_shown_runs(program: str) -> None:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
