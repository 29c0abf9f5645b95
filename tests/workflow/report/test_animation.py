"""The animation of a scene: its frames, and refused scenes."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from PIL import Image, ImageChops, ImageSequence

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.report import animate

STEPS, ELEMENTS = 4, 40


def sliding_scene() -> xr.Dataset:
    """Return snapshots of a wavy line that moves over a foundation without memory."""
    x = np.linspace(0.0, 1e-4, ELEMENTS, endpoint=False)
    shift = np.arange(STEPS)[:, None] * 1e-5
    height = 1e-6 * (np.cos(2e5 * np.pi * (x - shift) / 10.0) + 0.2)
    return xr.Dataset(
        {
            "snapshot_height": (("event", "x"), height),
            "snapshot_displacement": (("event", "x"), np.minimum(height, 0.0)),
            "trace_mu": ("event", np.linspace(0.1, 0.2, STEPS)),
            "trace_time": ("event", np.linspace(0.0, 1.0, STEPS)),
        },
        coords={"x": x},
    )


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the animation of a sliding scene, in a folder of its own."""
    path = tmp_path_factory.mktemp("animated") / "scene.gif"
    assert animate(sliding_scene(), path) == path
    return path


@pytest.fixture(scope="module")
def frames(path: Path) -> list[Image.Image]:
    """Return the frames of the animation."""
    with Image.open(path) as opened:
        return [frame.convert("RGB") for frame in ImageSequence.Iterator(opened)]


def test_there_is_a_frame_for_each_snapshot_and_both_halves_move(frames):
    assert len(frames) == STEPS
    width, height = frames[0].size
    for part in ((0, 0, width, height // 2), (0, 3 * height // 4, width, height)):
        before, after = frames[0].crop(part), frames[3].crop(part)
        assert ImageChops.difference(before, after).getbbox() is not None


def test_the_axes_lie_over_the_contact_and_over_the_friction(frames):
    pixels = np.asarray(frames[0].convert("L"))
    lines = np.flatnonzero((pixels < 64).mean(axis=1) > 0.8) / len(pixels)
    np.testing.assert_allclose(np.unique(lines.round(1)), [0.5, 0.9])


def test_no_file_is_left_beside_the_animation(path):
    assert list(path.parent.iterdir()) == [path]


@pytest.mark.parametrize(
    ("file", "missing", "words"),
    [
        ("scene.gif", ["snapshot_displacement"], "snapshot_displacement; request the quantities"),
        ("scene.png", [], r"scene\.png: must end in \.gif or \.mp4"),
        ("scene.mp4", [], "needs the program ffmpeg"),
    ],
)
def test_scenes_that_cannot_be_drawn_are_refused(monkeypatch, file, missing, words):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(UserError, match=words):
        animate(sliding_scene().drop_vars(missing), Path(file))
