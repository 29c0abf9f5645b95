"""A shard: many batches as the bytes of one file, which tells by itself what it holds."""

import dataclasses

import netCDF4
import numpy as np

from elastomer_friction.workflow.store.store import Store
from tests.support.shards import WORK, assert_holds, records
from tests.support.small import random_result


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
