"""Disk, process and terminal: what every stage needs of the machine below it.

Imports nothing of ours but errors.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.system.files import (
        append_durably,
        clear_leftovers,
        make_folder,
        replacing,
        write_durably,
    )
    from workflow.system.lock import hold, holder
    from workflow.system.packages import ROOT, package_versions, processor, version_of
    from workflow.system.process import WORKER_ENVIRONMENT, Interrupt, peak_bytes
    from workflow.system.progress import Reporter, duration

__all__, __getattr__ = public_names(__name__, __file__)
