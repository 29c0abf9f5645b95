"""What a scene can call for, as the user describes it: material, programme, quantities.

Plain data in SI units with the checks of what goes together; knows no later stage.
"""

from typing import TYPE_CHECKING

from ...ground import public_names

if TYPE_CHECKING:
    from .body_key import BODY, FOUNDATION, HALF_SPACE
    from .drive_keys import DRIVE, Spring
    from .material import MATERIAL, Material, read_material, shift_law_of, shift_of
    from .programme import (
        LISTED,
        FromFile,
        HoldSegment,
        Oscillate,
        RampSegment,
        Segment,
        SlideSegment,
        Velocity,
        velocity_steps,
        with_one_of,
    )
    from .quantities import FORCE, OF_ELEMENTS, QUANTITIES, judged
    from .scene import SCENE, Scene, check_quantities, read_scene_table, why_not
    from .segments import FILE, HOLD, OSCILLATE, PULL, RAMP, SLIDE
    from .shifting import (
        ARRHENIUS,
        GAS,
        LAWS_OF_SHIFT,
        MOST_SHIFT,
        SHIFTS,
        WLF,
        Arrhenius,
        ShiftLaw,
        ShiftTable,
        Wlf,
        inverse_temperature,
    )

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
