"""`Task.operator`: a linear dose model for SciPy."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._native import Task, TomolithError


def operator(task: Task) -> Any:
    """See `Task.operator`."""
    if not task.is_linear:
        raise TomolithError("operator: the dose of this model is not linear in the patterns; accepted: dose and pullback, or a linear model")
    try:
        from scipy.sparse.linalg import LinearOperator
    except ImportError as error:
        raise TomolithError("operator: SciPy is missing; accepted: an environment with it (pip install scipy)") from error
    images = [lit.shape for lit in _each(task.lit)]
    volumes = [task.shape] * len(task.outputs)
    dark = [np.zeros(shape, np.float32) for shape in images]

    def matvec(x: NDArray[Any]) -> NDArray[Any]:
        return _joined(task.dose(_split(x, images)))

    def rmatvec(cotangent: NDArray[Any]) -> NDArray[Any]:
        return _joined(task.pullback(dark, _split(cotangent, volumes)))

    shape = tuple(sum(int(np.prod(s)) for s in shapes) for shapes in (volumes, images))
    return LinearOperator(shape, matvec, rmatvec, dtype=np.float32)


def _each(arrays: Any) -> list[NDArray[Any]]:
    return arrays if isinstance(arrays, list) else [arrays]


def _joined(arrays: Any) -> NDArray[Any]:
    return np.concatenate([array.ravel() for array in _each(arrays)])


def _split(vector: NDArray[Any], shapes: Sequence[tuple[int, ...]]) -> list[NDArray[Any]]:
    ends = np.cumsum([np.prod(shape) for shape in shapes])
    return [part.reshape(shape) for part, shape in zip(np.split(np.ravel(vector), ends[:-1]), shapes)]
