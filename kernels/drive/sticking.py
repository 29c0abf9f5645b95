"""Sticking of a slider with static friction, which takes any value up to a largest one.

At rest the friction is what the drive demands, at most the static force in either direction. Beyond
it the slider moves, against a friction that begins with the static force. This is solved exactly:
a step is attempted at rest first, and only if the force demanded is too large at a distance.
"""

from ..compile.jit import dispatch_on_type
from .slider_step import (
    BalancedStep,
    PulledSlider,
    SliderProgress,
    Trip,
    accept_step,
    advance_slowly,
    attempt_step,
    creep,
)
from .spring import DriveLeg, force_balance

MIN_SLIP = 1e-9  # in samples: the shortest distance of a step that does not stick


class StickingSlider(PulledSlider):
    """A slider that may stick; it runs as plain Python."""


@dispatch_on_type
def static_force(body, state, acting):
    """Return the largest friction at rest beside that of ``acting``, the Forces of the step."""


@advance_slowly.register(StickingSlider)
def _stick_or_creep(
    pulled: StickingSlider,
    leg: DriveLeg,
    progress: SliderProgress,
    place: float,
    edges: tuple[float, float],
    dt: float,
) -> SliderProgress:
    motion = progress.motion
    step = attempt_step(pulled, progress.state, leg, motion, Trip(place, place, 0.0), dt)
    # The excess force is linear in the friction, as the friction is extrapolated linearly.
    lag = step.law.lag * dt
    since = step.balance.friction_time - motion.friction_time
    missing = step.balance.excess / (1.0 + lag / since)
    most = static_force(pulled.body, step.state, step.acting)
    if abs(missing) <= most + pulled.force_tolerance:
        friction = step.acting.friction + missing
        balance = force_balance(pulled.drive, leg, motion, 0.0, dt, step.law.lag, friction)
        acting = step.acting._replace(friction=friction)
        held = BalancedStep(step.state, step.law, dt, balance, acting)
        return accept_step(pulled, leg, progress, 0.0, held)
    ends = (place + MIN_SLIP, edges[1]) if missing > 0.0 else (edges[0], place - MIN_SLIP)
    progress = progress._replace(state=step.state)
    return creep(pulled, leg, progress, place, ends, dt)
