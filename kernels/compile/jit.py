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

NUMBA_OPTIONS = {
    "nogil": True,  # a scheduler must be able to talk to a worker while a kernel runs
    "no_cfunc_wrapper": True,  # nobody calls them from C; a tenth of the time to compile
    "error_model": "numpy",  # division by zero gives inf as in numpy, loops stay vectorizable
    "_nrt": True,  # said, or it would be as in the caller that is compiled first
}

PART = {**NUMBA_OPTIONS, "no_cpython_wrapper": True, "pipeline_class": PartCompiler}
BORROWING = {**PART, "_nrt": False}


def kernel(function: Callable) -> Callable:
    """Compile a function, or leave it as it is under NUMBA_DISABLE_JIT=1."""
    return _compiled(function, PART)


def refcount_free_kernel(function: Callable) -> Callable:
    """Compile a function that neither makes an array nor returns one: what it is given outlives it.

    It counts no references. To count those of all arrays of some NamedTuples takes as long as to
    step hundreds of elements. Numba raises an error where an array is made after all.
    """
    return _compiled(function, BORROWING)


def inlined_kernel(function: Callable) -> Callable:
    """Compile a ``refcount_free_kernel`` function into each that calls it, however long it is.

    To hand over many arrays takes longer than short loops. Long ones are quicker by themselves.
    """
    return _compiled(function, BORROWING | {"forceinline": True})


def _compiled(function: Callable, options: dict[str, Any]) -> Callable:
    compiled = numba.njit(**NUMBA_OPTIONS | {"_nrt": options["_nrt"]})(function)
    if compiled is not function:  # Python calls it as usual, kernels link its part in
        part = numba.njit(**options)(function)
        compiled.get_call_template = _by_types_alone(part.get_call_template)
        compiled.get_overload = part.get_overload
        with contextlib.suppress(RuntimeError):  # no folder at all can be written
            compiled._cache = CheckedCache(function)
    return compiled


def jitable(function: Callable) -> Callable:
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


class dispatch_on_type:
    """Function with a separate body for each NamedTuple type of its first argument.

    It decorates a declaration, which gives the name, the arguments and the docstring;
    ``.register(type)`` decorates a body, as in functools.singledispatch. A kernel is compiled for
    the types it is called with, so bodies of other types leave nothing in its machine code. A
    jitted function passed as an argument would do the same, but numba does not find kernels with
    such arguments in its cache. Bodies belong in files of this package: the cache folder carries a
    hash of these files. Raises TypeError for a type without a body.
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
    def refcount_free(cls, declared: Callable) -> "dispatch_on_type":
        """Decorate a declaration whose bodies are all as ``refcount_free_kernel`` functions."""
        return cls(declared, counts=False)

    def __call__(self, first: Any, *others: Any) -> Any:
        """Run the body for the type of ``first``, as compiled kernels do by themselves."""
        if type(first) not in self.bodies:
            raise TypeError(f"{self.name} is not defined for {type(first).__name__}")
        return self.bodies[type(first)](first, *others)

    def register(self, argument_type: type) -> Callable[[Callable], Callable]:
        """Return a decorator that makes a function the body for a type."""

        def add(body: Callable) -> Callable:
            self.bodies[argument_type] = body
            return body

        return add
