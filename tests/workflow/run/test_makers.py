"""One kind of records, where one asks for it: nothing else is computed, and nothing is mixed."""

import pytest
import xarray as xr

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.run.grid_run import require_one
from elastomer_friction.workflow.store.store import store_folder
from elastomer_friction.workflow.system import Maker, this_maker
from tests.support.runs import run
from tests.support.shards import reopened
from tests.support.small import MAKER, cut_batches, random_result, small_plan

OTHER = Maker("python 3, numpy 3", "another processor")


def test_several_makers_are_refused_by_name_only_where_one_is_asked_for():
    require_one({MAKER, OTHER}, asked=False)
    require_one({MAKER}, asked=True)
    require_one(set(), asked=True)
    with pytest.raises(UserError) as error:
        require_one({MAKER, OTHER}, asked=True)
    said = str(error.value)
    assert said.startswith("--one-kind: records of 2 kinds would be mixed: ")
    for maker in (MAKER, OTHER):
        assert f"{maker.versions} on {maker.processor}" in said


def test_records_of_another_kind_are_marked_in_the_result_or_refused(tmp_path):
    store_folder(tmp_path / "small.nc").mkdir()
    store = reopened(store_folder(tmp_path / "small.nc"))
    batch = next(cut_batches(small_plan(), set(), 1e-9))
    store.add([(batch, random_result(batch)._replace(maker=OTHER))])
    with pytest.raises(UserError, match="--one-kind: records of 2 kinds would be mixed"):
        run(tmp_path, one_kind=True)
    assert not (tmp_path / "small.nc").exists()
    done = run(tmp_path)
    mine = this_maker()
    with xr.open_dataset(done.path) as data:
        texts = sorted((OTHER.versions, mine.versions))
        assert data.attrs["versions"] == f"mixed: {texts[0]} | {texts[1]}"
        texts = sorted((OTHER.processor, mine.processor))
        assert data.attrs["processor"] == f"mixed: {texts[0]} | {texts[1]}"
    with pytest.raises(UserError, match="--one-kind"):
        run(tmp_path, one_kind=True)
