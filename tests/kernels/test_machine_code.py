"""Machine code contains no effects or recorders that are not requested."""

import ast
import inspect
import json
import textwrap

import numpy as np
import pytest

from elastomer_friction.kernels import ConstantForce
from elastomer_friction.kernels.body.element_line import element_line
from elastomer_friction.kernels.motion.legs import Slide, steps_of
from elastomer_friction.kernels.motion.track import tracks
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.scene.initial_state import relaxed_elements
from elastomer_friction.kernels.scene.march_body import march_track
from elastomer_friction.kernels.scene.records import Trace
from tests.kernels.listing import instructions
from tests.kernels.scene.given import SOLID, a_line
from tests.sizes import PLAIN_PYTHON
from tests.support.python import printed

RECORDERS = ("trace", "energies", "lengths", "snapshots", "window")
EFFECTS = (
    "elastomer_friction.kernels.control.indentation",
    "elastomer_friction.kernels.control.printed_eq3",
    "elastomer_friction.kernels.branches.steady_memory",
    "elastomer_friction.kernels.rheology.relaxed",
    "elastomer_friction.kernels.scene.run",
    "elastomer_friction.kernels.lines.measured_modes",
)
pytestmark = [
    pytest.mark.exhaustive,
    pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: there is no machine code"),
]


def listing(loaded, cache):
    """Return the output of tests.kernels.listing for kernels compiled with an empty cache."""
    return json.loads(printed("-m", "tests.kernels.listing", loaded, NUMBA_CACHE_DIR=str(cache)))


def test_effects_that_are_there_but_off_leave_nothing_in_the_machine_code(tmp_path):
    """Compare the march, the steady state and march_line without and with all other files."""
    bare, whole = (listing(loaded, tmp_path / loaded) for loaded in ("bare", "whole"))
    assert not set(EFFECTS) & set(bare["modules"])
    assert set(EFFECTS) <= set(whole["modules"])
    for name, (count, _) in bare["kernels"].items():
        assert count > 1000
        assert whole["kernels"][name][0] == pytest.approx(count, rel=0.02)


class WithoutRecorders(ast.NodeTransformer):
    """Transformer that removes recorders and decorators from ``march_track``."""

    def visit_FunctionDef(self, node):
        node.decorator_list = []
        return self.generic_visit(node)

    def visit_If(self, node):
        names = {n.id for n in ast.walk(node.test) if isinstance(n, ast.Name)}
        is_off = names & set(RECORDERS) or names == {"is_averaged"}
        return None if is_off else self.generic_visit(node)

    def visit_BoolOp(self, node):
        names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
        return ast.Constant(False) if names & set(RECORDERS) else self.generic_visit(node)


def test_recorders_that_are_off_leave_nothing_in_the_machine_code():
    function = march_track
    tree = WithoutRecorders().visit(ast.parse(textwrap.dedent(inspect.getsource(function))))
    assert not set(RECORDERS) & {
        n.id for n in ast.walk(tree) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)
    }
    names = dict(function.__globals__)
    exec(compile(ast.fix_missing_locations(tree), "<stripped>", "exec"), names)
    line = a_line(10)
    form, control = FORMS_BY_SCHEME["exponential"](SOLID), ConstantForce(0.3 * line.z.size)
    (track,) = tracks(line.z, line.slope, 4, steps_of((Slide(1.0, 1.0),), 4), 0.0, 0.0)
    elements = relaxed_elements(form, line.z, control.load, np.nan)
    none = np.arange(0)
    body = element_line(form, control, track, elements)
    arguments = (*body, track, 0, none, none, none, None, None, None, None, None)
    stripped = len(instructions(names["march_track"], *arguments))
    assert len(instructions(function, *arguments)) <= 1.02 * stripped
    trace = Trace(*np.empty((len(Trace._fields), 0)))
    assert len(instructions(function, *arguments[:7], trace, *arguments[8:])) > 1.05 * stripped
