"""Every public name says what it takes and gives, what is wrong input, and where it comes from."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from typing import Any

import pytest

import flockproof
from flockproof import claims, plot, strategies

MODULES = [flockproof, claims, strategies, plot]


def public() -> Iterator[tuple[str, Any]]:
    for module in MODULES:
        for name in module.__all__:
            yield f"{module.__name__}.{name}", getattr(module, name)


CALLABLES = {name: thing for name, thing in public() if callable(thing)}
FUNCTIONS = {name: thing for name, thing in CALLABLES.items() if not inspect.isclass(thing)}


def section(doc: str, title: str) -> str:
    """A section of a docstring in NumPy style; empty where there is none."""
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^\w[^\n]*\n-+\n|\Z)", doc, re.MULTILINE | re.DOTALL)
    return found[1] if found else ""


def explained(doc: str) -> set[str]:
    """The names of the section of parameters."""
    rows = re.findall(r"^(\w[\w, ]*?)(?: :.*)?$", section(doc, "Parameters"), re.MULTILINE)
    return {name for row in rows for name in row.split(", ")}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_name_their_arguments(name: str) -> None:
    doc = inspect.getdoc(FUNCTIONS[name]) or ""
    if name.endswith((".every", ".some")):
        assert doc
        return
    wanted = set(inspect.signature(FUNCTIONS[name]).parameters) - {"draw"}
    assert wanted <= explained(doc), f"{name}: {wanted - explained(doc)}"
    # Strategies are drawn from, and say in their first lines what comes.
    if not name.startswith("flockproof.strategies"):
        assert section(doc, "Returns") or name == "flockproof.exact", name


#: Those that take anything that could be wrong.
CAREFUL = [
    name for name in FUNCTIONS if name.count(".") == 1 and name not in ("flockproof.ledger", "flockproof.invariants")
]


@pytest.mark.parametrize("name", CAREFUL)
def test_functions_say_what_is_refused(name: str) -> None:
    assert "Error" in section(inspect.getdoc(FUNCTIONS[name]) or "", "Raises"), name


@pytest.mark.parametrize("name", CALLABLES)
def test_everything_is_described(name: str) -> None:
    thing = CALLABLES[name]
    assert len(inspect.getdoc(thing) or "") > 10, name
    for attribute, value in vars(thing).items() if inspect.isclass(thing) else ():
        bare = value.__func__ if isinstance(value, (classmethod, staticmethod)) else value
        if not attribute.startswith("_") and (inspect.isfunction(bare) or isinstance(bare, property)):
            assert inspect.getdoc(bare), f"{name}.{attribute}"
