"""Friction as the sum of the viscoelastic part and the shear of the real contact.

    mu = mu_viscoelastic + tau_f(|v|) A/(A_0 sigma_0),    with the sign of v

(kernels/interface/shear.py). A prescribed motion gives v, so that the sum is linear in the block
means of mu and A: standard errors of a sum include their covariance. With a drive the kernels apply
the law: the trace of mu is then viscoelastic, and the friction force is the total.
"""

from typing import Any

import numpy as np

from ...kernels import Leg, Ramp, Sampled, shear_stress
from ...kernels.motion.legs import last_speed
from ..plan import nominal_pressure
from ..simulate import SCALARS, Problem, Task

Parts = dict[str, np.ndarray]  # block means of parts of totals, by names such as mu_1_shear


def add_shear(
    tasks: list[Task], scalars: np.ndarray, values: dict[str, np.ndarray], legs: np.ndarray
) -> tuple[np.ndarray, dict[str, np.ndarray], Parts]:
    """Return scalars and values of block means with totals, and the parts of the totals.

    scalars : shape (tasks, blocks, len(SCALARS)). values : parts of rows, each (tasks, blocks,
    *its shape). legs : of the trace samples, NaN after the last, shape (tasks, events).
    """
    if tasks[0].problem.effects.shear is None:
        return scalars, values, {}
    scalars, values, parts = scalars.copy(), dict(values), Parts()
    for name, shear in _steady_parts(tasks, scalars, values).items():
        total = scalars[..., SCALARS.index(name)]
        parts |= {f"{name}_shear": shear, f"{name}_viscoelastic": total.copy()}
        total += shear
    if "contact_curve" in values:
        if "curve_shear" in values:
            shear = values["curve_shear"]
        else:
            after = _at_jump([task.problem for task in tasks])[:, 1]
            shear = after[:, None, None] * values["contact_curve"]
        for part, curve in (("shear", shear), ("viscoelastic", values["curve"])):
            start = parts[f"mu_1_{part}"] + parts[f"jump_{part}"]
            parts[f"mu_{part}"] = np.concatenate([start[..., None], curve], axis=2)
        values["curve"] = values["curve"] + parts["mu_shear"][..., 1:]
    if "trace_mu" in values:
        parts["trace_mu_viscoelastic"] = values["trace_mu"]
        load = np.array([task.problem.load for task in tasks])[:, None, None]
        if tasks[0].problem.kernel_effects.shear is None:
            shear = _trace_part(tasks, values, legs)
            values["trace_friction_force"] = load * (values["trace_mu"] + shear)
        else:
            shear = values["trace_friction_force"] / load - values["trace_mu"]
        parts["trace_mu_shear"], values["trace_mu"] = shear, values["trace_mu"] + shear
    if "mu_cycle_mean_shear" in values:
        shear = parts["mu_cycle_mean_shear"] = values["mu_cycle_mean_shear"]
        parts["mu_cycle_mean_viscoelastic"] = values["mu_cycle_mean"] - shear
    if "initial_rate" in values:  # samples do not resolve the rate of the contact area
        parts["initial_rate_viscoelastic"] = values["initial_rate"]
        values["initial_rate"] = np.full_like(values["initial_rate"], np.nan)
    return scalars, values, parts


def _steady_parts(tasks: list[Task], scalars: np.ndarray, values: dict[str, np.ndarray]) -> Parts:
    """Return the shear parts of steady friction and of the jump."""
    if "contact_2" not in values:
        return {}
    if "mu_1_shear" in values:  # temperatures exist only in the kernels
        return {name: values[f"{name}_shear"] for name in ("mu_1", "mu_2", "jump")}
    problems = [task.problem for task in tasks]
    first, last = per_contact(problems, [problem.ends for problem in problems]).T[..., None]
    before, after = _at_jump(problems).T[..., None]
    contact_before, contact_after = np.moveaxis(values["contact_step"], -1, 0)
    return {
        "mu_1": first * scalars[..., SCALARS.index("contact_fraction")],
        "mu_2": last * values["contact_2"],
        "jump": after * contact_after - before * contact_before,
    }


def _at_jump(problems: list[Problem]) -> np.ndarray:
    """Return the shear parts of mu for a full contact before and after the velocity step."""
    steps = [(problem.speed, problem.speed * problem.ratio) for problem in problems]
    return per_contact(problems, steps)


def per_contact(problems: list[Problem], speeds: Any) -> np.ndarray:
    """Return the shear part of mu (h/dx) for a full contact, at speeds (dx/tau) of problems.

    speeds : signed, shape (problems, ...), which is that of the result.
    """
    parts = []
    for problem, values in zip(problems, np.asarray(speeds, float), strict=True):
        law = problem.effects.shear
        assert law is not None
        parts.append(np.sign(values) * shear_stress(law, values) / nominal_pressure(problem))
    return np.array(parts)


def _trace_part(tasks: list[Task], values: dict[str, np.ndarray], legs: np.ndarray) -> np.ndarray:
    """Return the shear part of the traces of mu, shape (tasks, blocks, events)."""
    shares = np.full(values["trace_velocity"].shape, np.nan)
    for row, task in enumerate(tasks):
        sampled = np.isfinite(legs[row])
        directions = _directions(task.problem)[legs[row][sampled].astype(int)]
        law, speeds = task.problem.effects.shear, values["trace_velocity"][row][:, sampled]
        assert law is not None
        sign = np.where(speeds == 0.0, directions, np.sign(speeds))
        stress = shear_stress(law, speeds) / nominal_pressure(task.problem)
        shares[row][:, sampled] = sign * stress
    return shares * values["trace_contact_fraction"]


def _directions(problem: Problem) -> np.ndarray:
    """Return the sign of the last motion up to the end of each leg; 0 if nothing moved before."""
    signs, sign = [], np.sign(problem.speed) if problem.start == "steady" else 0.0
    for leg in problem.programme:
        for speed in _speeds(leg):
            sign = np.sign(speed) or sign
        signs.append(sign)
    return np.array(signs)


def _speeds(leg: Leg) -> tuple[float, ...]:
    """Return speeds of a leg in order; the last one is that at its end."""
    if isinstance(leg, Ramp):
        return leg.first, leg.last
    return leg.speeds if isinstance(leg, Sampled) else (last_speed(leg),)
