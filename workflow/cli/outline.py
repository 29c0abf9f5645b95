"""The output of `plan`: the work, cost and predicted errors of a study."""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ...kernels import MAX_REMEMBERED, programme_extent
from ..ground import UserError, counted
from ..plan import (
    COST_FACTOR,
    MapChoice,
    Plan,
    Variant,
    line_slope,
    map_choices,
    predicted_errors,
    remembered_share,
)
from ..reduce import MAX_THEORY_TASKS, persson_values
from ..result import contact_warning, model_source, slope_warning
from ..simulate import total_steps
from ..study import HALF_SPACE, QUANTITIES, Measured, Study, unavailable_reason
from ..system import COMPILING_MIB, core_time
from .run_options import announced_plan

MODEL_LINE = "model       ratio of mu_1 to that of the other body: "
Outline = tuple[list[str], dict[str, Any]]  # lines to print, and data for --json


def outline_grid(study: Study, result: Path, sample_seconds: float | None = None) -> Outline:
    """Return the work and cost of a study of a grid.

    sample_seconds : time to spend on timing random batches, s; None: time no batches.
    """
    plan = announced_plan(study)
    predicted, cost = _predicted(plan.predicted_seconds())
    absent, choices = absent_effects(study), map_choices(plan)
    if plan.other_body is not None:
        absent.pop("model_ratio", None)  # computed without being requested
    facts = {
        "axes": {  # None replaces NaN, which marks an axis without a value and which JSON lacks
            axis: [None if math.isnan(v) else v for v in values]
            for axis, values in study.grid.items()
        },
        "quantities": study.scene.quantities,
        "read": _files_read(study),
        "points": plan.points,
        "problems": plan.problems,
        "variants": list(study.variants),
        "realizations": plan.records * study.realizations_per_block,
        "records": plan.records,
        **cost,
        "predicted_worker_bytes": round(plan.predicted_worker_bytes()),
        "predicted_driver_bytes": round(plan.predicted_driver_bytes()),
        "longest_line_samples": plan.longest_line(),
        "choices": [choice._asdict() for choice in choices],
        "not_simulated": absent,
    }
    lines = [
        f"study       {study.name}: {study.title}",
        f"result      {result}",
        f"computes    {', '.join(study.scene.quantities)}",
        f"body        {study.body_choice}",
        *_axes(study),
        f"points      {plan.points}, {plan.problems} distinct problems",
        *_realizations(plan),
        *map(steps_line, plan.variants),
        predicted,
        *_sampled(plan, sample_seconds, facts),
        f"memory      {plan.predicted_worker_bytes() / 2**20:.0f} MiB per worker, "
        f"{plan.predicted_driver_bytes() / 2**20:.0f} MiB in the driver, {COMPILING_MIB} MiB more "
        f"to compile; {_largest_surface(plan)} samples",
        *map(_choice, choices),
        *_errors(plan),
        *([MODEL_LINE + model_source(plan)] if "steady" in study.scene.quantities else []),
        *_repeated_contact(plan),
        *_steep_slopes(plan),
        *_shear(plan),
        f"material    {study.material.rheology()}",
        *(f"read        {kind}: {description}" for kind, description in study.descriptions),
        f"not simulated {', '.join(absent)} (--json gives the reasons)",
    ]
    return lines, facts


def outline_measured(study: Measured, result: Path, sample_seconds: float | None = None) -> Outline:
    """Return the measurements of a study and their predicted time, without measuring."""
    if sample_seconds is not None:
        raise UserError(f"--sample: {study.name} is not made of batches to sample; leave it out")
    lines, seconds = study.script.outline(study.settings)
    predicted, cost = _predicted(seconds)
    head = f"study       {study.name}: {study.title}", f"result      {result}"
    return [*head, *lines, predicted], {"outline": lines, **cost}


def _predicted(seconds: float) -> tuple[str, dict[str, Any]]:
    low, high = seconds / COST_FACTOR, seconds * COST_FACTOR
    facts = {"predicted_core_seconds": seconds, "predicted_core_seconds_interval": [low, high]}
    return f"predicted   {core_time(low, high)}", facts


