"""The command line: elastomer-friction plan|run|status|figure|table STUDY, and other commands.

It may import all other packages of the workflow. Some commands are functions of Python too.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .calls import draw_study, plan_study, read_block_means, run_study
    from .command_line import command_parser, main
    from .experiments import fit_moduli

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
