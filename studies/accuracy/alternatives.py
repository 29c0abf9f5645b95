"""The alternatives: time marches of the whole line, from rest, with a search for d each step.

Implicit Euler on the same samples as the kernels: at equal m they must give equal numbers. What
differs is how: no steady solver, no exact jump, every element at every step. Errors and times are
those of the kernels at the points of the study.
"""

import contextlib
import math
import time
from collections.abc import Callable

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from elastomer_friction.kernels import Line

from .discretisation import climb, ladder_steps, over_points, reference
from .points import RATIO, Point, RandomLine, surface
from .sampling import LineRuns, Method, collected, kept_steps_of

SPIN_UP = 10.0  # what is left of the start is e^-10; implicit Euler: a factor 1 + dt a step
SLOWER = {"tamaas": 10.0}  # than the others, per update: fewer steps per dx in the same time
SEARCH = 1e-13  # width in h at which a search for d ends
WARM = Point(0.5, 0.3, 1.0)
TEXTS = {
    "error": ("rms error over lines, relative", "1"),
    "seconds": ("CPU time per realization, median", "s"),
}


class NumpyMarch:
    """Plain numpy: arrays over the whole line, a library root finder for d."""

    def __init__(self, line: Line, load: float) -> None:
        self.line, self.load = line, load
        self.u = np.zeros(line.z.size)  # in the frame of the line

    def advance(self, steps: int, dt: float) -> np.ndarray:
        """Move the line by ``steps`` samples in steps of dt (tau); return mu of each, in h/dx."""
        z, slope = self.line.z, self.line.slope
        decay, stiffness = 1.0 / (1.0 + dt), 1.0 + 1.0 / dt
        mu = np.empty(steps)
        for step in range(steps):
            free = decay * np.roll(self.u, -1)
            reach = free - z
            target = self.load / stiffness * z.size
            low = -reach.max()

            def excess(d, reach=reach, target=target):
                return np.maximum(reach + d, 0.0).sum() - target

            d = brentq(excess, low, low + target, xtol=SEARCH)
            force = np.maximum(reach + d, 0.0)
            self.u = free - force
            mu[step] = (force * slope).sum() / force.sum()  # not @: one thread only
        return mu


class TamaasMarch:
    """The package tamaas as Winkler foundation with one Maxwell branch tau_1 << dt.

    The backward Euler step of the branch is then that of a Kelvin element. Its tolerance makes
    the numbers agree to about 1e-7. Raises ImportError where tamaas is not installed, and
    ArithmeticError where it fails: with one touching element only.
    """

    BRANCH = 1e-8  # tau_1 / tau
    TOLERANCE = 1e-10
    OPERATOR = "Westergaard::neumann"

    def __init__(self, line: Line, load: float) -> None:
        import tamaas

        tamaas.set_log_level(tamaas.LogLevel.error)
        self.load, self.surface, self.slope = load, -line.z, line.slope.copy()
        self.model = tamaas.Model(tamaas.model_type.basic_1d, [1.0], [line.z.size])
        self.model.nu, self.model.E = 0.0, 2.0  # shear modulus 1
        self.model.be_engine.registerNeumann()
        self.solver = tamaas.MaxwellViscoelastic(
            self.model, self.surface, self.TOLERANCE, 1.0, [1.0 / self.BRANCH], [self.BRANCH]
        )
        self.solver.setIntegralOperator(self.OPERATOR)
        self.model.operators[self.OPERATOR]["influence"][...] = 1.0  # u = p: springs

    def advance(self, steps: int, dt: float) -> np.ndarray:
        """Move the line by ``steps`` samples in steps of dt (tau); return mu of each, in h/dx."""
        self.solver.time_step = dt
        mu = np.empty(steps)
        for step in range(steps):
            self.surface[:] = np.roll(self.surface, 1)
            self.slope = np.roll(self.slope, 1)
            self.solver.solve(self.load)
            pressure = self.model.traction
            mu[step] = (pressure * self.slope).sum() / pressure.sum()
        return mu


MARCHES: dict[str, type[NumpyMarch] | type[TamaasMarch]]
MARCHES = {"numpy": NumpyMarch, "tamaas": TamaasMarch}
SOLVERS = ("kernels", *MARCHES)


def affordable(name: str, point: Point, elements: int, updates: float) -> float:
    """Return up to which m a march takes at most ``updates`` updates; at least 1."""
    most = math.sqrt(updates / SLOWER.get(name, 1.0) / (2.0 * SPIN_UP * point.speed * elements))
    return max(most, 1.0)


def run_march(point: Point, surfaces: list[RandomLine], method: Method) -> LineRuns:
    """March from rest to steady sliding at v1, then at v2, and read off what the kernels give.

    mu_1 and mu_2 are what friction ends at, the jump is its change over the first step. method :
    its scheme is one of MARCHES.
    """
    own = method._replace(scheme="implicit-euler")
    kept_steps, moments = kept_steps_of(point, surfaces[0].elements, own)
    steps_per_tau = method.steps * point.speed  # steps per tau at v1
    first, second = (
        math.ceil(SPIN_UP / math.log1p(1.0 / p)) for p in (steps_per_tau, steps_per_tau * RATIO)
    )
    rows = []
    for one in surfaces:
        began = time.process_time()
        line = Line.self_affine(*one, method.steps)
        drawn = time.process_time()
        march = MARCHES[method.scheme](line, point.load)
        before = march.advance(first, 1.0 / steps_per_tau)
        steady = time.process_time()
        after = march.advance(max(second, int(kept_steps[-1])), 1.0 / (steps_per_tau * RATIO))
        cpu = np.array([drawn - began, steady - drawn, time.process_time() - drawn])
        mu_1 = before[-1]
        rows.append((mu_1, after[-1], after[0] - mu_1, after[kept_steps - 1], cpu))
    return collected(rows, moments, surfaces[0])


def alternatives(
    points: tuple[Point, ...], settings: dict, seed: int, advance: Callable[[], None]
) -> xr.Dataset:
    """Return errors and times of all methods on the same lines, over (compared, solver, tried).

    Points and steps per spacing are fewer than those of the ladders, and named otherwise: groups
    of one file share the dimensions of its root. Error and time are missing where a method is not
    installed, fails or would take too long.
    """
    elements, finest = settings["elements"], settings["finest"]
    every = max((ladder_steps(point, finest) for point in points), key=len)
    for name in MARCHES:
        with contextlib.suppress(ImportError):  # load everything before it is timed
            run_march(WARM, [surface(WARM, 64, seed, i) for i in range(2)], Method(name, 2))
    found = []
    for point in points:
        surfaces = [surface(point, elements, seed, i) for i in range(settings["march_lines"])]
        limit = reference(point, surfaces, finest)
        steps = ladder_steps(point, finest)
        ways = [climb(point, surfaces, "exponential", steps, limit)[list(TEXTS)]]
        for name in MARCHES:
            most = affordable(name, point, elements, settings["march_updates"])
            few = [m for m in every if m <= most]
            ways.append(climb(point, surfaces, name, few, limit, run=run_march)[list(TEXTS)])
        found.append(xr.concat(ways, "solver", join="outer"))
        advance()
    data = over_points(found, points, TEXTS).assign_coords(solver=list(SOLVERS))
    return data.rename(point="compared", steps="tried")
