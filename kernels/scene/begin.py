"""How a scene begins: sliding steadily, at rest for ever, or just pressed on."""

import numpy as np

from ..branches.steady_memory import steady_at, steady_memory
from ..lines.line import Line
from ..model.contact import solve_indentation
from ..model.steady import steady_sliding, sweep
from ..motion.legs import speed_at_start
from ..rheology.forms import Form, form_of
from ..rheology.kelvin import SCHEMES
from ..rheology.law import Elements, rest_memory
from ..rheology.relaxed import RelaxationForm
from ..rheology.retardation import Retardation
from ..rheology.spectrum import KELVIN, Spectrum
from .scene_case import Saved, SceneCase, indentation_at


def begun(line: Line, scene: SceneCase, form: Form) -> Saved:
    """Return the state of a line before the first step of a scene."""
    z = line.z
    load = scene.load * z.size if scene.indentation is None else None
    d = np.nan if load is not None else float(indentation_at(scene, np.zeros(1), line.datum)[0])
    speed = 0.0
    if scene.start == "steady":
        speed = speed_at_start(scene.programme)
        samples = speed * line.steps_per_spacing
        elements = steady(scene.scheme, scene.spectrum, z, samples, load, d)
    elif scene.start == "relaxed":
        elements = relaxed(form, z, load, d)
    else:
        elements = fresh(form, scene.spectrum, z, load, d)
    return Saved(*elements, 0.0, 0.0, speed)


def relaxed(form: Form, z: np.ndarray, load: float | None, d: float) -> Elements:
    """Return elements on which the line has rested for ever.

    z : line, shape (n,), in h. load : n Fbar, or None where the indentation d (in h) is given.
    """
    return _pressed(form, z, load, d, 1.0)


def fresh(form: Form, spectrum: Spectrum, z: np.ndarray, load: float | None, d: float) -> Elements:
    """Return elements on which the line has just been pressed; arguments as of relaxed.

    Raises ValueError for a material with a dashpot: it carries any load at no indentation.
    """
    elements = _pressed(form, z, load, d, glassy_stiffness(spectrum))
    charge_branches(form, elements.memory)
    return elements


def glassy_stiffness(spectrum: Spectrum) -> float:
    """Return the stiffness of what is just pressed on, over the relaxed one.

    Raises ValueError for a material with a dashpot: it carries any load at no indentation.
    """
    if spectrum.viscosity > 0.0:
        raise ValueError('start = "fresh": a dashpot carries any load at first, at no indentation')
    return 1.0 + sum(spectrum.moduli)


def charge_branches(form: Form, memory: np.ndarray) -> None:
    """Let all branches carry their share of what is just pressed on; memory : of rest, changed."""
    if isinstance(form, Retardation):
        memory[:] = 0.0
    else:
        memory[:-1] = form.moduli[:, None] * memory[-1]


def _pressed(form: Form, z: np.ndarray, load: float | None, d: float, stiffness: float) -> Elements:
    """Return elements of one stiffness that have crept as much as their displacement tells."""
    if load is not None:
        d, _ = solve_indentation(z, load / stiffness, z.min() + load / (stiffness * z.size))
    u = np.minimum(z - d, 0.0)
    memory = rest_memory(form, -u)
    if isinstance(form, RelaxationForm):
        memory[:-1] = 0.0
    return Elements(memory, -stiffness * u, d)


def steady(
    scheme: str,
    spectrum: Spectrum,
    z: np.ndarray,
    speed: float,
    load: float | None,
    d: float,
) -> Elements:
    """Return elements under steady sliding; z, load, d as of relaxed.

    speed : signed, in samples per tau.
    """
    form = form_of(spectrum, scheme)
    if load is None and d <= z.min():  # nothing touches
        return relaxed(form, z, None, d)
    if spectrum == KELVIN:
        return _steady_kelvin(scheme, z, speed, load, d)
    if load is None:
        return steady_at(form, z, speed, d).elements
    return steady_memory(form, z, speed, load).elements


def _steady_kelvin(
    scheme: str, z: np.ndarray, speed: float, load: float | None, d: float
) -> Elements:
    """Return the same of Kelvin elements, by the sweep for elements that remember u alone."""
    law = SCHEMES[scheme](1.0 / abs(speed))
    along = z if speed > 0.0 else np.ascontiguousarray(z[::-1])
    w = np.zeros_like(z)
    if load is not None:
        (w, d), _ = steady_sliding(law, along, load)
    else:
        sweep(law, along, d, int(np.argmin(along)), w)
    u = np.minimum(w, along - d)
    p = law.stiffness * (w - u)
    if speed < 0.0:
        u, p = u[::-1].copy(), p[::-1].copy()
    return Elements(u[None], p, d)
