"""The one place that decides how kernels are compiled, and how one reaches a law by its type."""

import contextlib
import functools
from collections.abc import Callable
from typing import Any

import numba
from numba import types
from numba.extending import overload, register_jitable

from .cache import CheckedCache
from .linking import PartCompiler

FLAGS = {
    "nogil": True,  # a scheduler must be able to talk to a worker while a kernel runs
    "no_cfunc_wrapper": True,  # nobody calls them from C; a tenth of the time to compile
    "error_model": "numpy",  # division by zero gives inf as in numpy, loops stay vectorizable
    "_nrt": True,  # said, or it would be as in the caller that is compiled first
}

PART = {**FLAGS, "no_cpython_wrapper": True, "pipeline_class": PartCompiler}
BORROWING = {**PART, "_nrt": False}


def kernel(function: Callable) -> Callable:
    """Compile a function, or leave it as it is under NUMBA_DISABLE_JIT=1."""
    return _compiled(function, PART)


def borrowing(function: Callable) -> Callable:
    """Compile a function that neither makes an array nor returns one: what it is given outlives it.

    It counts no references. To count those of all arrays of some NamedTuples takes as long as to
    step hundreds of elements. Numba raises an error where an array is made after all.
    """
    return _compiled(function, BORROWING)


def inlined(function: Callable) -> Callable:
    """Compile a ``borrowing`` function into each that calls it, however long it is.

    To hand over many arrays takes longer than short loops. Long ones are quicker by themselves.
    """
    return _compiled(function, BORROWING | {"forceinline": True})


def _compiled(function: Callable, options: dict[str, Any]) -> Callable:
    compiled = numba.njit(**FLAGS | {"_nrt": options["_nrt"]})(function)
    if compiled is not function:  # Python calls it as usual, kernels link its part in
        part = numba.njit(**options)(function)
        compiled.get_call_template = _by_types_alone(part.get_call_template)
        compiled.get_overload = part.get_overload
        with contextlib.suppress(RuntimeError):  # no folder at all can be written
            compiled._cache = CheckedCache(function)
    return compiled


def either_way(function: Callable) -> Callable:
    """Leave a function to Python as it is; kernels that call it compile it.

    So it reaches arguments that are not compiled as well, and does not cross to machine code and
    back within one call.
    """
    return register_jitable(**PART)(function)


def _by_types_alone(template_of: Callable) -> Callable:
    """Return how numba finds what is called, for the types of arguments and not their values.

    It would compile a function anew for every constant it is called with, and for those with which
    a variable only begins: a fifth of all that a study compiles, and the machine code no quicker.
    """

    def found(arguments: Any, keywords: dict[str, Any]) -> Any:
        general = {name: types.unliteral(kind) for name, kind in keywords.items()}
        return template_of([types.unliteral(kind) for kind in arguments], general)

    return found


class by_type:
    """A function of which every NamedTuple type of its first argument has its own body.

    It decorates a declaration, which gives the name, the arguments and what the function is
    for; ``.of(type)`` decorates a body. Kernels are compiled for the types they are called with:
    a body of another type is not in their machine code. A jitted function as an argument would
    do the same, but numba finds no kernel with one in its cache. Bodies belong in files of this
    package, whose hash tells states of the cache apart. Raises TypeError for a type without one.
    """

    def __init__(self, declared: Callable, counts: bool = True) -> None:
        functools.update_wrapper(self, declared)
        self.name = declared.__name__
        self.bodies: dict[Any, Callable] = {}

        @overload(self, jit_options=PART if counts else BORROWING)
        @functools.wraps(declared)
        def compiled(first: Any, *others: Any) -> Callable | None:
            return self.bodies.get(getattr(first, "instance_class", None))

    @classmethod
    def borrowing(cls, declared: Callable) -> "by_type":
        """Decorate a declaration whose bodies are all as ``borrowing`` functions."""
        return cls(declared, counts=False)

    def __call__(self, first: Any, *others: Any) -> Any:
        """Run the body for the type of ``first``, as compiled kernels do by themselves."""
        if type(first) not in self.bodies:
            raise TypeError(f"{self.name} is not defined for {type(first).__name__}")
        return self.bodies[type(first)](first, *others)

    def of(self, kind: type) -> Callable[[Callable], Callable]:
        """Return a decorator that makes a function the body for a type."""

        def register(body: Callable) -> Callable:
            self.bodies[kind] = body
            return body

        return register
