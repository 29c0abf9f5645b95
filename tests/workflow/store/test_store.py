"""The store and its shards: what goes in comes out bit for bit; a disk that refuses is reported."""

import dataclasses

import netCDF4
import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.store.store import Store
from tests.support.shards import BATCH, SAMPLES, WORK, assert_holds, filled, held, records, reopened
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


def test_one_shard_holds_many_batches(tmp_path):
    store = Store(tmp_path)
    work = [(batch, random_result(batch, seed)) for seed, batch in enumerate(WORK[:9])]
    store.add(work)
    assert len(list(tmp_path.glob("*.nc"))) == 1
    for again in (store, Store(tmp_path)):
        for batch, result in work:
            assert_holds(again, batch, result)


def test_batches_of_different_length_share_a_shard(tmp_path):
    longer = dataclasses.replace(WORK[1], recording=WORK[1].recording._replace(samples=40))
    work = [(batch, random_result(batch)) for batch in (WORK[0], longer)]
    store = Store(tmp_path)
    store.add(work)
    assert_holds(store, *work[0])
    _, curves = store.read(records(longer), 39)
    assert curves.tobytes() == work[1][1].curves.tobytes()


def test_numbers_that_netcdf_takes_for_missing_ones_come_back_bit_for_bit(tmp_path):
    result = random_result(WORK[0])
    result.scalars[..., 0] = result.curves[..., 0] = netCDF4.default_fillvals["f8"]
    result.scalars[..., 1] = np.nan
    store = Store(tmp_path)
    store.add([(WORK[0], result)])
    assert_holds(store, WORK[0], result)
    assert type(store.read(records(WORK[0]), 1)[0]) is np.ndarray