def _largest_surface(plan: Plan) -> str:
    """Return the size of the longest line, or of the largest map."""
    largest = max(plan.variants, key=lambda variant: variant.longest)
    samples = largest.longest
    if largest.lines.body != HALF_SPACE or largest.tasks[0].problem.surface.flat:
        return f"longest line {samples}"
    return f"largest map {math.isqrt(samples)} x {math.isqrt(samples)}"


def _choice(choice: MapChoice) -> str:
    """Return the line on the time, memory and error of a number of steps per spacing."""
    steps, seconds, worker_bytes, bias, chosen = choice
    return (
        f"{'choice' if chosen else 'or':12s}m = {steps}: {seconds / 60.0:.2g} core-minutes, "
        f"{worker_bytes / 2**20:.0f} MiB per worker, bias below {_two_digits(100.0 * bias)} %"
    )


def _sampled(plan: Plan, seconds: float | None, facts: dict[str, Any]) -> list[str]:
    """Return the line of the sampled cost, and add the cost to ``facts``."""
    if seconds is None:
        return []
    from ..run import sample_cost  # slow to import, and not needed by other plans

    sample = sample_cost(plan, seconds)
    facts |= {"sampled_core_seconds": sample.seconds, "samples": sample.draws}
    facts["sampled_core_seconds_error"] = sample.error
    return [f"sampled     {sample}"]


def _range(values: np.ndarray, digits: int = 4) -> str:
    if np.isnan(values).any():  # an axis whose value measured lines determine
        return "of the surface"
    low, high = f"{values.min():.{digits}g}", f"{values.max():.{digits}g}"
    return low if low == high else f"{low} ... {high}"


def _axes(study: Study) -> Iterator[str]:
    """Yield a line per axis of the grid; a nominal pressure replaces the force that it gives."""
    for axis, values in study.grid.items():
        name, shown = axis, values
        if axis == "normal_force" and study.pressures:
            name, shown = "normal_pressure", study.pressures
        yield f"  {name:16s}{len(shown):4d}  {_range(np.array(shown), 6)}"


def _realizations(plan: Plan) -> Iterator[str]:
    """Yield a line on the number of realizations, and one per variant with an accuracy goal."""
    study, block_size = plan.study, plan.study.realizations_per_block
    total = plan.records * block_size
    if not any(variant.goals for variant in plan.variants):
        whole = "in all" if plan.other_body is None else "in all, with those of the other body"
        yield f"realizations {study.realizations} each{study.rounding}, {total} {whole}"
        return
    yield f"realizations {total} in all, predicted; rounds add more until the accuracy is met"
    for variant in plan.variants:
        cap = variant.numerics.max_realizations
        counts = np.array([plan.expected[task.key] * block_size for task in variant.tasks])
        capped = f"{np.sum(counts + block_size > cap)} of {counted(counts.size, 'problem')}"
        if variant.goals:
            wanted = f"{variant.numerics.accuracy:g} {variant.label}"
            yield f"accuracy    {wanted}: {_range(counts)} realizations each; {capped} reach {cap}"


def steps_line(variant: Variant) -> str:
    """Return the line on the steps per spacing and the steps of the marches of a variant."""
    steps = np.array([task.steps_per_spacing for task in variant.tasks])
    march = np.array([task.march_steps for task in variant.tasks])
    if variant.recording.requested:
        march = march + [total_steps(t.problem, t.steps_per_spacing) for t in variant.tasks]
    marched = f"marches of {_range(march)} steps" if march.any() else "no march"
    return f"steps       {variant.label or 'study'}: {_range(steps)} per spacing, {marched}"


def _errors(plan: Plan) -> Iterator[str]:
    """Yield a line per estimate with the median and the largest predicted errors."""
    errors = predicted_errors(plan)
    if not errors:
        yield "errors      unknown before the run: see NAME_error and NAME_bias of the result"
    for name, error in errors.items():
        bias = "unknown before the run"
        if not np.isnan(error.discretisation).all():
            bias = f"below {_percent(error.discretisation)}"
        yield f"errors      {name}: standard error {_percent(error.chance)}, discretisation {bias}"


def _percent(errors: np.ndarray) -> str:
    median, largest = (min(100.0 * float(e), 100.0) for e in (np.median(errors), errors.max()))
    return f"{_two_digits(median)} % (largest {_two_digits(largest)} %)"


def _two_digits(number: float) -> str:
    """Return a number rounded to two digits, without an exponent from 0.0001 to 10 000."""
    return f"{float(f'{number:.2g}'):g}"


