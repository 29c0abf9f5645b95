"""The store: what goes in comes out bit for bit, and a disk that refuses is reported."""

import dataclasses

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.store.store import Store
from tests.support.shards import BATCH, SAMPLES, WORK, filled, held, records, reopened
from tests.support.small import random_result


def test_results_come_back_bit_for_bit_in_any_order_and_company(tmp_path):
    alone = dataclasses.replace(BATCH, tasks=BATCH.tasks[1:2], first_block=4, blocks=2)
    elsewhere = [batch for batch in WORK if not set(records(batch)) & set(records(BATCH))]
    work = [BATCH, alone, *elsewhere[:6]]
    store, results = filled(tmp_path, work)
    wanted = [record for batch in work for record in records(batch)]
    scalars = np.concatenate([result.scalars.reshape(-1, len(SCALARS)) for result in results])
    curves = np.concatenate([result.curves.reshape(-1, SAMPLES) for result in results])
    order = np.random.default_rng(1).permutation(len(wanted))
    for again in (store, Store(tmp_path), reopened(tmp_path)):
        assert held(again) == set(wanted)
        found = again.read([wanted[i] for i in order], SAMPLES)
        assert found[0].tobytes() == scalars[order].tobytes()
        assert found[1].tobytes() == curves[order].tobytes()


def test_blocks_keep_their_numbers(tmp_path):
    later = dataclasses.replace(BATCH, first_block=7)
    store, _ = filled(tmp_path, [later])
    assert {block for _, block in held(store)} == {7, 8, 9, 10}
    assert (BATCH.tasks[0].key, 6) not in store
    assert (BATCH.tasks[0].key, 7) in store
    assert ("0" * 32, 7) not in store


def test_a_store_that_is_not_there_is_empty_and_not_made(tmp_path):
    assert held(Store(tmp_path / "store")) == set()
    assert list(tmp_path.iterdir()) == []


def test_nothing_but_shards_and_the_journal_is_left_in_the_folder(tmp_path):
    filled(tmp_path, WORK[:3])
    names = sorted(path.suffix or path.name for path in tmp_path.iterdir())
    assert names == [".nc"] * 3 + ["journal"]


def test_opening_reads_the_journal_and_no_shard(tmp_path, monkeypatch):
    filled(tmp_path, WORK[:5])
    monkeypatch.setattr(Store, "_load", None)
    assert len(held(reopened(tmp_path))) == 5


def test_folder_that_vanished_is_reported(tmp_path):
    store = Store(tmp_path / "store")
    with pytest.raises(UserError, match="cannot be written: No such file or directory"):
        store.add([(BATCH, random_result(BATCH))])
