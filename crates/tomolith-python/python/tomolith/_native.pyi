from collections.abc import Callable, Iterable, Mapping, Sequence
from os import PathLike
from typing import Any, Protocol, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import Canceled as Canceled
from ._errors import TomolithError as TomolithError
from ._run import Run

__all__ = ["Canceled", "Job", "ResolvedJob", "Task", "TomolithError", "__version__", "_command", "_forked", "reproduce", "sweep"]

_Path = str | PathLike[str]
_Arrays = Any
"""A float32 array, or a list of one for each light, or species, where there are several."""

class _Observer(Protocol):
    """What `progress` may be in place of a callable."""

    @property
    def wants(self) -> Iterable[str]: ...
    def event(self, event: dict[str, Any], /) -> object: ...
    def snapshot(self, snapshot: dict[str, Any], /) -> object: ...

class _Token(Protocol):
    """What `cancel` may be; `threading.Event` is one."""

    def is_set(self) -> bool: ...

_Progress = Callable[[dict[str, Any]], object] | _Observer | None
__version__: str

@final
class Job:
    def __new__(
        cls,
        source: _Path | Mapping[str, Any],
        *,
        set: Mapping[str, Any] | Sequence[str] | None = None,
        folder: _Path | None = None,
    ) -> Job: ...
    @property
    def name(self) -> str: ...
    @property
    def folder(self) -> PathLike[str]: ...
    @property
    def tables(self) -> dict[str, Any]: ...
    def check(self) -> dict[str, Any]: ...
    def run(
        self,
        *,
        resume: bool = False,
        overwrite: bool = False,
        progress: _Progress = None,
        cancel: _Token | None = None,
    ) -> Run: ...
    def simulate(
        self,
        patterns: _Path,
        *,
        overwrite: bool = False,
        progress: _Progress = None,
        cancel: _Token | None = None,
    ) -> Run: ...
    def resolve(self) -> ResolvedJob: ...

@final
class ResolvedJob:
    @property
    def shape(self) -> tuple[int, int, int]: ...
    @property
    def pitch_mm(self) -> float: ...
    @property
    def warnings(self) -> list[str]: ...
    def task(self) -> Task: ...
    def evaluate(self, patterns: ArrayLike | Sequence[ArrayLike]) -> dict[str, Any]: ...

@final
class Task:
    @property
    def start(self) -> _Arrays: ...
    @property
    def lit(self) -> Any: ...
    @property
    def quantity(self) -> str: ...
    @property
    def is_linear(self) -> bool: ...
    @property
    def outputs(self) -> list[str]: ...
    @property
    def sub_angles(self) -> list[int]: ...
    @property
    def shape(self) -> tuple[int, int, int]: ...
    @property
    def voxel_mm(self) -> tuple[float, float]: ...
    @property
    def box_mm(self) -> list[tuple[float, float, float]]: ...
    @property
    def bounds(self) -> tuple[_Arrays, _Arrays]: ...
    @property
    def target(self) -> NDArray[np.float32]: ...
    @property
    def labels(self) -> NDArray[np.uint8]: ...
    def dose(self, patterns: ArrayLike | Sequence[ArrayLike]) -> _Arrays: ...
    def pullback(self, patterns: ArrayLike | Sequence[ArrayLike], cotangent: ArrayLike | Sequence[ArrayLike]) -> _Arrays: ...
    def value_and_gradient(self, patterns: ArrayLike | Sequence[ArrayLike]) -> tuple[float, _Arrays]: ...
    def evaluate(self, patterns: ArrayLike | Sequence[ArrayLike]) -> dict[str, Any]: ...
    def operator(self) -> Any: ...

def sweep(
    file: _Path,
    *,
    folder: _Path | None = None,
    threads: int | None = None,
    progress: _Progress = None,
    cancel: _Token | None = None,
) -> dict[str, Any]: ...
def reproduce(
    study: _Path,
    *,
    quick: bool = False,
    folder: _Path | None = None,
    threads: int | None = None,
    progress: _Progress = None,
    cancel: _Token | None = None,
) -> dict[str, Any]: ...
def _command(words: Sequence[str], itself: Sequence[str]) -> int: ...
def _forked() -> None: ...
