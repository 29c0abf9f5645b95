"""Print counts and digests of the machine code of kernels, with all effects loaded or none.

    python -m tests.kernels.listing bare|whole

Names of functions and addresses of constants are masked because they contain hashes.
"""

import hashlib
import json
import re
import sys
import types
from collections.abc import Callable

import numba
import numpy as np


def instructions(function: Callable, *arguments: object) -> list[str]:
    """Return the machine instructions of a kernel, compiled for arguments of these types."""
    from elastomer_friction.kernels.compile.jit import NUMBA_OPTIONS

    compiled = numba.njit(**NUMBA_OPTIONS)(getattr(function, "py_func", function))
    compiled(*arguments)
    (assembly,) = compiled.inspect_asm().values()
    lines = [line for line in assembly.splitlines() if re.match(r"\t[^.]", line)]
    return [re.sub(r'"?[\w.-]*(_Z|\.bytes\.|\.L)[\w.$-]*"?', "NAME", line) for line in lines]


def listings() -> dict[str, list[str]]:
    """Return the instructions of kernels with every effect off, by name."""
    from elastomer_friction.kernels.body.element_line import element_line
    from elastomer_friction.kernels.model.force import ConstantForce
    from elastomer_friction.kernels.model.march import march
    from elastomer_friction.kernels.model.steady import steady_sliding
    from elastomer_friction.kernels.motion.track import Track
    from elastomer_friction.kernels.rheology.kelvin import SCHEMES
    from elastomer_friction.kernels.rheology.law import Elements, State
    from elastomer_friction.kernels.rheology.prony import PRONY_SCHEME
    from elastomer_friction.kernels.rheology.retardation import retardation
    from elastomer_friction.kernels.rheology.spectrum import KELVIN
    from elastomer_friction.kernels.scene.march_body import march_line

    z, kelvin, control = (
        np.array([3.0, 1.0, 0.0, 2.0]),
        SCHEMES[PRONY_SCHEME](0.3),
        ConstantForce(4.0),
    )
    state = State(np.zeros(4), 2.0)
    twice, steps = np.tile(z, (1, 2)), np.zeros(2, np.int64)
    track = Track(twice, twice, steps, steps, np.ones(1), np.ones(2), np.ones(2))
    elements, none = Elements(np.zeros((1, 4)), np.zeros(4), 2.0), np.arange(0)
    body = element_line(retardation(KELVIN), control, track, elements)
    off = (0, none, none, none, None, None, None, None, None)
    return {
        "steady_sliding": instructions(steady_sliding, kelvin, z, 4.0),
        "march": instructions(march, kelvin, control, z, z, state, np.array([2]), 4.0),
        "march_line": instructions(march_line, *body, track, *off),
    }


def main(loaded: str) -> None:
    """Print the listings as JSON; with "bare", import only the modules that they need."""
    if loaded == "bare":
        for name in ("", ".kernels", ".kernels.scene"):
            name = f"elastomer_friction{name}"
            package = types.ModuleType(name)
            package.__path__ = [name.replace(".", "/")]
            sys.modules[name] = package
    else:
        from elastomer_friction import kernels  # noqa: F401
    actual = {
        name: (len(lines), hashlib.sha256("\n".join(lines).encode()).hexdigest())
        for name, lines in listings().items()
    }
    modules = sorted(name for name in sys.modules if name.startswith("elastomer_friction.kernels."))
    print(json.dumps({"kernels": actual, "modules": modules}))


if __name__ == "__main__":
    main(sys.argv[1])
