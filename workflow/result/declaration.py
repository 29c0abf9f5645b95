"""How a variable of a result file is declared: meaning, scaling to SI, units, dims."""

from typing import NamedTuple

from ..study import AXES

GRID = AXES
CURVE = (*AXES, "sample")
PER_HURST = ("hurst",)

# By which powers of axes of the grid, of 4 G L ("stiffness") and of tau a dimensionless value is
# multiplied.
Powers = dict[str, int]

PLAIN: Powers = {}
HEIGHT: Powers = {"roughness": 1}
SLOPE: Powers = {"roughness": 1, "spacing": -1}
FLAG, COUNT = "int8", "int32"

ERRORS = "value +- t * error, t of Student with degrees_of_freedom, is an interval of confidence"
SIGN_OF_D = (
    "positive where the mean line lies below the undeformed surface of the elastomer; negative "
    "where only peaks touch, as at light loads"
)
BIAS = (
    "9 in 10 problems keep it (docs/accuracy.md); no standard error shows it; NaN: not known for "
    "materials with branches, programmes and prescribed indentation"
)


class Variable(NamedTuple):
    """Declaration of one variable."""

    long_name: str
    scaling: Powers = PLAIN  # from the plan's units to SI
    units: str = "1"
    dims: tuple[str, ...] = GRID
    comment: str = ""
    dtype: str = "float64"
