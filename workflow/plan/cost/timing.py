"""`python -m workflow.plan.cost.timing`: time the kernels for two seconds, print JSON.

It runs in a process of its own, set up like a worker (how memory is kept matters as much as the
processor).
"""

import json
import time
from collections.abc import Callable
from datetime import UTC, datetime
from functools import partial
from statistics import median

import numpy as np

from kernels import (
    QUARTET,
    SCHEMES,
    ConstantForce,
    Line,
    Quantities,
    amplitudes,
    draw_phases,
    lagged_slope,
    march,
    quadrature,
    steady_sliding,
)
from workflow.plan.cost.work import SecondsBySize, Timings
from workflow.simulate import Batch, Problem, Recording, Task, block_means
from workflow.system import processor

SIZES = (2_000, 20_000, 200_000)  # samples: in the first, second, third cache
SHORTEST = 60
FEW, MANY = 4, 24  # steps: their difference is free of what a march does once
SECONDS = 0.05  # per measurement, at least 3 calls
HURST, LOAD, SPEED, STEPS = 0.7, 0.1, 1.0, 4
ALL_TOUCHING = 30.0  # load


def seconds(call: Callable[[], object]) -> float:
    """Return the median CPU time of a call; the first one, which may compile, is not counted."""
    call()
    found: list[float] = []
    while len(found) < 3 or sum(found) < SECONDS:
        began = time.thread_time()
        call()
        found.append(time.thread_time() - began)
    return median(found)


def _quartet(amplitude: np.ndarray, elements: int) -> list[Line]:
    phases = draw_phases(np.random.default_rng(1), elements)
    return list(Line.quartet(amplitude, phases, elements, STEPS))


def _at(samples: int) -> dict[str, float]:
    """Return the seconds of every kernel on a line of this size, all of which is marched."""
    elements = samples // STEPS
    amplitude = amplitudes(HURST, elements)  # the lines of a batch share it
    line, load = _quartet(amplitude, elements)[0], LOAD * samples
    law, control = SCHEMES["exponential"](1.0 / (STEPS * SPEED)), ConstantForce(load)
    state, sweeps = steady_sliding(law, line.z, load)

    def marching(kept_steps: np.ndarray) -> None:
        weight = lagged_slope(line.slope, law.lag)
        march(law, control, line.z, weight, state, kept_steps, np.inf)

    few, many = (seconds(partial(marching, np.array([steps]))) for steps in (FEW, MANY))
    whole = ALL_TOUCHING * samples
    touching, _ = steady_sliding(law, line.z, whole)
    each = max(many - few, 0.1 * many) / (MANY - FEW)
    steady = seconds(lambda: steady_sliding(law, line.z, load))
    return {
        "draw": seconds(lambda: _quartet(amplitude, elements)) / QUARTET,
        "sweep": steady / sweeps,
        "quadrature": seconds(
            lambda: quadrature(line.z, line.slope, *touching, SPEED, 1.2 * SPEED, whole)
        ),
        "setup": max(few - FEW * each, 0.1 * few),
        "step": each,
    }


def _case(kernels: dict[str, float]) -> float:
    """Return the seconds of a realization of SHORTEST samples beyond its kernels."""
    problem = Problem(HURST, SHORTEST, LOAD, SPEED, 1.2)
    asked = Quantities()
    batch = Batch(
        1, "modal", asked, "exponential", Recording(64), (Task(problem, 1, 8, ""),), 0, 1, 20, 0.0
    )
    states = 2 * 4 * kernels["sweep"] + 3 * kernels["quadrature"]
    inside = kernels["draw"] + states + kernels["setup"] + 8 * kernels["step"]
    whole = seconds(lambda: block_means(batch)) / batch.realizations_per_block
    return max(whole - inside, 0.1 * whole)


def timings() -> Timings:
    """Return the timings of this thread of this machine."""
    sizes = (SHORTEST, *SIZES)
    found = [_at(size) for size in sizes]
    curves = {name: SecondsBySize(sizes, tuple(at[name] for at in found)) for name in found[0]}
    return Timings(**curves, case=_case(found[0]))


if __name__ == "__main__":
    today = datetime.now(UTC).date().isoformat()
    print(json.dumps({"machine": processor(), "date": today, "timings": timings()._asdict()}))
