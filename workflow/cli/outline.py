"""What `plan` prints: what a study would do and cost, and whether each effect is simulated."""

import math
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from ..ground import counted
from ..plan import (
    MARCHED,
    WHOLE,
    Pace,
    Plan,
    Prediction,
    Variant,
    expected_errors,
    make_plan,
    model_ratio,
    prediction,
    this_machine,
)
from ..study import (
    HALF_SPACE,
    QUANTITIES,
    FromFile,
    HoldSegment,
    Material,
    Measured,
    Oscillate,
    RampSegment,
    SlideSegment,
    Study,
    accuracy_estimates,
    axes_of,
    unavailable_reason,
)
from ..system import COMPILING_MIB, core_time

SHOWN = 8  # legs of a programme
SECONDS_PER_POINT = 1.5e-5  # of each variant, that planning takes
LONG = 1.0  # s, a wait that is announced
PATIENCE = 120.0  # s of a run, beyond which a first look at steady friction alone is offered
MUCH = 10.0  # times the time of that first look: a run that takes less needs none


Said = tuple[list[str], dict[str, Any]]  # lines to print, and the same as data
NAMES = {
    SlideSegment: "slide",
    HoldSegment: "hold",
    RampSegment: "ramp",
    Oscillate: "oscillate",
    FromFile: "file",
}


def outline_grid(study: Study, result: Path) -> Said:
    """Return what a study of a grid would do and cost, as lines and as data; computes nothing."""
    machine = this_machine()
    plan = announced_plan(study, machine.pace)
    cost, records = plan.prediction(), plan.records
    facts = {
        # JSON has no NaN, which stands where an axis has no value
        "axes": {
            axis: [None if math.isnan(v) else v for v in values]
            for axis, values in study.grid.items()
        },
        "quantities": study.scene.quantities,
        "read": _read(study),
        "points": plan.points,
        "problems": plan.problems,
        "variants": list(study.variants),
        "realizations": records * study.realizations_per_block,
        "records": records,
        "predicted_core_seconds": cost.seconds,
        "predicted_core_seconds_interval": [cost.low, cost.high],
        "predicted_worker_bytes": round(plan.predicted_worker_bytes()),
        "predicted_driver_bytes": round(plan.predicted_driver_bytes()),
        "longest_line_samples": plan.longest_line(),
        "not_simulated": dict(_parted(what) for yes, what in effects(study) if not yes),
    }
    return outline(plan, result, cost, machine.note), facts


def announced_plan(study: Study, pace: Pace) -> Plan:
    """Return the plan of a study; where that takes long, say so before."""
    points = math.prod(study.shape) * len(study.variants)
    seconds = SECONDS_PER_POINT * points
    if seconds > LONG:
        print(f"Planning {points} points, about {seconds:.0f} s.", file=sys.stderr)
    return make_plan(study, pace)


def outline_measured(study: Measured, result: Path) -> Said:
    """Return what a study would measure and how long it would take; measures nothing."""
    lines, typical = study.script.outline(study.settings)
    machine = this_machine()
    seconds, low, high = prediction(machine.pace, {(study.name, WHOLE): typical})
    head = [f"study       {study.name}: {study.title}", f"result      {result}"]
    facts = {
        "outline": lines,
        "predicted_core_seconds": seconds,
        "predicted_core_seconds_interval": [low, high],
    }
    cost = [f"predicted   {core_time(low, high)}", f"speed       as measured on {machine.note}"]
    return [*head, *lines, *cost], facts


def outline(plan: Plan, result: Path, cost: Prediction, speed: str) -> list[str]:
    """Return the description of a plan, line by line.

    cost : as it is predicted. speed : says where the pace of the prediction comes from.
    """
    study = plan.study
    lines = [
        f"study       {study.name}: {study.title}",
        f"result      {result}",
        f"computes    {', '.join(study.scene.quantities)}",
    ]
    for axis, values in study.grid.items():
        lines.append(f"  {axis:14s}{len(values):4d}  {_axis_span(values)}")
    copies = plan.points / plan.problems
    lines += [
        f"points      {plan.points}",
        f"problems    {plan.problems} distinct dimensionless problems ({copies:.3g} points each)",
        f"variants    {', '.join(v.label or 'study' for v in plan.variants)}",
        *_realizations(plan),
        f"predicted   {core_time(cost.low, cost.high)}",
        f"time        {_on_all_cores(cost)}, as measured on {speed}",
        *_first_look(plan, cost),
        f"memory      {plan.predicted_worker_bytes() / 2**20:.0f} MiB per worker, "
        f"{plan.predicted_driver_bytes() / 2**20:.0f} MiB in the driver, {COMPILING_MIB} MiB more "
        f"in a process that has to compile, longest line {plan.longest_line()} samples",
        *_errors(plan),
        *_model(plan),
        *read_lines_of(study),
        *effect_lines(study),
    ]
    for variant in plan.variants:
        lines += march_lines(variant)
    return lines


