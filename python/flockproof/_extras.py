"""Packages that only some functions need."""

from __future__ import annotations

import importlib
import importlib.util
from typing import Any

#: The extras with the packages that they bring.
EXTRAS = {
    "control": ("control",),
    "fit": ("scipy",),
    "graphs": ("networkx", "scipy"),
    "movement": ("movement",),
    "pandas": ("pandas",),
    "parquet": ("pyarrow",),
    "plot": ("matplotlib",),
    "recordings": ("h5py", "h5netcdf", "scipy", "xarray"),
    "strategies": ("hypothesis",),
    "sweep": ("dask", "distributed"),
}


def needed(module: str, extra: str) -> Any:
    """The module, or an ImportError that says how to get it."""
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        raise missing([module.partition(".")[0]], [extra]) from error


def require(*extras: str) -> None:
    """Check that the packages of some extras are there: for the first cell of a notebook.

    Parameters
    ----------
    extras
        Such as ``"plot"``; see the page on Python in the notes.

    Returns
    -------
    None

    Raises
    ------
    ImportError
        Which packages are missing, and the command that installs them.
    ValueError
        What is no extra.

    Examples
    --------
    >>> require("graphs")
    """
    unknown = [extra for extra in extras if extra not in EXTRAS]
    if unknown:
        raise ValueError(f"`{unknown[0]}` is none of the extras {', '.join(EXTRAS)}")
    lacking = {extra: [p for p in EXTRAS[extra] if importlib.util.find_spec(p) is None] for extra in extras}
    packages = [package for found in lacking.values() for package in found]
    if packages:
        raise missing(packages, [extra for extra, found in lacking.items() if found])


def missing(packages: list[str], extras: list[str]) -> ImportError:
    """The error that says how to get packages."""
    verb = "is" if len(packages) == 1 else "are"
    install = f'pip install "flockproof[{",".join(extras)}]"'
    return ImportError(f"{' and '.join(packages)} {verb} needed for this: {install}", name=packages[0])
