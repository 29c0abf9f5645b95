"""What is asked for is simulated, and nothing else: runs of other scenes."""

import numpy as np

from tests.support.runs import run


def test_without_the_indentation_rate_little_is_left_to_relax(scheduler, tmp_path):
    where = ("grid.velocity=[0.1, 1.0]", "study.realizations=20")  # where much relaxes
    kept = run(scheduler, tmp_path, *where).load()
    dropped = run(scheduler, tmp_path, *where, "scene.indentation_rate=false").load()
    for name in ("mu_1", "mu_2", "jump", "indentation"):
        assert np.array_equal(kept[name], dropped[name])
    first, second = (abs(kept.deviation).isel(sample=i) for i in (0, 1))
    assert (second > 0.35 * first).all()
    first, second = (abs(dropped.deviation).isel(sample=i) for i in (0, 1))
    assert (second < 0.3 * first).all()
    relaxations, fewer = ((data.fit_status == 0).sum().item() for data in (kept, dropped))
    assert relaxations >= 6
    assert fewer < 0.5 * relaxations


def test_steady_sliding_alone_leaves_the_rest_out(scheduler, tmp_path):
    steady = run(scheduler, tmp_path, 'scene.quantities=["steady"]').load()
    assert {"mu_1", "mu_2"} < set(steady.data_vars)
    assert not {"jump", "mu", "fit_status", "alpha"} & set(steady.data_vars)
    assert "sample" not in steady.dims
