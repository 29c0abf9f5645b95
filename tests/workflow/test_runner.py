"""A run: the same bytes however it is cut, nothing computed twice, only what is asked."""

import numpy as np
import pytest

from tests.workflow.runs import PATIENCE, run, shards, start
from tests.workflow.shards import held
from tests.workflow.small import all_records, write_study
from workflow.errors import UserError
from workflow.store.store import Store, store_folder
from workflow.system.lock import hold


def test_a_run_computes_everything_and_says_so(finished):
    assert (finished.summary.reused, finished.summary.interrupted) == (0, False)
    assert finished.summary.batches >= len(shards(finished.path.parent)) > 0
    assert held(Store(store_folder(finished.path))) == set(all_records(finished.plan))


def test_result_holds_the_study_and_its_comparison(finished):
    for group, scheme in ((None, "exponential"), ("coarse", "implicit-euler")):
        dataset = finished.load(group)
        assert dataset.attrs["scheme"] == scheme
        assert dataset.mu_1.shape == (2, 2, 1, 1, 2, 1)
        assert (dataset.mu_1 > 0).all()


def test_nothing_but_result_and_store_is_left(finished):
    names = {path.name for path in finished.path.parent.iterdir()}
    assert names == {"small.nc", "small.status.json", "store"}


def test_other_batches_give_the_same_bytes(finished, scheduler, tmp_path):
    again = run(scheduler, tmp_path, batch_seconds=1e-4)
    assert again.summary.batches > 4 * finished.summary.batches
    assert again.path.read_bytes() == finished.path.read_bytes()


def test_one_worker_gives_the_same_bytes(finished, tmp_path):
    options = ["--out", str(tmp_path), "--workers", "1", "--batch-seconds", "1e-3"]
    process = start("run", write_study(tmp_path), *options)
    out, err = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0, err
    assert out.splitlines()[-1] == str(tmp_path / "small.nc")
    assert (tmp_path / "small.nc").read_bytes() == finished.path.read_bytes()


@pytest.fixture(scope="module")
def widened(scheduler, tmp_path_factory):
    """Return a first run, its shards, a wider run in the same folder, and one beside it."""
    folder = tmp_path_factory.mktemp("widened")
    first = run(scheduler, folder)
    before = shards(folder)
    wide = run(scheduler, folder, scale="wide")
    return first, before, wide, run(scheduler, tmp_path_factory.mktemp("fresh"), scale="wide")


def test_widening_the_grid_computes_only_what_is_new(widened):
    first, before, wide, fresh = widened
    assert wide.summary.reused == first.plan.records
    assert 0 < wide.summary.predicted < 0.9 * fresh.summary.predicted
    after = shards(wide.path.parent)
    assert {name: after[name] for name in before} == before
    assert len(after) > len(before)


def test_widened_run_gives_the_bytes_of_a_fresh_one(widened):
    _, _, wide, fresh = widened
    assert wide.path.read_bytes() == fresh.path.read_bytes()


def test_a_second_run_computes_nothing(widened, scheduler):
    wide = widened[2]
    before, content = shards(wide.path.parent), wide.path.read_bytes()
    again = run(scheduler, wide.path.parent, scale="wide")
    assert (again.summary.batches, again.summary.used) == (0, 0.0)
    assert again.summary.reused == wide.plan.records
    assert shards(wide.path.parent) == before
    assert wide.path.read_bytes() == content


def test_more_realizations_keep_the_first_ones(finished, scheduler, tmp_path):
    run(scheduler, tmp_path)
    more = run(scheduler, tmp_path, "study.realizations=6")
    assert more.summary.reused == finished.plan.records
    assert more.load().realizations.values.flat[0] == 6


def damage(victim, content):
    """Overwrite a shard; return the number of records it held."""
    name, store = victim.stem, Store(victim.parent)
    victim.write_bytes(content)
    return len(held(store)) - len({r for r in held(store) if store.index.find(r)[0] != name})


