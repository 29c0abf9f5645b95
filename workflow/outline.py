"""What `plan` prints: what a study would do, simulate and cost."""

from pathlib import Path

from workflow.plan import Plan, batches, without_similarity
from workflow.progress import duration
from workflow.study import AXES, QUANTITIES

EFFECTS = {
    "steady": "steady sliding at v1 and v2 (no time marching)",
    "jump": "jump at t0+ (no time marching)",
    "relaxation": "relaxation after the jump (time marching)",
    "models": "fits beyond eq. 6 (no further simulation)",
}


def outline(plan: Plan, result: Path, speed: str) -> list[str]:
    """Return the description of a plan, line by line.

    speed : says where the rates of the prediction come from.
    """
    study = plan.study
    lines = [f"study       {study.name}: {study.title}", f"result      {result}"]
    for axis in AXES:
        values = study.grid[axis]
        span = f"{values[0]:g}" if len(values) == 1 else f"{min(values):g} ... {max(values):g}"
        lines.append(f"  {axis:14s}{len(values):4d}  {span}")
    copies = plan.points / plan.problems
    runs = plan.problems * len(plan.variants) * study.realizations
    lines += [
        f"points      {plan.points}",
        f"problems    {plan.problems} distinct dimensionless problems ({copies:.3g} points each)",
        f"variants    {', '.join(v.label or 'study' for v in plan.variants)}",
        f"realizations {study.realizations} each, {runs} in all",
    ]
    for quantity in QUANTITIES:
        asked = "simulated" if quantity in study.scene.quantities else "not simulated"
        lines.append(f"{asked:14s}{EFFECTS[quantity]}")
    rate = "kept" if study.scene.indentation_rate else "dropped, as eq. 3 is printed"
    lines.append(f"indentation rate in the force: {rate}")
    return lines + _costs(plan, speed)


def _costs(plan: Plan, speed: str) -> list[str]:
    seconds = sum(batch.seconds for batch in batches(plan, set()))
    return [
        f"predicted   {duration(seconds)} of one core; without the similarity "
        f"{duration(without_similarity(plan, seconds))}",
        f"speed       as measured on {speed}",
        f"memory      {plan.predicted_worker_bytes() / 2**20:.0f} MiB per worker, "
        f"{plan.predicted_driver_bytes() / 2**20:.0f} MiB in the driver, "
        f"longest line {plan.longest_line()} samples",
    ]
