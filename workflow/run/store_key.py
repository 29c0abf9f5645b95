"""What tells a result from any other: a run that would write the same one again leaves it."""

import hashlib
from collections.abc import Container
from pathlib import Path

import numpy as np

from ..plan import Missing, Plan, missing_work
from ..result import peek
from ..simulate import Record
from ..store import Store
from ..system import our_sources, package_versions
from .status import study_digest

KEY = "key"  # attribute of the result file


def result_key(plan: Plan, store: Store, blocks: dict[str, int]) -> str:
    """Return what a result of so many blocks of each task (by key) is known by.

    It follows from the study, all of our code, the packages that fit and write, the records and
    what computed them, and the tasks that failed. Records are known by the keys of their tasks.
    """
    digest = hashlib.sha256()
    makers = sorted(store.index.makers_of(blocks))
    digest.update(
        repr((study_digest(plan.study), our_sources(), package_versions(), makers)).encode()
    )
    for variant in plan.variants:
        told = [f"{t.key}{0 if t.key in store.failed else blocks[t.key]}" for t in variant.tasks]
        digest.update(variant.point_task.tobytes() + "\n".join([variant.label, *told]).encode())
    return digest.hexdigest()[:32]


def is_unchanged(
    plan: Plan, store: Store, settled: Container[Record], result: Path, missing: list[Missing]
) -> bool:
    """Return whether a result is there that a run would write the same again.

    settled : the records that are stored or of failed tasks. missing : of the blocks expected.
    """
    rounds = plan.first != plan.expected
    if missing and not rounds:
        return False
    found = peek(result) if store.wrote(result) else None
    blocks = found and _blocks(plan, found.realizations)
    if not (found and blocks) or found.attributes.get(KEY) != result_key(plan, store, blocks):
        return False
    return not (missing_work(plan, settled, blocks) if rounds else missing)


def _blocks(plan: Plan, realizations: dict[str, np.ndarray]) -> dict[str, int] | None:
    """Return the blocks of each task (by key) of a result with so many realizations at each point.

    None where it is of another grid. A task that failed counts as planned.
    """
    blocks = dict(plan.first)
    for variant in plan.variants:
        counts = realizations.get(variant.label)
        if counts is None or counts.shape != variant.point_task.shape:
            return None
        each = np.zeros(len(variant.tasks), int)
        each[variant.point_task] = counts // plan.study.realizations_per_block
        told = zip(variant.tasks, each.tolist(), strict=True)
        blocks |= {task.key: count for task, count in told if count}
    return blocks
