"""`Run`: what a run has left in its folder, read when it is asked for."""

from __future__ import annotations

import base64
import csv
import json
import re
import struct
import zlib
from collections.abc import Callable
from functools import cached_property
from html import escape
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from ._native import TomolithError

if TYPE_CHECKING:
    from numpy.typing import NDArray

_T = TypeVar("_T")
_TYPES = {"Float32": "<f4", "UInt8": "u1"}


def _one_or_list(arrays: list[NDArray[Any]]) -> Any:
    return arrays[0] if len(arrays) == 1 else arrays


def _found(pattern: str, text: str) -> tuple[str, ...]:
    found = re.search(pattern, text)
    if found is None:
        raise ValueError(f"found no {pattern}")
    return found.groups()


class Page:
    """A page that a notebook shows in its output: in a frame of its own that reaches neither the notebook nor the network."""

    def __init__(self, html: str, height: int) -> None:
        self.html = html
        self.height = height

    def _repr_html_(self) -> str:
        style = f"width: 100%; height: {self.height:d}px; border: 0"
        return f'<iframe sandbox="allow-scripts" style="{style}" srcdoc="{escape(self.html)}"></iframe>'


class Run:
    """The folder of a finished run or simulation; `Job.run` and `Job.simulate` return one, `Run.open(folder)` reads one.

    Arrays are numpy arrays: patterns `[frame, row, column]`, or a list of one for each light where there are several; voxels `[z, y, x]` on
    the job's grid, `dose` and `print` a list of one for each species where there are several. Each is read when it is asked for. A file that is
    missing or damaged raises `TomolithError`.
    """

    def __init__(self, folder: str | PathLike[str], summary: dict[str, Any] | None = None) -> None:
        self.folder = Path(folder).absolute()
        self.summary = summary
        """What `tomolith run --json` says at its end, a dict; None for a folder that was opened."""
        self.report  # a folder without one is no run
        self._stamp = self._stamp_now()

    @classmethod
    def open(cls, folder: str | PathLike[str]) -> Run:
        """The run of a folder."""
        return cls(folder)

    def __fspath__(self) -> str:
        return str(self.folder)

    def _stamp_now(self) -> tuple[int, ...] | None:
        """What tells the report of this run from that of another in its folder; None where there is none."""
        try:
            stat = (self.folder / "report.json").stat()
        except OSError:
            return None
        return stat.st_mtime_ns, stat.st_ino, stat.st_size

    def _must_be_there(self, path: Path) -> None:
        """Refuses a folder with another run than this one; one of the same job has the same numbers."""
        now = self._stamp_now()
        if now in (self._stamp, None):
            return
        if type(self)(self.folder).report["evaluation"] != self.report["evaluation"]:
            found = "found another run than the one that this object was made of"
            raise TomolithError(f"{path}: {found}; accepted: Run.open(folder) for the run that is there now, and a folder for each run")
        self._stamp = now

    def _read(self, name: str, read: Callable[[Path], _T]) -> _T:
        path = self.folder / name
        if name != "report.json":
            self._must_be_there(path)
        try:
            return read(path)
        except FileNotFoundError:
            found = "the file is missing" if self.folder.is_dir() else "the folder is missing"
            raise TomolithError(f"{path}: {found}; accepted: the folder of a finished run (--keep leaves some files out)") from None
        except Exception as error:  # readers of damaged files raise many kinds
            raise TomolithError(f"{path}: {error}; accepted: the file as the run wrote it") from error

    @cached_property
    def report(self) -> dict[str, Any]:
        """All numbers of the report, as a dict (docs/run-folder.md)."""
        return self._read("report.json", lambda path: dict(json.loads(path.read_text("utf-8"))))

    @property
    def metrics(self) -> dict[str, Any]:
        """The numbers of the print by their names, such as `iou`, `pw` or `surface_mean_mm`; None where one does not apply."""
        evaluation = self._read("report.json", lambda _: self.report["evaluation"].items())
        return {name: value for name, value in evaluation if not isinstance(value, dict | list)}

    @cached_property
    def history(self) -> NDArray[Any]:
        """A structured array with a row per iteration: `history["loss"]`, NaN where there is no number. A simulation has none."""

        def read(path: Path) -> NDArray[Any]:
            with path.open(newline="", encoding="utf-8") as file:
                names, *rows = csv.reader(file)
            numbers = [tuple(float(cell or "nan") for cell in row) for row in rows]
            return np.array(numbers, dtype=[(name, float) for name in names])

        return self._read("history.csv", read)

    def _patterns(self, kind: str) -> Any:
        def read(path: Path) -> Any:
            lights = [light["name"] for light in self.report["lights"]]
            with np.load(path) as file:
                return _one_or_list([file[f"{kind}_{name}" if name else kind] for name in lights])

        return self._read("patterns.npz", read)

    @cached_property
    def patterns(self) -> Any:
        """What the projector shows, float32, in units of areal dose over the exposure."""
        return self._patterns("patterns")

    @cached_property
    def patterns_raw(self) -> Any:
        """The same before it was rounded to the projector's gray levels."""
        return self._patterns("patterns_raw")

    @cached_property
    def dose(self) -> Any:
        """The absorbed dose, float32."""
        files = ["dose.npy"] + [f"dose_{s['name']}.npy" for s in self.report["species"][1:]]
        return _one_or_list([self._read(file, lambda path: np.load(path)) for file in files])

    @cached_property
    def target(self) -> NDArray[np.float32]:
        """The share of each voxel that lies in the part, float32."""
        return self._voxels("target")

    @cached_property
    def labels(self) -> NDArray[np.uint8]:
        """2 where a voxel is part, 1 void, 0 where it does not count, uint8."""
        return self._voxels("label")

    @cached_property
    def print(self) -> Any:
        """True where the dose is enough for the resin to be solid, at the exposure of the report's numbers."""
        gel_dose = self._gel_dose
        if gel_dose is None:
            raise TomolithError(
                f"{self.folder}: no threshold in the report, as of gray targets or where nothing is solid; accepted: runs with a threshold; "
                "`dose` has the dose, and with output.evaluation = true evaluation/response.npy the response"
            )
        doses = self.dose if isinstance(self.dose, list) else [self.dose]
        return _one_or_list([dose >= gel_dose for dose in doses])

    @property
    def _gel_dose(self) -> float | None:
        together, alone = self.report["one_exposure"], self.report["exposure"]
        if together:
            return float(together["gel_dose"])
        if not (alone and alone["dose"] and alone["reported_percent"]):
            return None
        # What gels at s times the best exposure got 1/s of the dose
        return float(alone["dose"]["best"]) / (float(alone["reported_percent"]) / 100)

    @cached_property
    def _grid(self) -> tuple[str, int, tuple[int, ...], list[float], list[float]]:
        """Of dose.vti: its text, where its bytes begin, counts and first voxel `(z, y, x)`, edge."""

        def read(path: Path) -> tuple[str, int, tuple[int, ...], list[float], list[float]]:
            with path.open("rb") as file:
                head, mark, after = file.read(1 << 16).partition(b'<AppendedData encoding="raw">')
            begin = len(head) + len(mark) + after.index(b"_") + 1
            text = head.decode()
            numbers = {key: _found(f'{key}="([^"]*)"', text)[0].split() for key in ("WholeExtent", "Origin", "Spacing")}
            counts = tuple(int(last) + 1 for last in numbers["WholeExtent"][5::-2])
            first, edge = ([float(n) for n in reversed(numbers[key])] for key in ("Origin", "Spacing"))
            return text, begin, counts, first, edge

        return self._read("dose.vti", read)

    def _voxels(self, name: str) -> NDArray[Any]:
        text, begin, counts, *_ = self._grid

        def read(path: Path) -> NDArray[Any]:
            kind, offset = _found(f'type="(\\w+)" Name="{name}" format="appended" offset="(\\d+)"', text)
            # The bytes of an array follow their number
            count = int(np.prod(counts))
            return np.fromfile(path, _TYPES[kind], count, offset=begin + int(offset) + 8).reshape(counts)

        return self._read("dose.vti", read)

    @property
    def coordinates_mm(self) -> tuple[NDArray[Any], ...]:
        """The middles of the voxels, mm: arrays for z, y and x."""
        *_, counts, first, edge = self._grid
        return tuple(f + e * np.arange(n) for n, f, e in zip(counts, first, edge))

    def to_xarray(self) -> Any:
        """An `xarray.Dataset` of dose, target, labels and, where there is one, print, over z, y and x in mm. Needs xarray.

        Doses and prints of several species are named `dose_NAME`, `print_NAME`.
        """
        try:
            import xarray
        except ImportError as error:
            raise TomolithError("to_xarray: xarray is missing; accepted: an environment with it (pip install xarray)") from error
        axes = {axis: (axis, values, {"units": "mm"}) for axis, values in zip("zyx", self.coordinates_mm)}
        arrays = {"target": self.target, "labels": self.labels}
        names = [s["name"] for s in self.report["species"]]
        kinds = ["dose"] + ([] if self._gel_dose is None else ["print"])
        for kind in kinds:
            values = getattr(self, kind)
            of_each = {f"{kind}_{name}": array for name, array in zip(names, values)} if isinstance(values, list) else {kind: values}
            arrays |= of_each
        return xarray.Dataset({name: (("z", "y", "x"), array) for name, array in arrays.items()}, axes, {"folder": str(self.folder)})

    def page(self, height: int = 800) -> Page:
        """The page of the run (`report.html`) for a notebook's output, `height` pixels high; see docs/page.md."""
        return Page(self._read("report.html", lambda path: path.read_text("utf-8")), height)

    def _headline(self) -> str:
        of = self.metrics
        names = ("in_band", "rms_error") if of.get("iou") is None else ("iou", "ver", "pw", "surface_mean_mm")
        return ", ".join(f"{name} {of[name]:.4g}" for name in names if of.get(name) is not None)

    def __repr__(self) -> str:
        return f"<tomolith.Run {self.folder}: {self._headline()}>"

    def _repr_html_(self) -> str:
        text = f"<b>{escape(self.report['part'])}</b>: {escape(self._headline())}<br><code>{escape(str(self.folder))}</code>"
        try:
            dose, target = self.dose, self.target
        except TomolithError:
            return text  # a run that kept no volumes
        image = base64.b64encode(_png(_slices(dose[0] if isinstance(dose, list) else dose, target))).decode()
        return f'{text}<br><img alt="dose across z, y and x, target outlined" src="data:image/png;base64,{image}">'


