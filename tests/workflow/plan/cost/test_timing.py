"""The measurement of how fast this machine runs the kernels."""

from workflow.plan.cost.timing import timings


def test_every_rate_is_measured():
    found = timings()
    for curve in found[:-1]:
        assert min(curve.seconds) > 0.0
        assert len(curve.sizes) == len(curve.seconds)
    assert found.case > 0.0
    assert found.draw.seconds[-1] > found.draw.seconds[0]  # 100 times the samples
