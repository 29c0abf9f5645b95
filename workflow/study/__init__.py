"""The study described by the user: study.toml is read once and checked; the result is immutable.

Depends on the kernels for the names of schemes and spectra, and on no later stage.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .axes import ALL_AXES, COMMON_AXES, Parts, axes_of
    from .cluster import BATCH_SYSTEMS, LOCAL, THIS_MACHINE, Cluster, walltime_seconds
    from .columns import ColumnSpec, describe_columns, find_column, select_columns
    from .effects import (
        FOUNDATION,
        HALF_SPACE,
        MAX_SHIFT_DECADES,
        PROGRAMME_AXES,
        QUANTITIES,
        FromFile,
        HeatProperties,
        HoldSegment,
        Material,
        Oscillate,
        RampSegment,
        Scene,
        SceneEffects,
        Segment,
        Shear,
        SlideSegment,
        Spring,
        Velocity,
        accuracy_estimates,
        sampled_motion,
        shift_law_of,
        shift_of,
        shift_refusal,
        unavailable_reason,
    )
    from .measured import Measured
    from .moduli import FREQUENCIES, INCOMPRESSIBLE, MODULI, Moduli, read_moduli
    from .numerics import Numerics
    from .read import find_study, known_scales, known_studies, load_tables, read_scene, read_study
    from .schema import study_schema
    from .scripts import load_script
    from .settings import SHIFT_KEYS, Key, default_of, integer, positive, values_of
    from .study import MAX_BLOCKS, AnyStudy, Study, read_grid_study
    from .surfaces import (
        Profile,
        Surface,
        check_load,
        profile_of_array,
        read_measured_surface,
        rows_of_map,
    )
    from .tables import ALL_TABLES
    from .variants import COMPARE, changed_material

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
