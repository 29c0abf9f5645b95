"""The records that a worker computes, for bitwise comparison."""

from elastomer_friction.workflow.simulate.realizations import block_means


def by_record(work):
    """Return the scalars and the curve of every record as bytes, by (task key, block)."""
    by_key = {}
    for batch in work:
        scalars, curves, *_ = block_means(batch)
        for i, task in enumerate(batch.tasks):
            for j in range(batch.blocks):
                record = (task.key, batch.first_block + j)
                by_key[record] = (scalars[i, j].tobytes(), curves[i, j].tobytes())
    return by_key
