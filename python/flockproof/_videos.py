"""Frame rates from the headers of videos; no frame is decoded."""

from __future__ import annotations

import os
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

#: Larger headers than this are not read.
_LARGEST = 1 << 26
#: The share of frames that may last longer or shorter than the others, as the last one often does.
_UNEVEN = 0.01


def rate(path: Path) -> float | None:
    """Frames per second of an AVI, MP4 or QuickTime file; None where it says none, or frames last unequally long."""
    try:
        with open(path, "rb") as file:
            start = file.read(12)
            if start[:4] == b"RIFF" and start[8:] == b"AVI ":
                return _avi(file.read(1 << 16))
            if start[4:8] in (b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip"):
                return _mp4(file)
    except (OSError, struct.error, ValueError):
        pass
    return None


def beside(table: Path, name: str | None = None) -> tuple[float, str] | None:
    """The rate of the video of a table, and the video's name.

    It is the one that the table names, there or beside the table, else the one whose name begins that of the table.
    """
    if name is not None:
        # Written on another system perhaps.
        plain = name.replace("\\", "/").rpartition("/")[2]
        candidates = [Path(name), table.parent / plain] if plain else []
    else:
        endings = (".avi", ".mp4", ".mov", ".m4v")
        files = (file for file in table.parent.iterdir() if file.suffix.lower() in endings)
        candidates = sorted(
            (file for file in files if table.stem.startswith(file.stem) and not file.stem.endswith("_labeled")),
            key=lambda file: (-len(file.stem), file.name),
        )[:1]
    for file in candidates:
        found = rate(file)
        if found is not None:
            return found, file.name
    return None


def _avi(header: bytes) -> float | None:
    """The rate of the first stream of video; in `strh` scale and rate stand behind 20 bytes."""
    at = header.find(b"strh")
    while at >= 0:
        if header[at + 8 : at + 12] == b"vids":
            scale, per = struct.unpack_from("<II", header, at + 28)
            return per / scale if scale and per else None
        at = header.find(b"strh", at + 4)
    return None


def _boxes(file: BinaryIO, end: int) -> Iterator[tuple[bytes, int, int]]:
    """Kind, begin and end of what is in each box from here to `end`."""
    at = file.tell()
    while at + 8 <= end:
        file.seek(at)
        size, kind = struct.unpack(">I4s", file.read(8))
        inner = at + 8
        if size == 1:
            size, inner = struct.unpack(">Q", file.read(8))[0], at + 16
        stop = end if size == 0 else at + size
        if not inner <= stop <= end:
            raise ValueError("a box is longer than the one around it")
        yield kind, inner, stop
        at = stop


def _inside(file: BinaryIO, where: tuple[int, int], *kinds: bytes) -> tuple[int, int] | None:
    """The first box along a path of kinds."""
    for kind in kinds:
        file.seek(where[0])
        found = next(((begin, end) for name, begin, end in _boxes(file, where[1]) if name == kind), None)
        if found is None:
            return None
        where = found
    return where


def _payload(file: BinaryIO, where: tuple[int, int]) -> bytes:
    if where[1] - where[0] > _LARGEST:
        raise ValueError("a header that is too large")
    file.seek(where[0])
    return file.read(where[1] - where[0])


def _mp4(file: BinaryIO) -> float | None:
    """Of the track of video the number of frames over their durations, in units of its time scale."""
    size = file.seek(0, os.SEEK_END)
    movie = _inside(file, (0, size), b"moov")
    if movie is None:
        return None
    file.seek(movie[0])
    tracks = [(begin, end) for kind, begin, end in _boxes(file, movie[1]) if kind == b"trak"]
    for track in tracks:
        handler, clock = (_inside(file, track, b"mdia", kind) for kind in (b"hdlr", b"mdhd"))
        times = _inside(file, track, b"mdia", b"minf", b"stbl", b"stts")
        if handler is None or clock is None or times is None or _payload(file, handler)[8:12] != b"vide":
            continue
        said = _payload(file, clock)
        (scale,) = struct.unpack_from(">I", said, 20 if said[0] == 1 else 12)
        table = _payload(file, times)
        (entries,) = struct.unpack_from(">I", table, 4)
        runs = [struct.unpack_from(">II", table, 8 + 8 * k) for k in range(min(entries, len(table) // 8 - 1))]
        return _even(runs, scale)
    return None


def _even(runs: list[tuple[int, ...]], scale: int) -> float | None:
    """The rate where nearly all frames last equally long, but for one unit of rounding; none of a single frame."""
    frames, units = sum(count for count, _ in runs), sum(count * length for count, length in runs)
    if not (frames > 1 and units and scale):
        return None
    mean = units / frames
    if sum(count for count, length in runs if abs(length - mean) > max(1, _UNEVEN * mean)) > max(1, _UNEVEN * frames):
        return None
    # The last frame often lasts otherwise.
    usual = [(count, length) for count, length in runs if abs(length - mean) <= max(1, _UNEVEN * mean)]
    lasts = sum(count * length for count, length in usual)
    return scale * sum(count for count, _ in usual) / lasts if lasts else None
