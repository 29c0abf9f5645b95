"""The result file: declared variables, their dataset, provenance, netCDF.

The first room that knows xarray.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.result.dataset import Groups, build_dataset
    from elastomer_friction.workflow.result.netcdf import (
        BROKEN,
        ROOT,
        broken,
        check_result,
        differing_settings,
        listed,
        open_result,
        open_tree,
        peek,
        result_file,
        write_datasets,
    )
    from elastomer_friction.workflow.result.provenance import made_by, origin
    from elastomer_friction.workflow.result.reference import DescribedVariable, described_variables
    from elastomer_friction.workflow.result.variables import AXIS_ATTRIBUTES, VARIABLES

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
