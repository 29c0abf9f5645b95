"""The one place that decides how kernels are compiled, and how one reaches a law by its type."""

import contextlib
import functools
from collections.abc import Callable
from typing import Any

import numba
from numba.extending import overload

from kernels.cache import CheckedCache

FLAGS = {
    "nogil": True,  # a scheduler must be able to talk to a worker while a kernel runs
    "error_model": "numpy",  # division by zero gives inf as in numpy, loops stay vectorizable
}


def kernel(function: Callable) -> Callable:
    """Compile a function, or leave it as it is under NUMBA_DISABLE_JIT=1."""
    compiled = numba.njit(**FLAGS)(function)
    if compiled is not function:
        with contextlib.suppress(RuntimeError):  # no folder at all can be written
            compiled._cache = CheckedCache(function)
    return compiled


def by_type(declared: Callable) -> Callable:
    """Make a function of which every NamedTuple type of its first argument has its own body.

    ``declared`` gives the name, the arguments and what the function is for, ``.of(type)``
    decorates a body. Kernels are compiled for the types they are called with: a body of another
    type is not in their machine code. A jitted function as an argument would do the same, but
    numba finds no kernel with one in its cache. Bodies belong in files of this package, whose
    hash tells states of the cache apart. Raises TypeError for a type without a body.
    """
    bodies: dict[type, Callable] = {}

    @functools.wraps(declared)
    def plain(first: Any, *others: Any) -> Any:
        if type(first) not in bodies:
            raise TypeError(f"{declared.__name__} is not defined for {type(first).__name__}")
        return bodies[type(first)](first, *others)

    @overload(plain, jit_options=FLAGS)
    @functools.wraps(declared)
    def compiled(first: Any, *others: Any) -> Callable | None:
        return bodies.get(getattr(first, "instance_class", None))

    def of(kind: type) -> Callable:
        def register(body: Callable) -> Callable:
            bodies[kind] = body
            return body

        return register

    plain.bodies, plain.of = bodies, of
    return plain
