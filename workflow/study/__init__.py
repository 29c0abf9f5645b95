"""What the user says: study.toml, read once, checked key by key, immutable from then on.

Knows the kernels' names of schemes and spectra, and no later stage.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.study.cluster import BATCH_SYSTEMS, HERE, LOCAL, Cluster, walltime_seconds
    from workflow.study.effects import (
        QUANTITIES,
        FromFile,
        Hold,
        Material,
        Oscillate,
        Programme,
        Ramp,
        Scene,
        Segment,
        Slide,
        Velocity,
        judged,
        velocity_steps,
        why_not,
        with_hold,
    )
    from workflow.study.grid import AXES
    from workflow.study.measured import Measured
    from workflow.study.moduli import FREQUENCIES, MODULI, Moduli, read_moduli
    from workflow.study.numerics import Numerics
    from workflow.study.read import find_study, known_scales, known_studies, read_scene, read_study
    from workflow.study.reference import (
        DescribedKey,
        Text,
        described_measures,
        described_tables,
        study_schema,
    )
    from workflow.study.scripts import load_script
    from workflow.study.settings import Rows, integer, named_unit, positive, rows_of_file
    from workflow.study.study import MOST_BLOCKS, AnyStudy, Study, read_grid_study
    from workflow.study.surfaces import Profile, Surface, check_load, given_profile
    from workflow.study.variants import COMPARE

__all__, __getattr__ = public_names(__name__, __file__)
