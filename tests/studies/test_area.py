"""The study of the real contact area at smoke scale, with finer maps."""

import pytest

from elastomer_friction.studies.area.measure import measure, table
from tests.support.studies import check_drawing

pytestmark = pytest.mark.exhaustive


def test_the_corrected_area_keeps_still_and_is_near_published_ones_where_a_count_falls():
    groups = measure({"maps": 2, "finest": 8}, 0, lambda _: None)
    data = groups[""].mean("map").sel(pressure=slice(0.01, 0.25))
    finest = data.area.isel(samples=-1)
    assert float(abs(data.area / finest - 1.0).max()) < 0.01
    excess = (data["count"] / finest - 1.0).sel(pressure=slice(0.01, 0.1))
    assert (excess.isel(samples=0) > 0.08).all()
    assert excess.values[:, 1:] / excess.values[:, :-1] == pytest.approx(0.5, abs=0.1)
    assert table(groups).ratio.to_numpy() == pytest.approx(0.95, abs=0.12)
    check_drawing("area", groups)
