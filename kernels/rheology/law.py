"""Interface of the laws of the elastomer; each law has its own file in this folder.

A law is a NamedTuple of the constants of one time step. Two fields are common to all:

stiffness   The force in the step is stiffness * (w - u), in units of 4 G dx h. Here u is the
            displacement at the end of the step, and w its value for a free element.
lag         Time from the instant at which this force acts to the end of the step, as a fraction
            of the step. Friction weights the force with the slope at that instant.

A law of elements that remember only their displacement provides ``free_displacement``. Laws with
internal variables are derived from a form of the material, which holds for steps of any length.

The functions declared here dispatch on the type of the law or of the form.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import dispatch_on_type

# Smaller magnitudes are set to zero: subnormal numbers would slow a sweep tenfold. The decay factor
# of a step is zero below the square root of this, so that products with memory stay normal.
MIN_MAGNITUDE = 1e-200


class State(NamedTuple):
    """State of the elements of a line between two steps."""

    w: np.ndarray  # shape (n,): displacements that the elements would have without force, in h
    d: float  # indentation, in h; element i touches if z_i - w_i < d, and then u_i = z_i - d


class Elements(NamedTuple):
    """State of elements with internal variables between two steps."""

    memory: np.ndarray  # shape (M, n): internal variables of the n elements
    p: np.ndarray  # shape (n,): forces of the last step, in 4 G dx h
    d: float  # indentation, in h


@dispatch_on_type
def free_displacement(law, u):
    """Return the displacement of a free element one step after its displacement was u."""


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
    """Return (viscosity, pressures (n,) without the viscous part, i.e. at du/dt = 0, in G h)."""


@dispatch_on_type
def predict(law, memory, p, w):
    """Fill w (n,) with the displacements that elements would reach in the step without force.

    memory : shape (M, n). p (n,) : forces of the previous step. The result is linear in both.
    """


@dispatch_on_type
def advance_memory(law, memory, w, p, new):
    """Advance memory (M, n) over the step, in place. Linear in all arguments after the law.

    w (n,) : from predict; may be changed. p (n,) : forces of the previous step, not changed.
    new (n,) : forces of this step, stiffness * max(0, w - u).
    """
