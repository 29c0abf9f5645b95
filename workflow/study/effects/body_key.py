"""The body behind the surface of the elastomer: what `scene.body` chooses."""

from functools import partial

from ..settings import Key, choice

FOUNDATION, HALF_SPACE = "foundation", "half-space"
BODIES = (FOUNDATION, HALF_SPACE)
BODY = Key(
    partial(choice, known=BODIES),
    "What is behind the surface. `foundation` is the paper's row of independent elements on a "
    "line; `half-space` is a deep elastic block on a periodic square of side `surface.length`, "
    "where each pressed point pulls down its neighbours (docs/bodies.md).",
    default=FOUNDATION,
)
