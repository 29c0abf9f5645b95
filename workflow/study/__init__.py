"""What the user says: study.toml, read once, checked key by key, immutable from then on.

Knows the kernels' names of schemes and spectra, and no later stage.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.study.cluster import (
        BATCH_SYSTEMS,
        HERE,
        LOCAL,
        Cluster,
        walltime_seconds,
    )
    from elastomer_friction.workflow.study.effects import (
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
    from elastomer_friction.workflow.study.grid import AXES
    from elastomer_friction.workflow.study.measured import Measured
    from elastomer_friction.workflow.study.moduli import FREQUENCIES, MODULI, Moduli, read_moduli
    from elastomer_friction.workflow.study.numerics import Numerics
    from elastomer_friction.workflow.study.read import (
        find_study,
        known_scales,
        known_studies,
        read_scene,
        read_study,
    )
    from elastomer_friction.workflow.study.reference import (
        DescribedKey,
        Text,
        described_measures,
        described_tables,
        study_schema,
    )
    from elastomer_friction.workflow.study.scripts import load_script
    from elastomer_friction.workflow.study.settings import (
        Rows,
        integer,
        named_unit,
        positive,
        rows_of_file,
    )
    from elastomer_friction.workflow.study.study import (
        MOST_BLOCKS,
        AnyStudy,
        Study,
        read_grid_study,
    )
    from elastomer_friction.workflow.study.surfaces import (
        Profile,
        Surface,
        check_load,
        given_profile,
    )
    from elastomer_friction.workflow.study.variants import COMPARE

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
