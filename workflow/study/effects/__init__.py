"""What a scene can call for, as the user describes it: material, programme, quantities.

Plain data in SI units with the checks of what goes together; knows no later stage.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.study.effects.material import (
        MATERIAL,
        WLF,
        Material,
        Wlf,
        read_material,
    )
    from elastomer_friction.workflow.study.effects.needs import check_quantities, why_not
    from elastomer_friction.workflow.study.effects.programme import (
        FromFile,
        Hold,
        Oscillate,
        Programme,
        Ramp,
        Segment,
        Slide,
        Velocity,
        velocity_steps,
        with_hold,
    )
    from elastomer_friction.workflow.study.effects.quantities import QUANTITIES, judged
    from elastomer_friction.workflow.study.effects.scene import SCENE, Scene, read_scene
    from elastomer_friction.workflow.study.effects.segments import HOLD, OSCILLATE, RAMP, SLIDE

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
