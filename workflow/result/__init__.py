"""The result file: declared variables, their dataset, provenance, netCDF.

The first room that knows xarray.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.result.dataset import Groups, build_dataset
    from workflow.result.netcdf import (
        BROKEN,
        ROOT,
        broken,
        check_result,
        differing_settings,
        listed,
        open_result,
        peek,
        result_file,
        write_datasets,
    )
    from workflow.result.provenance import made_by, origin
    from workflow.result.reference import DescribedVariable, described_variables
    from workflow.result.variables import AXIS_ATTRIBUTES, VARIABLES

__all__, __getattr__ = public_names(__name__, __file__)
