"""Stores filled with random results, and their records."""

from elastomer_friction.workflow.store.store import Store
from tests.support.small import cut_batches, random_result, small_plan

WORK = list(cut_batches(small_plan(), set(), 1e-9))  # batches of one task and one block
BATCH = next(cut_batches(small_plan(), set(), 1e9))  # a batch of four tasks and four blocks
SAMPLES = BATCH.recording.samples - 1


def records(batch):
    """Return the records of a batch, in the order of its arrays."""
    return [(t.key, batch.first_block + b) for t in batch.tasks for b in range(batch.blocks)]


def held(store):
    """Return all records (key, block) in the index of a store."""
    index = store.index
    return {
        (key, block)
        for key, parts in index.tasks.items()
        for part, _ in parts
        for known, block in index.rows
        if known == part
    }


def filled(folder, work):
    """Return a store with one shard per batch, of random results, and the results."""
    folder.mkdir(parents=True, exist_ok=True)
    store = Store(folder)
    results = [random_result(batch, seed) for seed, batch in enumerate(work)]
    for batch, result in zip(work, results, strict=True):
        store.add([(batch, result)])
    return store, results


def reopened(folder):
    """Return the store in a folder, repaired as at the start of a run."""
    store = Store(folder)
    store.prepare()
    return store


def assert_holds(store, batch, result):
    """Assert that the store returns the result bit for bit."""
    scalars, curves = store.read(records(batch), SAMPLES)
    assert scalars.tobytes() == result.scalars.tobytes()
    assert curves.tobytes() == result.curves.tobytes()


def contents(folder):
    """Return the bytes of the files in a folder by name."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def shard_of(store, batch):
    """Return the path of the shard with a batch."""
    return store.folder / f"{store.index.find(records(batch)[0])[0]}.npz"
