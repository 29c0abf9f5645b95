"""A study of one point, computed in this process."""

from tests.workflow.scene.scenes import run, slide


def test_the_dataset_has_no_grid_and_its_provenance():
    found = run(
        slide(), quantities=["steady", "relaxation", "peak"], programme=[slide(), slide(0.2)]
    )
    assert "hurst" not in found.coords  # a measured line has none
    assert found.normal_force.dims == ()
    assert found.attrs["lines"].startswith("given from Python")
    assert {"code", "commit", "versions", "study"} <= found.attrs.keys()
    assert found.relaxation_rate.attrs["units"] == "s-1"
    assert "alpha" not in found
    assert "power_spectrum" in found