@pytest.mark.parametrize("length_kept", [False, True])
def test_records_of_a_damaged_shard_alone_are_computed_again(
    finished, scheduler, tmp_path, capsys, length_kept
):
    run(scheduler, tmp_path, batch_seconds=1e-4)
    before = shards(tmp_path)
    victim = tmp_path / "store" / sorted(before)[0]
    lost = damage(victim, bytes(victim.stat().st_size) if length_kept else b"")
    again = run(scheduler, tmp_path, batch_seconds=1e-4)
    assert again.summary.batches == lost > 0  # a record each
    after = shards(tmp_path)
    assert all(after[name] == before[name] for name in before if name != victim.name)
    assert again.path.read_bytes() == finished.path.read_bytes()
    assert "set aside" in capsys.readouterr().err


def test_a_folder_in_use_is_refused(finished, scheduler, tmp_path):
    with hold(tmp_path / "store"), pytest.raises(UserError, match="in use by process"):
        run(scheduler, tmp_path)
    assert not (tmp_path / "small.nc").exists()


def test_copies_of_a_problem_agree_bit_for_bit(scheduler, tmp_path):
    settings = ("grid.normal_force=[0.04, 0.08]", "grid.roughness=[1e-5, 2e-5]")
    copies = run(scheduler, tmp_path, *settings)
    assert copies.plan.problems * 4 == copies.plan.points * 3
    point = {"normal_force": [0.04, 0.08], "roughness": [1e-5, 2e-5]}
    one, two = (copies.load().isel(dict.fromkeys(point, i), drop=True) for i in (0, 1))
    for name in ("mu_1", "mu_2", "jump", "mu", "amplitude", "rms_slope", "indentation"):
        assert np.array_equal(two[name], 2.0 * one[name], equal_nan=True)
    for name in ("relaxation_rate", "contact_fraction", "time", "fit_status"):
        assert np.array_equal(two[name], one[name], equal_nan=True)


@pytest.mark.parametrize("factor", [2, 0.25])
def test_units_scaled_by_powers_of_two_agree_bit_for_bit(finished, scheduler, tmp_path, factor):
    names = {"shear_modulus": 1e7 * factor}
    settings = [f"material.{name}={value!r}" for name, value in names.items()]
    settings.append(f"grid.normal_force=[{0.04 * factor!r}, {0.4 * factor!r}]")
    scaled, own = run(scheduler, tmp_path, *settings).load(), finished.load()
    for name in own.data_vars:
        assert np.array_equal(scaled[name], own[name], equal_nan=True)


@pytest.fixture(scope="module")
def scenes(scheduler, tmp_path_factory):
    """Return results of the small study where much relaxes: with and without indentation rate."""
    folder = tmp_path_factory.mktemp("scenes")
    where = ("grid.velocity=[0.1, 1.0]", "study.realizations=20")
    kept = run(scheduler, folder, *where)
    return kept.load(), run(scheduler, folder, *where, "scene.indentation_rate=false").load()


def test_without_the_indentation_rate_steady_friction_and_jump_are_the_same(scenes):
    kept, dropped = scenes
    for name in ("mu_1", "mu_2", "jump", "indentation"):
        assert np.array_equal(kept[name], dropped[name])


def test_without_the_indentation_rate_the_jump_is_over_in_one_step(scenes):
    kept, dropped = (abs(dataset.deviation).isel(sample=[0, 1]) for dataset in scenes)
    assert (kept.isel(sample=1) > 0.35 * kept.isel(sample=0)).all()
    assert (dropped.isel(sample=1) < 0.3 * dropped.isel(sample=0)).all()


def test_without_the_indentation_rate_fewer_relaxations_are_found(scenes):
    kept, dropped = ((dataset.fit_status == 0).sum().item() for dataset in scenes)
    assert kept >= 6
    assert dropped < 0.5 * kept


def test_steady_sliding_alone_leaves_the_rest_out(finished, scheduler, tmp_path):
    steady = run(scheduler, tmp_path, 'scene.quantities=["steady"]').load()
    kept = {"mu_1", "mu_2", "indentation", "contact_fraction"}
    errors = {f"{name}_error" for name in kept}
    always = {"rms_slope", "speed_ratio", "realizations", "steps_per_spacing"}
    assert set(steady.data_vars) == kept | errors | always
    assert "sample" not in steady.dims
