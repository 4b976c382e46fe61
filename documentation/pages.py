#!/usr/bin/env python3
"""Gathers the sources of the documentation in a folder: the pages of the repository, and those made of the commands'
help, of the crates and of a ledger.

    pages.py FLOCKPROOF LEDGER.json OUT
"""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAPERS = {
    "chazelle": "Chazelle, Natural algorithms",
    "veerman": "Veerman, Stošić, Olvera, Spatial instabilities and size limitations of flocks",
    "paley": "Paley, Leonard, Sepulchre, Grünbaum, Parrish, Oscillator models and collective motion",
    "tanner1": "Tanner, Jadbabaie, Pappas, Stable flocking of mobile agents, part I: fixed topology",
    "tanner2": "Tanner, Jadbabaie, Pappas, Flocking in fixed and switching networks",
    "beyond": "Corrections and own results",
}


def beside(words: str, path: str) -> str:
    """A link to a file that Sphinx does not make."""
    return f'<a href="{path}">{words}</a>'


def fenced(text: str) -> str:
    """A block that shows a text as it is, whatever it has in it."""
    return f"````\n{text.rstrip()}\n````\n"


def copy_pages(out: Path) -> None:
    """The pages of the repository; a page that is named between backticks becomes a link."""
    pages = [ROOT / f"{name}.md" for name in ("README", "ARCHITECTURE", "CONTRIBUTING", "CHANGELOG")]
    pages += [page for page in sorted((ROOT / "notes").glob("*.md")) if page.name != "README.md"]
    pages.append(ROOT / "proofs_checks" / "README.md")
    known = {page.relative_to(ROOT).as_posix() for page in pages}
    for page in pages:
        name = page.relative_to(ROOT)
        up = "../" * (len(name.parts) - 1)

        def link(found: re.Match[str], name: Path = name, up: str = up) -> str:
            for path in (found[1], (name.parent / found[1]).as_posix()):
                if path in known and path != name.as_posix():
                    return f"[{found[0]}]({up}{path})"
            return found[0]

        # Only outside of blocks.
        parts = page.read_text(encoding="utf-8").split("```")
        parts[::2] = [re.sub(r"(?<!\[)`([\w./-]+\.md)`", link, part) for part in parts[::2]]
        # Sources are in the repository only.
        parts[::2] = [re.sub(r"\[([^\]]+)\]\((?:\.\./)*crates/[^)]*\)", r"\1", part) for part in parts[::2]]
        # Sphinx takes no pictures along that are written as HTML.
        parts[::2] = [re.sub(r'<img src="([^"]+)"[^>]* alt="([^"]*)">', r"![\2](\1)", part) for part in parts[::2]]
        target = out / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text("```".join(parts), encoding="utf-8")
    for picture in set(re.findall(r"\]\(([\w./-]+\.(?:svg|png|gif))", (out / "README.md").read_text(encoding="utf-8"))):
        (out / picture).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / picture, out / picture)


def commands(flockproof: str) -> str:
    """The help of every command."""

    def said(*arguments: str) -> str:
        return subprocess.run([flockproof, *arguments], capture_output=True, text=True, check=True).stdout

    listed = re.search(r"^Commands:\n(.*?)\n\n", said("--help"), re.MULTILINE | re.DOTALL)
    if listed is None:
        raise SystemExit("flockproof --help lists no commands")
    names = [name for name in re.findall(r"^  ([\w-]+)", listed[1], re.MULTILINE) if name != "help"]
    text = "# Options of the commands\n\nAs `flockproof COMMAND --help` prints them.\n"
    for name in names:
        text += f"\n## {name}\n\n{fenced(said(name, '--help'))}"
        below = re.search(r"^Commands:\n(.*?)(?:\n\n|\Z)", said(name, "--help"), re.MULTILINE | re.DOTALL)
        for inner in re.findall(r"^  ([\w-]+)", below[1], re.MULTILINE) if below else []:
            if inner != "help":
                text += f"\n### {name} {inner}\n\n{fenced(said(name, inner, '--help'))}"
    return text


def crates() -> str:
    """Each crate with the first page of its documentation."""
    metadata = subprocess.run(
        ["cargo", "metadata", "--format-version", "1", "--no-deps", "--offline"],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    text = "# Rust\n\nThe crate `flockproof` has the others under one name. All items: "
    text += beside("rust/flockproof", "rust/flockproof/index.html") + "\n"
    packages = sorted(
        json.loads(metadata.stdout)["packages"], key=lambda package: (package["name"] != "flockproof", package["name"])
    )
    for package in packages:
        library = next((target for target in package["targets"] if "lib" in target["kind"]), None)
        if library is None or package["name"] in ("flockproof-python", "flockproof-benches"):
            continue
        source = Path(library["src_path"]).read_text(encoding="utf-8")
        lines = [line[3:].removeprefix(" ") for line in source.splitlines() if line.startswith("//!")]
        # Examples as rustdoc shows them, without the lines that it hides; links to items are for rustdoc.
        parts = "\n".join(lines).split("```")
        shown = [re.sub(r"(?m)^# .*\n", "", part) for part in parts[1::2]]
        parts[1::2] = ["rust" + part if part.startswith("\n") else part for part in shown]
        parts[::2] = [re.sub(r"\[(`[^`]+`)\](?:\([^)]*\))?", r"\1", part) for part in parts[::2]]
        words = "```".join(parts)
        page = f"rust/{library['name'].replace('-', '_')}/index.html"
        text += f"\n## {package['name']}\n\n{package['description']}\n\n{words}\n\nAll items: {beside(page, page)}\n"
    return text


def claims(ledger: dict, paper: str) -> str:
    """The claims of a paper with their statements and verdicts."""
    text = f"# Claims: {PAPERS[paper]}\n\n"
    for claim in ledger["claims"]:
        if claim["paper"] != paper:
            continue
        page = f"site/claims/{claim['id']}.html"
        text += f"## {claim['id']}\n\n**{claim['verdict']}** ({claim['place']}). "
        text += f"{beside('Evidence and controls', page)}\n\n"
        text += fenced(claim["statement"])
    return text


def main(flockproof: str, ledger_file: str, out: str) -> None:
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("conf.py", "index.md", "python.md", "wrap.css"):
        shutil.copyfile(Path(__file__).with_name(name), folder / name)
    copy_pages(folder)
    ledger = json.loads(Path(ledger_file).read_text(encoding="utf-8"))
    made = {"commands": commands(flockproof), "rust": crates()} | {
        f"claims-{paper}": claims(ledger, paper) for paper in PAPERS
    }
    made["claims-site"] = (
        f"# The site of claims\n\n{beside('All claims', 'site/index.html')}, each on a page of its own, with figures and errata.\n"
    )
    for name, text in made.items():
        (folder / f"{name}.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    main(*sys.argv[1:])