def _repeated_contact(plan: Plan) -> list[str]:
    """Return a line if traces meet their first contact again every period, else none."""
    tasks = plan.variants[0].tasks if plan.variants[0].recording.requested else []
    shares = [remembered_share(task.problem) for task in tasks]
    if max(shares, default=0.0) <= MAX_REMEMBERED:
        return []
    problem = tasks[int(np.argmax(shares))].problem
    length = programme_extent(problem.programme)[0] / problem.elements * plan.study.surface.length
    return [
        f"periodic    a slow branch holds {max(shares):.0%} of the first contact after one period; "
        f'take a surface.length of {length:.3g} m, or scene.start = "steady"'
    ]


def _steep_slopes(plan: Plan) -> Iterator[str]:
    """Yield a warning for each variant with an rms slope above one."""
    for variant in plan.variants:
        lines, roughness = variant.lines, max(variant.study.grid["roughness"])
        problems = [task.problem for task in variant.tasks]
        slopes = [line_slope(p, lines.normalisation) * p.elements for p in problems]
        period = lines.length if lines.profile is None else lines.profile.length
        if warning := slope_warning(float(max(slopes)) * roughness / period):
            yield f"warning     {variant.label or 'study'}: {warning}"


def _shear(plan: Plan) -> Iterator[str]:
    """Yield a line on the shear of each variant, with a warning of an unresolved surface.

    The real contact area is that by Persson's theory.
    """
    for variant in plan.variants:
        shear = variant.study.effects[variant.label].shear
        if shear is None:
            continue
        tasks = variant.tasks[:MAX_THEORY_TASKS]
        roughness = variant.study.grid["roughness"][0]
        theory = persson_values(tasks, variant.lines, roughness)
        area = float(theory["area_persson"].max())
        warning = contact_warning(variant.lines, area)
        yield f"shear       {variant.label or 'study'}: {shear.in_words()}"
        if warning:
            yield f"warning     {variant.label or 'study'}: {warning} (area by Persson's theory)"


def _files_read(study: Study) -> list[dict[str, Any]]:
    """Return descriptions of the files read, with the sizes of measured profiles (lengths in m)."""
    files: list[dict[str, Any]] = [
        {"what": kind, "told": text} for kind, text in study.descriptions
    ]
    profiles = {surface.description: surface.profile for surface in study.surfaces.values()}
    for file in files:
        if (profile := profiles.get(file["told"])) is not None:
            lines, *samples = profile.heights.shape
            file |= {"lines": lines, "samples": samples, "step": profile.spacing}
            file |= {"roughness": profile.roughness, "rms_slope": profile.slope}
    return files


def absent_effects(study: Study) -> dict[str, str]:
    """Return the effects that are not simulated, as name -> reason."""
    scene, surface, materials = study.scene, study.surface, study.materials
    bodies = {entry.body for entry in study.surfaces.values()}
    shifted = study.material.shift_law or "temperature" in study.grid
    force, control = scene.control == "force", f'scene.control is "{scene.control}"'
    branches = any(material.branches for material in materials.values())
    rows = [
        ("branches of relaxation", branches, "material.branches is not given"),
        ("temperature", shifted, "material.temperature and a shift law are not given"),
        ("half-space", HALF_SPACE in bodies, 'scene.body is "foundation"'),
        ("measured lines", surface.profile, "surface.file is not given"),
        ("shear", any(e.shear for e in study.effects.values()), "scene.shear is not given"),
        ("rolloff", surface.rolloff, "surface.rolloff is not given"),
        ("cutoff", surface.cutoff, "surface.cutoff is not given"),
        ("programme", scene.programme, "there is no [[scene.programme]]; v1 steps to v2"),
        ("drive", scene.drive, "scene.drive is not given"),
        ("prescribed indentation", not force, control),
        ("constant normal force", force, control),
        ("indentation rate in the force", scene.indentation_rate, "as eq. 3 is printed"),
    ]
    alone = study.realizations == 1 and not scene.listed
    for name in QUANTITIES:
        reason = unavailable_reason(name, scene, materials, alone) or "it is not requested"
        rows.append((name, name in scene.quantities, reason))
    return {name: reason for name, simulated, reason in rows if not simulated}
