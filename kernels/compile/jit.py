"""Decorators of kernels: compilation, linking into callers, and dispatch on an argument's type.

A kernel called by another kernel is linked into its caller and optimised there. If numba lacks the
private names below, it compiles in a slower way.
"""

import functools
import gc
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numba
from numba import types
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler
from numba.core.options import DefaultOptions
from numba.extending import overload, register_jitable

from . import cache


class _LinkedLibrary(JITCodeLibrary):
    """Code without an entry point, to be optimised and compiled in that of its callers."""

    codegen = SimpleNamespace(set_env=lambda name, environment: None)  # for machine code only

    def _optimize_final_module(self) -> None: ...

    def _finalize_final_module(self) -> None:
        if hasattr(self, "_finalized"):
            self._finalized = True  # without generating machine code
        else:
            super()._finalize_final_module()

    def get_pointer_to_function(self, name: str) -> int:
        return 0  # Python never calls this code


class _EntryCompiler(Compiler):
    """Compiler of a kernel for Python, and without entry points of all that it calls."""

    def compile_extra(self, func: Any) -> Any:
        codegen, collects = self.state.targetctx.codegen(), gc.isenabled()
        self.state.library = codegen.create_library(func.__qualname__)
        self.state.library.enable_object_caching()
        codegen._library_class = _LinkedLibrary  # of all that is compiled meanwhile
        gc.disable()  # collection takes a sixth of the compile time
        try:
            return super().compile_extra(func)
        finally:
            del codegen._library_class
            (gc.enable if collects else gc.disable)()


NUMBA_OPTIONS = {
    "nogil": True,  # a scheduler must be able to reach a worker while a kernel runs
    "no_cfunc_wrapper": True,  # kernels are not called from C; saves a tenth of the compile time
    "error_model": "numpy",  # division by zero gives inf as in numpy, loops stay vectorizable
}
UNCOUNTED: dict[str, Any] = {}  # without reference counts, which cost as much as many elements
if hasattr(DefaultOptions, "_nrt"):
    NUMBA_OPTIONS["_nrt"], UNCOUNTED["_nrt"] = True, False  # whichever caller is compiled first
INLINED = UNCOUNTED | {"forceinline": True}
LINKED = NUMBA_OPTIONS | {"no_cpython_wrapper": True}
ENTRY = NUMBA_OPTIONS | {"pipeline_class": _EntryCompiler}


def kernel(function: Callable, **options: bool) -> Callable:
    """Compile a function. With NUMBA_DISABLE_JIT=1 this decorator and those below do nothing."""
    compiled = numba.njit(**ENTRY | UNCOUNTED if options else ENTRY)(function)
    if compiled is not function:
        linked = numba.njit(**LINKED | options)(function)

        def call_template(arguments: Any, keywords: dict[str, Any]) -> Any:
            # Specializing for constant arguments takes a fifth more time and gains no speed.
            general = {name: types.unliteral(kind) for name, kind in keywords.items()}
            return linked.get_call_template([types.unliteral(k) for k in arguments], general)

        compiled.get_call_template = call_template
        compiled.get_overload = linked.get_overload
        if not hasattr(compiled, "_cache"):
            numba.config.CACHE_DIR = cache.CACHE_FOLDER
            compiled.enable_caching()
        elif function.__closure__ is None and Path(function.__code__.co_filename).is_file():
            compiled._cache = cache.KernelCache(function)
    return compiled


def refcount_free_kernel(function: Callable) -> Callable:
    """Compile a function without reference counts; it must not create or return an array."""
    return kernel(function, **UNCOUNTED)


def inlined_kernel(function: Callable) -> Callable:
    """Compile a refcount-free function into its callers; long loops are faster if not inlined."""
    return kernel(function, **INLINED)


def jitable(function: Callable) -> Callable:
    """Allow kernels to call a function; Python calls it uncompiled, with arguments of any type."""
    return register_jitable(**LINKED)(function)


class dispatch_on_type:
    """Function with a separate body for each NamedTuple type of its first argument.

    It decorates a declaration and ``.register(type)`` a body, as in functools.singledispatch. Only
    bodies for the types of a call are compiled. They must be in this package (cache.source_hash).
    """

    def __init__(self, declaration: Callable, **options: bool) -> None:
        functools.update_wrapper(self, declaration)
        self.name = declaration.__name__
        self.bodies: dict[Any, Callable] = {}

        @overload(self, jit_options=LINKED | options)
        @functools.wraps(declaration)
        def body_of(first: Any, *others: Any) -> Callable | None:
            return self.bodies.get(getattr(first, "instance_class", None))

    def __call__(self, first: Any, *others: Any) -> Any:
        """Run the body for the type of ``first``. Raises TypeError for types without one."""
        if type(first) not in self.bodies:
            raise TypeError(f"{self.name} is not defined for {type(first).__name__}")
        return self.bodies[type(first)](first, *others)

    def register(self, argument_type: type) -> Callable[[Callable], Callable]:
        """Return a decorator that registers a function as the body for a type."""
        return functools.partial(self.bodies.setdefault, argument_type)


dispatch_refcount_free: Callable[..., Any] = functools.partial(dispatch_on_type, **UNCOUNTED)
dispatch_inlined: Callable[..., Any] = functools.partial(dispatch_on_type, **INLINED)
