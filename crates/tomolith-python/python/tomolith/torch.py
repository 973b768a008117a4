"""A job's dose model as a function and a module of PyTorch, with its exact derivative. Needs PyTorch.

    dose = tomolith.torch.Dose(task)
    patterns = torch.tensor(task.start, requires_grad=True)
    own_loss(dose(patterns)).backward()
"""

from collections.abc import Sequence
from typing import Any

import torch

from ._native import Task


class _Dose(torch.autograd.Function):
    """`Task.dose` of the patterns of each light, as a tuple of a tensor for each species."""

    @staticmethod
    def forward(ctx: Any, task: Task, *patterns: torch.Tensor) -> Any:
        ctx.task, ctx.device = task, patterns[0].device
        ctx.save_for_backward(*patterns)
        return _tensors(task.dose(_arrays(patterns)), ctx.device)

    @staticmethod
    def backward(ctx: Any, *cotangents: torch.Tensor) -> Any:
        patterns = ctx.saved_tensors
        return (None, *_Pullback.apply(ctx.task, len(patterns), *patterns, *cotangents))


class _Pullback(torch.autograd.Function):
    """`Task.pullback` of so many patterns and the cotangents after them; of a linear model `Task.dose` is its derivative."""

    @staticmethod
    def forward(ctx: Any, task: Task, lights: int, *tensors: torch.Tensor) -> Any:
        ctx.task, ctx.lights, ctx.device = task, lights, tensors[0].device
        gradient = task.pullback(_arrays(tensors[:lights]), _arrays(tensors[lights:]))
        return _tensors(gradient, ctx.device)

    @staticmethod
    def backward(ctx: Any, *directions: torch.Tensor) -> Any:
        if not ctx.task.is_linear:
            raise RuntimeError("the second derivative of this dose model is not known; accepted: first derivatives, or a linear model (Task.is_linear)")
        return (None, None, *[None] * ctx.lights, *_Dose.apply(ctx.task, *directions))


def _arrays(tensors: Sequence[torch.Tensor]) -> list[Any]:
    return [tensor.detach().cpu().numpy() for tensor in tensors]


def _tensors(arrays: Any, device: torch.device) -> tuple[torch.Tensor, ...]:
    arrays = arrays if isinstance(arrays, list) else [arrays]
    return tuple(torch.from_numpy(array).to(device) for array in arrays)


def dose(task: Task, patterns: Any) -> Any:
    """F of a `Task`: a tensor `[frame, row, column]` → a tensor `[z, y, x]`, float32; lists of them where there are several lights or species.

    Tensors of a graphics card are copied to the processor, where the model computes, and back. Errors are those of `Task.dose`.
    """
    lights = patterns if isinstance(patterns, (list, tuple)) else [patterns]
    doses = _Dose.apply(task, *(light.to(torch.float32) for light in lights))
    return doses[0] if len(doses) == 1 else list(doses)


class Dose(torch.nn.Module):
    """`dose` of one task as a module without parameters."""

    def __init__(self, task: Task) -> None:
        super().__init__()
        self.task = task

    def forward(self, patterns: Any) -> Any:
        """Patterns → dose, as `dose`."""
        return dose(self.task, patterns)
