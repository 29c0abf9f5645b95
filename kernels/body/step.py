"""Interface of bodies: attempt a step, evaluate its forces, accept it.

The functions declared here dispatch on the type of the body.
"""

from typing import Any, NamedTuple

from ..compile.jit import dispatch_inlined, dispatch_on_type, dispatch_refcount_free, jitable
from ..rheology.law import law_of


class Move(NamedTuple):
    """Motion of the surface in a step."""

    before: Any  # place of the surface (ground.py)
    after: Any
    number: int  # from 1 on; a prescribed indentation is given by number
    final: bool  # whether this step is accepted without another attempt
    dt: float  # duration, in tau


class Forces(NamedTuple):
    """Forces of a step, in 4 G L h and 4 G L h^2/dx (E* L h and E* L h^2/dx of a half-space)."""

    mu: float  # eq. 5, in h/dx; NaN without contact
    normal: float
    friction: float
    contact_fraction: float


@jitable
def law_in_step(body, state, dt):
    """Return the law of the elastomer in a step of length dt."""
    return law_of(body.form, dt)


@dispatch_on_type
def on_ground(body, state, ground):
    """Return (body, state) over another ground, at the same place."""


@dispatch_inlined
def attempt(body, state, law, step):
    """Return the state with the contact at the end of a step, which is not accepted yet.

    law : of the elastomer in the step (rheology/law.py). step : a Move. Unless it is final, another
    step may be attempted from the returned state instead of accepting this one.
    """


@dispatch_refcount_free
def forces(body, state, law, step):
    """Return the Forces of the step that was attempted last."""


@dispatch_inlined
def accept(body, state, law):
    """Return the state after the step that was attempted last."""


@dispatch_on_type
def end_leg(body, state):
    """Return the state at the end of a leg, from which a programme resumes bit for bit."""


@dispatch_refcount_free
def patch_width(body, state):
    """Return the number of samples per contact patch in the last accepted step."""


@dispatch_on_type
def elements_of(body, state):
    """Return the Elements after the last accepted step (rheology/law.py)."""