def _axis_span(values: tuple[float, ...]) -> str:
    """Return the values of an axis in short; that of measured lines may have none."""
    if any(map(math.isnan, values)):
        return "of the lines"
    return f"{values[0]:g}" if len(values) == 1 else f"{min(values):g} ... {max(values):g}"


def _on_all_cores(cost: Prediction) -> str:
    """Return how long a run takes on all cores of this machine."""
    from dask.system import CPU_COUNT  # its configuration is checked before it is imported

    words = core_time(cost.low / CPU_COUNT, cost.high / CPU_COUNT).replace("core-", "")
    return f"{words} on {counted(CPU_COUNT, 'worker')} of this machine"


def _first_look(plan: Plan, cost: Prediction) -> list[str]:
    """Return how soon steady friction alone would be there, where all takes long."""
    from dask.system import CPU_COUNT

    study, scene = plan.study, plan.study.scene
    asks_more = "steady" in scene.quantities and len(scene.quantities) > 1
    if cost.high < PATIENCE * CPU_COUNT or not asks_more or scene.programme:
        return []
    steady = replace(study, scene=scene._replace(quantities=("steady",)))
    alone = make_plan(steady, plan.pace).prediction()
    if MUCH * alone.high > cost.high:
        return []
    return [
        f"first look  steady friction alone takes {_on_all_cores(alone)}, with "
        "--set 'scene.quantities=[\"steady\"]'; the run of all reuses nothing of it"
    ]


def _errors(plan: Plan) -> list[str]:
    """Return what chance and discretisation will leave: the median over the problems, the worst."""
    found = expected_errors(plan)
    if not found:
        return [
            "standard error    not known before the run; the result holds it as NAME_error",
            "discretisation    not known before the run; the result holds it as NAME_bias",
        ]
    chance = [f"{name} {_shares(each.chance)}" for name, each in found.items()]
    bound = [
        f"{name} {_shares(each.discretisation)}"
        for name, each in found.items()
        if not np.isnan(each.discretisation).all()
    ]
    return [
        f"standard error    expected {', '.join(chance)}",
        f"discretisation    expected below {', '.join(bound)}",
    ]


def _shares(errors: np.ndarray) -> str:
    """Return the median and the largest of relative errors, those beyond 100 % as such."""
    middle, most = (min(100.0 * float(e), 100.0) for e in (np.median(errors), errors.max()))
    return f"{middle:.2g} % (at worst {most:.2g} %)"


def _read(study: Study) -> list[dict[str, Any]]:
    """Return what files were read as; of lines their numbers, too, in m."""
    found: list[dict[str, Any]] = [
        {"what": what, "told": told} for what, told in study.descriptions
    ]
    profiles = {own.description: own.profile for own in study.surfaces.values()}
    for each in found:
        if (profile := profiles.get(each["told"])) is not None:
            lines, *samples = profile.heights.shape
            each |= {"lines": lines, "samples": samples, "step": profile.spacing}
            each |= {"roughness": profile.roughness, "rms_slope": profile.slope}
    return found


def read_lines_of(study: Study) -> list[str]:
    """Return what was read of files of lines, a line for each kind of lines made of them."""
    told = dict.fromkeys(surface.description for surface in study.surfaces.values())
    return [f"lines       {each}" for each in told if each]


def march_lines(variant: Variant) -> list[str]:
    """Return which legs of a variant are marched, in how many steps, and how far it remembers."""
    found = []
    if variant.recording.requested:
        legs = [type(leg).__name__.lower() for leg in variant.tasks[0].problem.programme]
        steps = variant.leg_counts()
        found = [f"{leg} {_span(steps[:, k])}" for k, leg in enumerate(legs[:SHOWN])]
        found += ["..."] * (len(legs) > SHOWN) + [f"in all {_span(steps.sum(axis=1))}"]
    if any(task.march_steps for task in variant.tasks):
        steps = np.array([task.march_steps for task in variant.tasks])
        found.append(f"after the velocity step {_span(steps)}")
    what = f"steps: {', '.join(found)}" if found else "none: steady sliding is solved"
    problems = [task.problem for task in variant.tasks]
    longest = variant.material.longest_time / variant.material.tau
    reach = np.array([abs(p.speed) * max(1.0, p.ratio) * longest / p.elements for p in problems])
    return [
        f"marches     {variant.label or 'study'}: {what}",
        f"remembers   {variant.label or 'study'}: v t_max / L = {_span(reach)}",
    ]


