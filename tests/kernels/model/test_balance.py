"""The choice of a control by its type: code is there only where it is asked for."""

from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, PrintedForce, march, steady_sliding
from tests.lines import random_line
from tests.sizes import PLAIN_PYTHON


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nothing compiled")
def test_a_control_that_is_off_is_not_in_the_machine_code():
    """The names of all functions can be read in it, whether they are inlined or not."""
    law = SCHEMES["exponential"](0.5)
    z, slope = random_line(20, 0.7, 1, seed=2)
    start, _ = steady_sliding(law, z, 2.0)
    for control in (ConstantForce, PrintedForce):
        march(law, control(2.0), z, slope, start, np.array([3]), np.inf)
    file, code = march._cache._cache_file, {}
    for ((_, control, *_), *_), name in file._load_index().items():
        code[control.instance_class] = Path(file._data_path(name)).read_bytes()
    for name in (b"printed_eq3", b"weighted_overlap"):  # in a march nothing else needs the second
        assert name not in code[ConstantForce]
        assert name in code[PrintedForce]
