"""How kernels are compiled that other kernels call: once, as a part of what calls them.

By itself numba makes machine code of every function, gives it a way in from Python, and keeps both
on the disk, for one that only kernels call too. Here such a kernel is translated and optimised, so
that it can be linked into its callers, and no more.
"""

from typing import Any

from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler


class _Part(JITCodeLibrary):
    """Code that never runs by itself: it is linked into that of its callers."""

    def _optimize_final_module(self) -> None:
        """Optimise it once: the cheap pass that numba begins with is due in what it is linked into.

        Without any, or before others are linked into it, kernels are up to a fifth slower.
        """
        made = self._codegen._module_pass_manager()
        passes, *builder = made if isinstance(made, tuple) else (made,)  # alone before numba 0.62
        passes.run(self._final_module, *builder)

    def _finalize_final_module(self) -> None:
        """Make no machine code."""
        self._finalized = True

    @property
    def codegen(self) -> Any:
        """Return who would be told of the environment of the machine code."""
        return _Nobody

    def get_pointer_to_function(self, name: str) -> int:
        """Return that there is no machine code."""
        return 0


class _Nobody:
    @staticmethod
    def set_env(name: str, environment: Any) -> None:
        """Take no note."""


class PartCompiler(Compiler):
    """Compiles what kernels call."""

    def compile_extra(self, function: Any) -> Any:
        """Compile a function into code of the kind above."""
        self.state.library = _Part(self.state.targetctx.codegen(), function.__qualname__)
        return super().compile_extra(function)
