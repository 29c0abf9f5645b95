"""The study described by the user: study.toml is read once and checked; the result is immutable.

Depends on the kernels for the names of schemes and spectra, and on no later stage.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .axes import ALL_AXES, COMMON_AXES, Parts, axes_of
    from .cluster import BATCH_SYSTEMS, LOCAL, THIS_MACHINE, Cluster, walltime_seconds
    from .columns import ColumnSpec, describe_columns, find_column, select_columns
    from .effects.heat_keys import HeatProperties
    from .effects.material import Material, shift_law_of, shift_of
    from .effects.motion_function import sampled_motion
    from .effects.programme import (
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
    from .effects.quantities import QUANTITIES, accuracy_estimates, unavailable_reason
    from .effects.scene import FOUNDATION, HALF_SPACE
    from .effects.scene_effects import SceneEffects
    from .effects.shearing import Shear
    from .effects.shifting import MAX_SHIFT_DECADES, shift_refusal
    from .measured import Measured
    from .moduli import FREQUENCIES, INCOMPRESSIBLE, MODULI, Moduli, read_moduli
    from .numerics import Numerics
    from .read import find_study, known_scales, known_studies, load_tables, read_scene, read_study
    from .schema import study_schema
    from .scripts import load_script
    from .settings import SHIFT_KEYS, Key, default_of, integer, positive, values_of
    from .study import MAX_BLOCKS, AnyStudy, Study, read_grid_study
    from .surfaces.profile import Profile, check_load, profile_of_array, rows_of_map
    from .surfaces.surface import Surface
    from .surfaces.table import read_measured_surface
    from .tables import ALL_TABLES
    from .variants import COMPARE, changed_material

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
