"""Patterns for tomographic volumetric printing, and what they print.

    import tomolith
    job = tomolith.Job("examples/01-gear.toml", set=["stop.iterations=10"])
    print(job.run()["evaluation"]["iou"])

`Job` is a job file and its run, `ResolvedJob` the same job as objects, `Task` its dose model and objective over numpy arrays, for loops of
your own. Shapes, units and keys are those of the command: docs/python.md, docs/conventions.md, docs/job.md.
"""

import os as _os

from . import _native
from ._native import Job, ResolvedJob, Task, TomolithError, __version__, sweep

__all__ = ["Job", "ResolvedJob", "Task", "TomolithError", "__version__", "sweep"]

# A forked child has none of the threads that calls compute with
if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(after_in_child=_native._forked)
