"""Result files: declared variables, datasets, provenance and netCDF.

This is the lowest room that imports xarray.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .body_text import body_in_words, contact_warning, model_in_words, slope_warning
    from .dataset import Groups, build_dataset, in_si, model_source, units_of
    from .estimate_table import short_table
    from .netcdf import (
        BROKEN,
        ROOT,
        Peek,
        broken,
        change_note,
        check_result,
        differing_settings,
        listed,
        open_result,
        open_tree,
        peek,
        result_file,
        write_datasets,
    )
    from .provenance import maker_attributes, origin
    from .variables import declared

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
