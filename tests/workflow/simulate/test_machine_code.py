"""All machine code of a batch is loaded before its time counts."""

import subprocess
import sys

import numba
import pytest

NOTHING_NEW = """
import sys, types
from numba.core.dispatcher import Dispatcher
from tests.support.small import cut_batches, small_plan
from elastomer_friction.workflow.simulate.realizations import block_means, load_kernels

def compiled():
    found = {}
    for name, module in list(sys.modules.items()):
        if name.startswith("elastomer_friction.kernels"):
            for own in vars(module).values():
                if isinstance(own, Dispatcher):
                    found[own.py_func.__qualname__] = len(own.signatures)
    return found

wide = ["grid.hurst=[0.0, 0.7]", "grid.normal_force=[0.004, 0.04, 0.4, 40.0]",
        "grid.velocity=[0.03, 0.3, 3.0, 30.0]", "study.realizations=8"]
for batch in cut_batches(small_plan(*wide), set(), 1e9):
    load_kernels(batch.scheme, batch.quantities)
    before = compiled()
    block_means(batch)
    after = compiled()
    assert len(before) > 20
    new = {name for name in after if after[name] != before.get(name)}
    assert not new, new
"""


@pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")
def test_a_batch_needs_no_machine_code_but_what_was_loaded_before_it():
    """Or else the time to compile it would count as that of the work."""
    done = subprocess.run([sys.executable, "-c", NOTHING_NEW], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
