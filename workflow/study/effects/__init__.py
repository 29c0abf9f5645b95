"""Physical effects of a scene: material, programme and quantities.

Plain data in SI units with checks of valid combinations. Depends on no later stage.
"""

from typing import TYPE_CHECKING

from ...ground import public_names

if TYPE_CHECKING:
    from .heat_keys import HeatProperties
    from .material import MATERIAL, Material, read_material, shift_law_of, shift_of
    from .motion_function import sampled_motion
    from .programme import (
        FORCE,
        PROGRAMME_AXES,
        FromFile,
        HoldSegment,
        Oscillate,
        RampSegment,
        Scene,
        Segment,
        SlideSegment,
        Spring,
        Velocity,
    )
    from .quantities import (
        ELEMENT_QUANTITIES,
        QUANTITIES,
        accuracy_estimates,
        check_quantities,
        unavailable_reason,
    )
    from .scene import FOUNDATION, HALF_SPACE, SCENE, read_scene_table
    from .scene_effects import (
        EFFECT_TABLES,
        SceneEffects,
        check_effects,
        compared_effect_key,
        read_effects,
    )
    from .segment_keys import SEGMENTS
    from .shearing import Shear
    from .shifting import MAX_SHIFT_DECADES, SHIFTS, shift_refusal

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
