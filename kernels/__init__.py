"""Numerical core of the sliding viscoelastic foundation (numpy and numba only).

Everything here is dimensionless: heights in units of the rms roughness h, lengths along
the line in units of the element spacing dx, times in units of the relaxation time tau.
A problem is then given by the Hurst exponent H, the number of elements N = L/dx and

    load  Fbar = F_N / (4 G L h),    speed  vbar = v tau / dx,    ratio  r = v2 / v1,

Slopes and friction coefficients are in units of h/dx.
Source: Li, Dimaki, Popov, Psakhie, Popov (2014), doi:10.1038/srep05795.

``run_case`` computes one case on one line, ``run_cases`` many cases on one line, and
``run_prepared`` the same cases on many lines. Each effect has its own file, in lines/, rheology/,
control/ or motion/; machine code contains only the effects that a scene requests.
"""

from .control.printed_eq3 import PrintedForce
from .heat.heat import Heat
from .interface.effects import NO_EFFECTS, Effects
from .interface.layer import BACKINGS, Layer
from .interface.shear import Bell, ShearLaw, ShearTable, shear_stress
from .lines.equivalent import equivalent_amplitudes, equivalent_of_cut, equivalent_spectrum
from .lines.isotropic_spectrum import (
    IsotropicSpectrum,
    isotropic_of_cut,
    isotropic_of_equivalent,
)
from .lines.line import QUARTET, Line
from .lines.measured_modes import measured_amplitudes
from .lines.self_affine import (
    amplitudes,
    draw_phases,
    matching_rolloff,
    power_spectrum,
    rms_height,
    rms_slope,
    sample_line,
)
from .model.contact import solve_indentation
from .model.force import ConstantForce
from .model.friction import lagged_slope, quadrature, step_average
from .model.march import march
from .model.steady import steady_sliding
from .motion.counts import MAX_PROGRAMME_STEPS, count_steps
from .motion.extent import programme_extent
from .motion.legs import Hold, Leg, Oscillation, Programme, Ramp, Sampled, Slide, steps_of
from .rheology.forms import form_of
from .rheology.kelvin import SCHEMES, Kelvin
from .rheology.law import State, law_of, memory_size
from .rheology.spectrum import KELVIN, Spectrum
from .rheology.time_shift import (
    GAS_CONSTANT,
    ZERO_CELSIUS,
    Arrhenius,
    ShiftLaw,
    ShiftTable,
    Wlf,
    inverse_temperature,
)
from .scene import (
    ENERGIES,
    MAX_REMEMBERED,
    MOTION_TRACES,
    TRACES,
    ZERO_ORIGIN,
    Origin,
    SavedState,
    SceneCase,
    carried_branches,
    run_scene,
    scene_steps,
)
from .velocity_step.case import Case, ContactAreas, HotParts, Outcome, Quantities, Seconds
from .velocity_step.cases import run_case, run_cases, run_prepared
from .velocity_step.prepared import Prepared, prepare
