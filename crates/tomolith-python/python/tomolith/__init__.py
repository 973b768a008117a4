"""Patterns for tomographic volumetric printing, and what they print.

    import tomolith
    job = tomolith.Job("examples/01-gear.toml", set=["stop.iterations=10"])
    print(job.run()["quality"]["iou"])

`Job` is a job file and its run, `ResolvedJob` the same job as objects, `Task` its dose model and objective over numpy arrays, for loops of
your own. Shapes, units and keys are those of the command: docs/python.md, docs/conventions.md, docs/job.md.
"""

from ._native import Job, ResolvedJob, Task, TomolithError, __version__, sweep

__all__ = ["Job", "ResolvedJob", "Task", "TomolithError", "__version__", "sweep"]