def _model(plan: Plan) -> list[str]:
    """Return what the choice of the body does to mu_1, where that is known."""
    if "steady" not in plan.study.scene.quantities:
        return []
    variant = plan.variants[0]
    ratios = np.array(
        [model_ratio(t.problem, variant.lines.normalisation)[0] for t in variant.tasks]
    )
    known = ratios[~np.isnan(ratios)]
    if not known.size:
        return ["model       foundation over half-space: not known here"]
    some = "" if known.size == ratios.size else f" at {known.size} of {ratios.size} problems"
    return [f"model       the foundation gives {_span(known, 2)} of a half-space here{some}"]


def _span(values: np.ndarray, digits: int = 4) -> str:
    """Return the least and the largest of some numbers."""
    low, high = f"{values.min():.{digits}g}", f"{values.max():.{digits}g}"
    return low if low == high else f"{low} ... {high}"


def _realizations(plan: Plan) -> list[str]:
    """Return how many realizations there are, and what they are to reach."""
    study = plan.study
    block = study.realizations_per_block
    runs = plan.records * block
    if not any(variant.goals for variant in plan.variants):
        asked = study.realizations_requested
        rounded = asked < study.realizations
        up = f" ({asked} rounded up to whole quartets of lines)" if rounded else ""
        return [f"realizations {study.realizations} each{up}, {runs} in all"]
    lines = [f"realizations {runs} in all, predicted; rounds add more until the accuracy is met"]
    for variant in plan.variants:
        if not variant.goals:
            continue
        numerics = variant.numerics
        counts = [plan.expected[task.key] * block for task in variant.tasks]
        steps = [task.steps_per_spacing for task in variant.tasks]
        capped = sum(n + block > numerics.max_realizations for n in counts)
        wanted = numerics.accuracy or 0.0
        sought = [
            {name: goal.bias[name] for name, scatter in goal.scatter.items() if scatter > 0.0}
            for goal in variant.goals.values()
        ]
        coarse = sum(max(bias.values()) > 0.5 * wanted for bias in sought)
        names = len(accuracy_estimates(plan.study.scene.quantities))
        nothing = sum(len(bias) < names for bias in sought)
        given = " (given: its error is not counted)" if numerics.steps_per_spacing else ""
        lines += [
            f"accuracy    {wanted:g} {variant.label}",
            f"  steps     {min(steps)} ... {max(steps)} per spacing, elements with them{given}",
            f"  each      {min(counts)} ... {max(counts)} realizations",
            f"  missed    probably at {capped} problems that end at {numerics.max_realizations} "
            f"realizations, at {coarse} that no line in reach resolves",
            f"  no rate   sought at {nothing} problems, where less than "
            f"{numerics.negligible:g} of the jump is expected to relax",
        ]
    return lines


def effects(study: Study) -> list[tuple[bool, str]]:
    """Return of every effect whether it is simulated, and "EFFECT: how", or why not."""
    return [*_materials(study), *_surface(study), *_motion(study), *_quantities(study)]


def _parted(what: str) -> tuple[str, str]:
    """Return the name of an effect, and what is said of it."""
    name, _, said = what.partition(": ")
    return name, said


def effect_lines(study: Study) -> list[str]:
    """Return a line for every effect that is simulated, and one that names all others."""
    found = effects(study)
    lines = [f"simulated     {what}" for yes, what in found if yes]
    absent = ", ".join(_parted(what)[0] for yes, what in found if not yes)
    lines.append(f"not simulated {absent} (--json says why)")
    rate = "kept" if study.scene.indentation_rate else "dropped, as eq. 3 is printed"
    return [*lines, f"indentation rate in the force: {rate}"]


def _materials(study: Study) -> Iterator[tuple[bool, str]]:
    axes = axes_of(study.grid, "material")
    for label, material in study.materials.items():
        if not label or material != study.material:
            each = [parts.material for parts in study.parts(label, axes)]
            yield True, f"rheology{f' of {label}' if label else ''}: {_rheology(each)}"
    if not any(material.branches for material in study.materials.values()):
        yield False, "branches of relaxation: material.branches is not given"
    for label, material in study.materials.items():
        if material.description:
            yield True, f"branches{f' of {label}' if label else ''}: {material.description}"
    count = len(study.grid.get("temperature", ()))
    if count:
        yield True, f"{count} temperatures: all times shifted by {_law(study.material)}"
    elif study.material.shift_law:
        yield True, f"one temperature: all times shifted by {_law(study.material)}"
    else:
        yield False, "temperature: material.temperature and wlf are not given"


