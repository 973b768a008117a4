"""Patterns for tomographic volumetric printing, and what they print.

    import tomolith
    run = tomolith.Job("examples/01-gear.toml", set={"stop.iterations": 10}).run()
    print(run.metrics["iou"], run.dose.shape)

`Job` is a job file, `Run` what its run has left, `ResolvedJob` the same job as objects, `Task` its dose model and loss over numpy arrays, for
loops of your own; `Task.operator()` is that model for SciPy, `tomolith.jax` and `tomolith.torch` for JAX and PyTorch. Shapes, units and keys are those of the
command: docs/python.md, docs/conventions.md, docs/job.md.
"""

import os as _os
from typing import TYPE_CHECKING as _TYPE_CHECKING
from typing import Any as _Any

from . import _native
from ._native import Canceled, Job, ResolvedJob, Task, TomolithError, __version__, reproduce, sweep

if _TYPE_CHECKING:
    from ._run import Run

__all__ = ["Canceled", "Job", "ResolvedJob", "Run", "Task", "TomolithError", "__version__", "reproduce", "sweep"]

# A forked child has none of the threads that calls compute with
if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(after_in_child=_native._forked)


def __getattr__(name: str) -> _Any:
    # Numpy comes with it, and takes longer to load than all that the command needs
    if name == "Run":
        from ._run import Run

        return Run
    raise AttributeError(f"module 'tomolith' has no attribute {name!r}")
