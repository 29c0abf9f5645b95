"""A result is left as it is where a run would write the same again; kinds of records in it."""

import shutil

import netCDF4
import pytest
import xarray as xr

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.result.netcdf import change_note
from elastomer_friction.workflow.run import store_key
from elastomer_friction.workflow.run.failures import Failures
from elastomer_friction.workflow.run.grid_run import require_one
from elastomer_friction.workflow.run.store_key import is_unchanged, result_key
from elastomer_friction.workflow.store.store import Store, store_folder
from elastomer_friction.workflow.system import Maker, this_maker
from tests.support.faults import flipped
from tests.support.runs import run
from tests.support.shards import reopened
from tests.support.small import MAKER, cut_batches, random_result, small_plan, write_study

PLAN = small_plan()
BATCHES = list(cut_batches(PLAN, set(), 1e9))


@pytest.fixture
def copy(finished, tmp_path):
    """Return the result of the small study in a folder of the test, beside its store."""
    return shutil.copytree(finished.path.parent, tmp_path / "copy") / "small.nc"


def unchanged(result, plan=PLAN):
    """Return whether a run of a plan would leave a result as it is."""
    store = Store(store_folder(result))
    failures = Failures(store, plan, 0)
    return is_unchanged(plan, store, failures, result, store_key.missing_work(plan, failures))


def test_the_same_study_leaves_its_result_as_it_is(copy):
    assert unchanged(copy)


def cut_short(result):
    result.write_bytes(result.read_bytes()[:-100])


def spoil(result):
    """Spoil a number in the middle of the file; the checksum of its variable tells."""
    with xr.open_dataset(result) as dataset:
        number = dataset.mu_1.values.ravel()[1].tobytes()
    content = result.read_bytes()
    result.write_bytes(flipped(content, content.index(number)))


def of_another_program(result):
    result.write_bytes(b"not netCDF")


def in_place(change):
    """Return what edits an open result as netCDF4 does, with checksums that match again."""

    def edit(result):
        with netCDF4.Dataset(result, "a") as file:
            change(file)

    return edit


def doubled(file):
    """Double a number of the result."""
    file["mu_1"][:] = 2.0 * file["mu_1"][:]


EDITED = {
    "a number": in_place(doubled),
    "a comparison": in_place(lambda file: doubled(file["coarse"])),
    "a name": in_place(lambda file: file.renameVariable("mu_1", "mu_one")),
    "a unit": in_place(lambda file: file["mu_1"].setncattr("units", "%")),
    "the commit": in_place(lambda file: file.setncattr("commit", "0123")),
}


@pytest.mark.parametrize("change", EDITED.values(), ids=EDITED)
def test_an_edited_result_is_named_and_written_anew(copy, finished, change, capsys, tmp_path):
    study = write_study(tmp_path)
    commands = (["table", study, "--out", str(copy)], ["verify", str(copy.parent)])
    note = "was changed or replaced since a run wrote it"
    assert [main(command) for command in commands] == [0, 0]
    assert note not in "".join(capsys.readouterr())
    change(copy)
    assert [main(command) for command in commands] == [0, 3]
    out, err = capsys.readouterr()
    assert f"fault       {copy}: {note}" in out
    assert f"note: {copy}: {note}" in err
    assert not unchanged(copy)
    assert run(copy.parent).path.read_bytes() == finished.path.read_bytes()
    assert unchanged(copy)
    assert [main(command) for command in commands] == [0, 0]


def test_a_result_is_judged_by_a_store_beside_it_alone(copy, finished):
    assert not change_note(copy)
    copy.with_name("another.nc").write_bytes(copy.read_bytes())
    in_place(doubled)(copy.with_name("another.nc"))
    assert not change_note(copy.with_name("another.nc"))  # of a study that has no store
    alone = copy.parent.parent / "alone.nc"
    in_place(doubled)(shutil.copy(copy, alone))
    assert not change_note(alone)


SPOILT = [lambda result: result.unlink(), cut_short, spoil, of_another_program]


@pytest.mark.parametrize("change", SPOILT, ids=["missing", "short", "damaged", "another"])
def test_a_result_that_is_not_whole_is_written_anew(copy, finished, change):
    change(copy)
    assert not unchanged(copy)
    assert run(copy.parent).path.read_bytes() == finished.path.read_bytes()


@pytest.mark.parametrize(
    "setting", ["study.title=other", "study.realizations=8", "grid.velocity=0.03"]
)
def test_another_study_is_another_result(copy, setting):
    """Nothing of it is missing where it is a part of what is stored."""
    assert not unchanged(copy, small_plan(setting))


@pytest.mark.parametrize("name", ["our_sources", "package_versions"])
def test_other_code_is_another_result(copy, monkeypatch, name):
    monkeypatch.setattr(store_key, name, lambda: "another")
    assert not unchanged(copy)


def keys_of_stores(*stores):
    """Return the keys of results of the small plan from some stores."""
    return [result_key(PLAN, store, PLAN.expected) for store in stores]


def filled(folder, maker=MAKER):
    """Return a store of random records of the small plan."""
    folder.mkdir()
    store = reopened(folder)
    store.add([(batch, random_result(batch)._replace(maker=maker)) for batch in BATCHES])
    return store


def test_records_of_another_maker_and_failed_tasks_are_another_result(tmp_path):
    stores = [filled(tmp_path / name) for name in ("a", "b", "failed")]
    stores.append(filled(tmp_path / "made", MAKER._replace(processor="another")))
    stores[2].record_failure(PLAN.variants[0].tasks[0].key, "why")
    first, same, *others = keys_of_stores(*stores)
    assert first == same
    assert len({first, *others}) == 3


def test_how_it_is_run_is_no_part_of_it(copy):
    assert unchanged(copy, small_plan("cluster.patience=7"))


OTHER = Maker("python 3, numpy 3", "another processor")


def test_several_makers_are_refused_by_name_only_where_one_is_asked_for():
    require_one({MAKER, OTHER}, required=False)
    require_one({MAKER}, required=True)
    require_one(set(), required=True)
    with pytest.raises(UserError) as error:
        require_one({MAKER, OTHER}, required=True)
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