def _law(material: Material) -> str:
    """Return by what times shift with the temperature."""
    if material.shifts:
        size = f"{len(material.shifts.rows)} temperatures"
        return f"a table ({material.shifts.description or size})"
    return "WLF" if material.wlf else "the law of Arrhenius"


def _rheology(each: list[Material]) -> str:
    """Return what a material is; each : with every value of the axes that change it."""
    material = each[0]
    scales = [own.tau for own in each]
    ends = dict.fromkeys(f"{scale:.4g}" for scale in (min(scales), max(scales)))
    tau = f"tau = {' ... '.join(ends)} s"
    if not material.branches:
        return f"Kelvin element, {tau}"
    number = len(material.branches)
    kind = "standard linear solid" if number == 1 else f"Prony series of {number} branches"
    dashpot = "with a dashpot" if material.jumps else "without a dashpot"
    times = [own.shift_factor * time for own in each for _, time in own.branches]
    spread = f"times {min(times):.3g} ... {max(times):.3g} s"
    return f"{kind} {dashpot}, {spread}, {tau}"


def _surface(study: Study) -> Iterator[tuple[bool, str]]:
    surface = study.surface
    behind = {label or "study": own.body for label, own in study.surfaces.items()}
    if HALF_SPACE in behind.values():
        which = ", ".join(f"{label}: {body}" for label, body in behind.items())
        kelvin = any(not own.branches for own in study.materials.values())
        marched = f"; marched to steady sliding above v tau q_max = {MARCHED:g}"
        yield True, f"the surface as a map on a half-space ({which}){marched if kelvin else ''}"
    else:
        yield False, 'a half-space: scene.body is "foundation", a row of elements'
    if surface.profile is not None:
        lines, *samples = surface.profile.heights.shape
        what = "maps" if surface.body == HALF_SPACE else "lines"
        how = "as they are" if surface.lines == "measured" else f"{surface.lines} {what} like them"
        size = " x ".join(map(str, samples))
        yield True, f"measured {what}: {lines} of {size} samples, {how}"
        if surface.body != HALF_SPACE:
            why = (
                "a line that is cut from an isotropic surface has half the mean square slope of "
                f'its equivalent line; surface.lines is "{surface.lines}"'
            )
            yield surface.lines == "equivalent", f"conversion of cuts: {why}"
        return
    yield False, "measured lines: surface.file is not given; lines are random and self-affine"
    for name, value in (("rolloff", surface.rolloff), ("cutoff", surface.cutoff)):
        said = f"{value:.4g} m" if value else f"surface.{name} is not given"
        yield bool(value), f"{name}: {said}"


def _motion(study: Study) -> Iterator[tuple[bool, str]]:
    scene = study.scene
    if scene.programme:
        names = [NAMES[type(segment)] for segment in scene.programme]
        shown = ", ".join(names[:8]) + (", ..." if len(names) > 8 else "")
        again = f", {scene.repeat} times" if scene.repeat > 1 else ""
        yield True, f"programme from {scene.start}: {shown}{again}"
        if drive := scene.drive:
            pull = f"{drive.stiffness:g} N/m, {drive.mass:g} kg, {drive.damping:g} N s/m"
            yield True, f"drive: moves so, and pulls by {pull}"
        else:
            yield False, "drive: scene.drive is not given; the programme moves the line itself"
        for each in scene.sampled:
            yield True, f"programme sampled: {each}"
    else:
        yield False, "programme: there is no [[scene.programme]]; v1 steps to v2"
    if scene.control == "force":
        yield True, "constant normal force"
        yield False, 'prescribed indentation: scene.control is "force"'
    else:
        kind = "over time" if scene.indentation_history else "constant"
        yield False, 'constant normal force: scene.control is "indentation"'
        told = f" ({scene.indentation_description})" if scene.indentation_description else ""
        yield True, f"prescribed indentation, {kind}{told}"


def _quantities(study: Study) -> Iterator[tuple[bool, str]]:
    alone = study.realizations == 1 and not study.scene.listed
    for name, quantity in QUANTITIES.items():
        if name in study.scene.quantities:
            yield True, f"{name}: {quantity.effect}"
        else:
            reason = (
                unavailable_reason(name, study.scene, study.materials, alone)
                or "it is not asked for"
            )
            yield False, f"{name}: {reason}"
