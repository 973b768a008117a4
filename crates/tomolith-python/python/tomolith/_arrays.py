"""Arrays as targets: `target.stack` of a job that is given as a dict may be one.

The library reads files, so each array is written to one, in a folder of the user in that of temporary files. Its path is that of its content: a job of the same
array is the same job in the next process, too. Each job holds its files open and locked, and whoever is the last to hold a file removes it.
"""

import contextlib
import hashlib
import os
import tempfile
import weakref
from collections.abc import Callable
from typing import Any, BinaryIO

from ._errors import TomolithError

try:
    import fcntl
except ImportError:  # Windows, where a file that is open cannot be removed
    fcntl = None  # type: ignore[assignment]

_ACCEPTED = "an array [z, y, x] of bool, of 0 and 1, of floats from 0 to 1, or of 8 or 16 bits without sign"


class Files:
    """The files of a job, which stay as long as this object."""

    def __init__(self) -> None:
        self.held: dict[str, BinaryIO] = {}
        weakref.finalize(self, _release, self.held)

    def write(self, key: str, stack: Any) -> str:
        """The path of a file with this array."""
        import numpy as np

        array = np.ascontiguousarray(stack)
        is_masked = np.ma.is_masked(stack)
        if is_masked or array.ndim != 3 or array.size == 0 or array.dtype.kind not in "biuf":
            found = "a masked array" if is_masked else f"an array of shape {list(np.shape(stack))} and type {array.dtype}"
            raise TomolithError(f"{key}: found {found}; accepted: {_ACCEPTED}", key=key, found=found, accepted=_ACCEPTED)
        content = hashlib.sha256(f"{array.dtype.str} {array.shape}".encode())
        content.update(array.data)
        folder = os.path.join(_own_folder(), content.hexdigest()[:32])
        path = os.path.join(folder, "target.npy")
        while path not in self.held:
            # Whoever held it before may remove it, and its folder, at any moment
            with contextlib.suppress(FileNotFoundError):
                os.makedirs(folder, exist_ok=True)
                if not os.path.exists(path):
                    part = f"{path}.{os.getpid()}-{id(self)}"
                    with open(part, "wb") as file:
                        np.save(file, array, allow_pickle=False)
                    os.replace(part, path)
                self._hold(path)
        return path

    def _hold(self, path: str) -> None:
        """Holds a file, unless it is gone when the lock is there."""
        file = open(path, "rb")
        if fcntl:
            fcntl.flock(file, fcntl.LOCK_SH)
        if _is_at(file, path):
            self.held[path] = file
        else:
            file.close()


def with_files(tables: dict[str, Any]) -> tuple[dict[str, Any], Files | None]:
    """The tables with files in the place of arrays, and these files where there are any."""
    files = Files()
    tables = _changed(tables, lambda key, stack: files.write(key, stack) if hasattr(stack, "dtype") else stack)
    return tables, files if files.held else None


def with_arrays(tables: dict[str, Any], files: Files) -> dict[str, Any]:
    """The tables with the arrays of these files, for machines that do not have them."""

    def read(_: str, stack: Any) -> Any:
        if stack not in files.held:
            return stack
        import numpy as np

        return np.load(stack, allow_pickle=False)

    return _changed(tables, read)


def _own_folder() -> str:
    """A folder that no other user may write to."""
    user = os.getuid() if hasattr(os, "getuid") else None
    folder = os.path.join(tempfile.gettempdir(), "tomolith" if user is None else f"tomolith-{user}")
    os.makedirs(folder, mode=0o700, exist_ok=True)
    if user is not None and os.stat(folder).st_uid != user:
        raise TomolithError(f"{folder}: found a folder of another user; accepted: another folder for temporary files, in TMPDIR")
    return folder


def _is_at(file: BinaryIO, path: str) -> bool:
    """Whether an open file is the one of this path."""
    try:
        return os.path.samestat(os.fstat(file.fileno()), os.stat(path))
    except FileNotFoundError:
        return False


def _release(held: dict[str, BinaryIO]) -> None:
    for path, file in held.items():
        try:
            if fcntl:
                # Fails where another job holds it
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                if _is_at(file, path):
                    os.remove(path)
            file.close()
            if not fcntl:
                os.remove(path)
            os.rmdir(os.path.dirname(path))
        except OSError:
            file.close()
    held.clear()


def _changed(tables: dict[str, Any], change: Callable[[str, Any], Any]) -> dict[str, Any]:
    """A copy in which `target.stack`, and that of each species, is what `change(key, stack)` returns."""

    def of(table: Any, begin: str) -> Any:
        target = table.get("target") if isinstance(table, dict) else None
        if not (isinstance(target, dict) and "stack" in target):
            return table
        return {**table, "target": {**target, "stack": change(f"{begin}target.stack", target["stack"])}}

    tables = dict(of(tables, ""))
    species = tables.get("species")
    if isinstance(species, list):
        tables["species"] = [of(table, f"species[{i}].") for i, table in enumerate(species)]
    return tables
