"""Initial states of scenes: steady sliding, a relaxed contact, or a fresh contact."""

import math

import numpy as np

from ..branches.steady_memory import steady_memory
from ..lines.line import Line
from ..model.contact import solve_indentation
from ..model.steady import steady_sliding, sweep
from ..motion.legs import speed_at_start
from ..rheology.forms import Form, form_of
from ..rheology.kelvin import SCHEMES
from ..rheology.law import Elements, law_of, rest_memory
from ..rheology.relaxed import RelaxationForm
from ..rheology.retardation import Retardation
from ..rheology.spectrum import KELVIN, Spectrum
from .carried import CarriedBranches, carried_memory
from .scene_case import SavedState, SceneCase, indentation_at


def initial_state(
    line: Line, scene: SceneCase, form: Form, carried: CarriedBranches | None = None
) -> SavedState:
    """Return the state of a line before the first step of a scene.

    carried : branches that the motion carries along from a start at rest (carried.py), if any.
    """
    z, load, d, speed = line.z, scene.load * line.z.size, np.nan, 0.0
    if scene.indentation is not None:
        d = float(indentation_at(scene, np.zeros(1), line.datum)[0])
    if scene.start == "steady":
        speed = speed_at_start(scene.programme)
        samples = speed * line.steps_per_spacing
        elements = steady_elements(scene.scheme, scene.spectrum, z, samples, load, d)
    elif carried is not None:
        samples = carried.speed * line.steps_per_spacing
        elements = steady_elements(scene.scheme, carried.spectrum, z, samples, load, d)
        slow_form = form_of(carried.spectrum, scene.scheme)
        memory = carried_memory(form, carried, slow_form, elements.memory, elements.p)
        elements = elements._replace(memory=memory)
    elif scene.start == "relaxed":
        elements = relaxed_elements(form, z, load, d)
    else:
        elements = fresh_elements(form, scene.spectrum, z, load, d)
    return SavedState(*elements, 0.0, 0.0, speed)


def steady_lag(scene: SceneCase, form: Form, m: int) -> float:
    """Return the lag of the steady step before a scene, with the sign of its speed.

    m : steps per spacing. The lag is zero if the scene does not start from steady sliding.
    """
    if scene.start != "steady":
        return 0.0
    speed = speed_at_start(scene.programme)
    return math.copysign(law_of(form, 1.0 / (m * abs(speed))).lag, speed)


def relaxed_elements(
    form: Form, z: np.ndarray, load: float, d: float, stiffness: float = 1.0
) -> Elements:
    """Return elements in equilibrium with a line at rest.

    z : line, shape (n,), in h. load : n Fbar, or NaN if the indentation d (in h) is given.
    stiffness : of the elements, over the relaxed stiffness.
    """
    if not math.isnan(load):
        d, _ = solve_indentation(z, load / stiffness, z.min() + load / (stiffness * z.size))
    u = np.minimum(z - d, 0.0)
    memory = rest_memory(form, -u)
    if isinstance(form, RelaxationForm):
        memory[:-1] = 0.0
    return Elements(memory, -stiffness * u, d)


def fresh_elements(
    form: Form, spectrum: Spectrum, z: np.ndarray, load: float, d: float
) -> Elements:
    """Return elements just after sudden pressing; z, load, d : as for relaxed_elements.

    Raises ValueError for a material with a dashpot; see ``glassy_stiffness``.
    """
    elements = relaxed_elements(form, z, load, d, glassy_stiffness(spectrum))
    charge_branches(form, elements.memory)
    return elements


def glassy_stiffness(spectrum: Spectrum) -> float:
    """Return the stiffness under sudden loading, over the relaxed stiffness.

    Raises ValueError for a material with a dashpot, which carries any load at zero indentation.
    """
    if spectrum.viscosity > 0.0:
        raise ValueError('start = "fresh": a dashpot carries any load at first, at no indentation')
    return 1.0 + sum(spectrum.moduli)


def charge_branches(form: Form, memory: np.ndarray) -> None:
    """Load all branches as in sudden pressing; memory : of elements at rest, changed in place."""
    if isinstance(form, Retardation):
        memory[:] = 0.0
    else:
        memory[:-1] = form.moduli[:, None] * memory[-1]


def steady_elements(
    scheme: str, spectrum: Spectrum, z: np.ndarray, speed: float, load: float, d: float
) -> Elements:
    """Return elements in steady sliding; z, load, d : as for relaxed_elements.

    speed : signed, in samples per tau.
    """
    form = form_of(spectrum, scheme)
    if d <= z.min():  # nothing touches
        return relaxed_elements(form, z, load, d)
    if spectrum == KELVIN:
        return _steady_kelvin(scheme, z, speed, load, d)
    return steady_memory(form, z, speed, load, d).elements


def _steady_kelvin(scheme: str, z: np.ndarray, speed: float, load: float, d: float) -> Elements:
    """Return Kelvin elements in steady sliding, by the sweep of model/steady.py."""
    law = SCHEMES[scheme](1.0 / abs(speed))
    along = z if speed > 0.0 else np.ascontiguousarray(z[::-1])
    w = np.zeros_like(z)
    if math.isnan(load):
        sweep(law, along, d, int(np.argmin(along)), w)
    else:
        (w, d), _ = steady_sliding(law, along, load)
    u = np.minimum(w, along - d)
    p = law.stiffness * (w - u)
    if speed < 0.0:
        u, p = u[::-1].copy(), p[::-1].copy()
    return Elements(u[None], p, d)
