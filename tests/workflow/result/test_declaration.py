"""What a declaration holds where nothing is said: a number of one point of the grid."""

from elastomer_friction.workflow.result.declaration import GRID, Variable
from elastomer_friction.workflow.study.axes import AXES


def test_a_variable_is_a_number_at_each_point_by_default():
    variable = Variable("what it means")
    assert variable.dims == GRID == AXES
    assert (variable.units, variable.dtype, dict(variable.scaling)) == ("1", "float64", {})
