"""Presentation of results: figures, tables, claims of the paper, and the report.

This package only reads result files; it does not depend on a run.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .animation import animate, check_animation
    from .claims import (
        FACTOR,
        HOLDS,
        NOT_FOUND,
        ONLY_COARSE,
        TOLERANCE,
        Claim,
        NotGiven,
        Results,
        given,
        judge,
        judge_factor,
        mean_error,
        needed,
        per_point,
        percent,
        reworded,
        spread,
        typical_factor,
    )
    from .csv_tables import write_table
    from .explore import write_explorer
    from .figure import Picture, draw_figure, print_pictures, write_figure
    from .in_words import plus_minus, value_label, with_unit
    from .page import write_report
    from .panels import (
        COLOURS,
        band,
        error_band,
        error_bars,
        foot_line,
        legend_in_room,
        log_bars,
        write_below,
    )
    from .unresolved import not_resolved, without_unresolved

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