def _slices(dose: NDArray[np.float32], target: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Middle slices across z, y and x side by side: the dose in gray, the edge of the target in red."""
    planes = []
    for axis in range(3):
        middle = dose.shape[axis] // 2
        values, part = dose.take(middle, axis), target.take(middle, axis) >= 0.5
        if axis:
            values, part = values[::-1], part[::-1]  # z points up
        scale = max(1, 240 // max(values.shape))
        values, part = (np.kron(a, np.ones((scale, scale), a.dtype)) for a in (values, part))
        inner = np.pad(part, 1)
        edge = part & ~(inner[:-2, 1:-1] & inner[2:, 1:-1] & inner[1:-1, :-2] & inner[1:-1, 2:])
        gray = np.repeat((255 * np.clip(values / max(dose.max(), 1e-30), 0, 1)).astype(np.uint8)[..., None], 3, axis=2)
        gray[edge] = (220, 50, 40)
        planes.append(gray)
    height = max(plane.shape[0] for plane in planes)
    white = [((0, height - plane.shape[0]), (0, 6), (0, 0)) for plane in planes]
    return np.concatenate([np.pad(plane, pad, constant_values=255) for plane, pad in zip(planes, white)], axis=1)


def _png(rgb: NDArray[np.uint8]) -> bytes:
    """A picture `[row, column, color]` of 8 bits as the bytes of a PNG file."""
    rows, columns, _ = rgb.shape
    lines = np.pad(rgb.reshape(rows, -1), ((0, 0), (1, 0)))  # each begins with the number of its filter, 0

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines.tobytes())) + chunk(b"IEND", b"")
