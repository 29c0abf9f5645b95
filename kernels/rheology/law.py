"""Interface of the laws of the elastomer; each law has its own file in this folder.

A law is a NamedTuple of the constants of one time step. Two fields are common to all:

stiffness   A free element would reach w in the step. The step's force is stiffness * (w - u)
            in units of 4 G dx h, where u is the displacement at its end.
lag         When this force acts, as a fraction of the step before its end. The slope that
            weights the force is taken there.

A law of elements that remember only their displacement provides ``free_displacement``. Laws with
internal variables are derived from a form of the material, which holds for steps of any length.

The functions declared here dispatch on the type of the law or of the form.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import dispatch_on_type

# Smaller magnitudes are set to zero: subnormal numbers would slow a sweep tenfold. A decay of one
# step below its square root is zero too, so that products with memory stay normal numbers.
MIN_MAGNITUDE = 1e-200


class State(NamedTuple):
    """State of the elements of a line between two steps."""

    w: np.ndarray  # shape (n,): displacements they would have without force, in h
    d: float  # indentation, in h; element i touches where z_i - w_i < d, at u_i = z_i - d


class Elements(NamedTuple):
    """State of elements with internal variables between two steps."""

    memory: np.ndarray  # shape (M, n): internal variables of the n elements
    p: np.ndarray  # shape (n,): forces of the last step, in 4 G dx h
    d: float  # indentation, in h


@dispatch_on_type
def free_displacement(law, u):
    """Return the displacement of an element one step after u, if no force acts on it."""


@dispatch_on_type
def law_of(form, dt):
    """Return the law of a step of length dt (in tau) of the material in this form."""


@dispatch_on_type
def memory_size(form):
    """Return M, the number of internal variables of an element."""


@dispatch_on_type
def rest_memory(form, p):
    """Return the memory, shape (M, n), in equilibrium under forces p (n,)."""


@dispatch_on_type
def displacement(form, memory, p):
    """Return the displacements (n,) of elements with this memory under forces p (n,)."""


@dispatch_on_type
def static_pressure(form, memory):
    """Return (viscosity, pressures (n,) without the dashpot's part, at no rate, in G h)."""


@dispatch_on_type
def predict(law, memory, p, w):
    """Fill w (n,) with the displacements that elements would reach in the step without force.

    memory : shape (M, n), p : shape (n,), the forces of the step before. Linear in both.
    """


@dispatch_on_type
def advance_memory(law, memory, w, p, new):
    """Advance memory (M, n) over the step, in place. Linear in all arguments after the law.

    w (n,) : as predict left it; it may be changed. p (n,) : forces of the step before.
    new (n,) : of this step, stiffness * max(0, w - u). p stays: the caller makes new the next p.
    """
