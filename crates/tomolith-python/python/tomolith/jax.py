"""A job's dose model as a function of JAX, with its exact derivative. Needs JAX.

    dose = tomolith.jax.dose(task)
    gradient = jax.grad(lambda patterns: own_loss(dose(patterns)))(task.start)
"""

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from ._native import Task


def dose(task: Task) -> Callable[[Any], Any]:
    """F of a `Task`: patterns `[frame, row, column]` → dose `[z, y, x]`, float32; lists of them where there are several lights or species.

    It works under `jax.grad` (reverse mode), `jax.vjp` and `jax.jit`; the model itself computes on the processor. Errors are those of `Task.dose`, in the text of a `jax.errors.JaxRuntimeError`.
    """
    volume = jnp.zeros(task.shape, jnp.float32)
    volumes = [volume] * len(task.outputs) if len(task.outputs) > 1 else volume

    def of_numpy(call: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *arguments: call(*jax.tree.map(np.asarray, arguments))

    @jax.custom_vjp
    def model(patterns: Any) -> Any:
        return jax.pure_callback(of_numpy(task.dose), volumes, patterns)

    def forward(patterns: Any) -> Any:
        return model(patterns), patterns

    def backward(patterns: Any, cotangent: Any) -> Any:
        return (jax.pure_callback(of_numpy(task.pullback), patterns, patterns, cotangent),)

    model.defvjp(forward, backward)
    return lambda patterns: model(jax.tree.map(lambda p: jnp.asarray(p, jnp.float32), patterns))
