"""The records that a worker computes, to be compared to the bit."""

from elastomer_friction.workflow.simulate.realizations import block_means


def by_record(work):
    """Return the numbers of every record, as bytes."""
    actual = {}
    for batch in work:
        scalars, curves, *_ = block_means(batch)
        for i, task in enumerate(batch.tasks):
            for j in range(batch.blocks):
                record = (task.key, batch.first_block + j)
                actual[record] = (scalars[i, j].tobytes(), curves[i, j].tobytes())
    return actual
