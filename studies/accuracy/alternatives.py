"""Alternative methods: marches of the whole line from rest, with a root search for d each step.

They use implicit Euler on the same samples as the kernels and give equal numbers at equal m, but
have no steady solver and no exact jump, and move all elements at every step. Errors and times are
measured at the points of the study.
"""

import math
import time
from collections.abc import Callable

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from elastomer_friction.kernels import Line

from .discretisation import climb, ladder_steps, over_points, reference, warm_up
from .points import RATIO, Point, RandomLine, surface
from .sampling import LineRuns, Method, collected, kept_steps_of

SPIN_UP = 10.0  # e-foldings of the initial state; implicit Euler decays by 1 + dt per step
RELATIVE_COST = {"tamaas": 10.0}  # time of an update over that of numpy; limits m
D_TOLERANCE = 1e-13  # of the search for d, in h
TEXTS = {
    "error": ("rms error over lines, relative", "1"),
    "seconds": ("CPU time per realization, median", "s"),
}


class NumpyMarch:
    """March in numpy with arrays over the whole line and a library root finder for d."""

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

            d = brentq(excess, low, low + target, xtol=D_TOLERANCE)
            force = np.maximum(reach + d, 0.0)
            self.u = free - force
            # Not by @, which may use several threads.
            mu[step] = (force * slope).sum() / force.sum()
        return mu


class TamaasMarch:
    """March with tamaas: a Winkler foundation with one Maxwell branch tau_1 << dt.

    The backward Euler step of the branch equals that of a Kelvin element to about 1e-7, the effect
    of TOLERANCE. Raises ImportError if tamaas is not installed, and ArithmeticError if it fails, as
    it does with a single touching element.
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
    """Return the largest m at which a march takes at most ``updates`` updates, at least 1."""
    most = math.sqrt(
        updates / RELATIVE_COST.get(name, 1.0) / (2.0 * SPIN_UP * point.speed * elements)
    )
    return max(most, 1.0)


def run_march(point: Point, surfaces: list[RandomLine], method: Method) -> LineRuns:
    """March from rest to steady sliding at v1, then at v2, and return the kernels' quantities.

    mu_1 and mu_2 are the final friction at v1 and v2, and the jump is the change over the first
    step at v2. method : its scheme is a key of MARCHES.
    """
    euler = method._replace(scheme="implicit-euler")
    kept_steps, moments = kept_steps_of(point, surfaces[0].elements, euler)
    steps_per_tau = method.steps * point.speed  # steps per tau at v1
    first, second = (
        math.ceil(SPIN_UP / math.log1p(1.0 / p)) for p in (steps_per_tau, steps_per_tau * RATIO)
    )
    rows = []
    for random_line in surfaces:
        began = time.process_time()
        line = Line.self_affine(*random_line, method.steps)
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

    The dimensions of points and steps have other names than at the root of the file, as they are
    shorter. Error and time are missing if a method is not installed, fails, or would take too long.
    """
    elements, finest = settings["elements"], settings["finest"]
    every = max((ladder_steps(point, finest) for point in points), key=len)
    warm_up(MARCHES, run_march)
    datasets = []
    for point in points:
        surfaces = [surface(point, elements, seed, i) for i in range(settings["march_lines"])]
        limit = reference(point, surfaces, finest)
        steps = ladder_steps(point, finest)
        methods = [climb(point, surfaces, "exponential", steps, limit)[list(TEXTS)]]
        for name in MARCHES:
            most = affordable(name, point, elements, settings["march_updates"])
            affordable_steps = [m for m in every if m <= most]
            errors = climb(point, surfaces, name, affordable_steps, limit, run=run_march)
            methods.append(errors[list(TEXTS)])
        datasets.append(xr.concat(methods, "solver", join="outer"))
        advance()
    data = over_points(datasets, points, TEXTS).assign_coords(solver=list(SOLVERS))
    return data.rename(point="compared", steps="tried")
