"""Key of a result, by which a run recognises a result that is up to date."""

import hashlib
from collections.abc import Container
from pathlib import Path

import numpy as np

from ..plan import Missing, Plan, missing_work
from ..result import Peek, peek
from ..simulate import Record
from ..store import Store
from ..system import our_sources, package_versions
from .status import study_digest

KEY_ATTRIBUTE = "key"  # attribute of the result file that holds the key


def result_key(plan: Plan, store: Store, blocks: dict[str, int]) -> str:
    """Return the key of a result. blocks : number of blocks by key of the task.

    The key depends on the study, the source code of the program, the versions of the packages, the
    keys and makers of the records, and the failed tasks.
    """
    digest = hashlib.sha256()
    makers = sorted(store.index.makers_of(blocks))
    digest.update(
        repr((study_digest(plan.study), our_sources(), package_versions(), makers)).encode()
    )
    for variant in plan.variants:
        task_keys = [
            f"{t.key}{0 if t.key in store.failed else blocks[t.key]}" for t in variant.tasks
        ]
        digest.update(
            variant.point_task.tobytes() + "\n".join([variant.label, *task_keys]).encode()
        )
    return digest.hexdigest()[:32]


def is_unchanged(
    plan: Plan, store: Store, settled: Container[Record], result: Path, missing: list[Missing]
) -> bool:
    """Return whether the existing result is up to date, so that a run would reproduce it.

    settled : records that are stored or belong to failed tasks. missing : missing records among
    the expected blocks.
    """
    rounds = plan.first != plan.expected
    if missing and not rounds:
        return False
    present = peek(result) if store.wrote(result) else None
    blocks = present and _blocks(plan, present)
    if not (present and blocks) or present.attributes.get(KEY_ATTRIBUTE) != result_key(
        plan, store, blocks
    ):
        return False
    return not (missing_work(plan, settled, blocks) if rounds else missing)


def _blocks(plan: Plan, present: Peek) -> dict[str, int] | None:
    """Return the number of blocks in a result by key of the task.

    Returns None if the result has another grid. Failed tasks keep the planned number.
    """
    blocks = dict(plan.first)
    for variant in plan.variants:
        counts = present.realizations.get(variant.label)
        if variant.study is not plan.study:
            counts = present.model_realizations
        if counts is None or counts.shape != variant.point_task.shape:
            return None
        task_blocks = np.zeros(len(variant.tasks), int)
        task_blocks[variant.point_task] = counts // variant.block_size
        pairs = zip(variant.tasks, task_blocks.tolist(), strict=True)
        blocks |= {task.key: count for task, count in pairs if count}
    return blocks
