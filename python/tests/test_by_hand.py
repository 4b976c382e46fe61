"""The programs of the errata's pages, which know nothing of the package: each prints what stands behind its lines."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(os.environ.get("FLOCKPROOF_ROOT", Path(__file__).resolve().parents[2]))
FOLDER = ROOT / "crates" / "report" / "src" / "site" / "by_hand"
SECTIONS = [section for file in sorted(FOLDER.glob("*.py")) for section in file.read_text().strip().split("\n\n")]


@pytest.mark.skipif(not FOLDER.is_dir(), reason="without the sources")
def test_there_are_some() -> None:
    assert len(SECTIONS) > 50


@pytest.mark.parametrize("section", SECTIONS, ids=[section.split(":")[0].removeprefix("# ") for section in SECTIONS])
def test_it_prints_what_it_says(section: str) -> None:
    done = subprocess.run([sys.executable, "-c", section], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == re.findall(r"^print\(.*\)  # (.*)$", section, re.MULTILINE)
