"""The result file: declared variables, their dataset, provenance, netCDF.

The first room that knows xarray.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .dataset import Groups, build_dataset
    from .netcdf import (
        BROKEN,
        ROOT,
        broken,
        check_result,
        differing_settings,
        edited,
        listed,
        open_result,
        open_tree,
        peek,
        result_file,
        write_datasets,
    )
    from .provenance import made_by, origin

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
