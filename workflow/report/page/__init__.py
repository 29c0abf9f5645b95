"""The report: one self-contained page about the results of a folder.

What of a study is shown, how it is said in HTML, and where a pointer finds its points.
"""

from typing import TYPE_CHECKING

from ...lazy import public_names

if TYPE_CHECKING:
    from .report import study_names, write_report

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
