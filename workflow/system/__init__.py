"""Disk, process and terminal: what every stage needs of the machine below it.

Imports nothing of ours but errors.
"""

from typing import TYPE_CHECKING

from workflow.lazy import public_names

if TYPE_CHECKING:
    from workflow.system.compiling import saying_what_compiles
    from workflow.system.files import (
        append_durably,
        check_place,
        clear_leftovers,
        make_folder,
        read_whole,
        refused,
        replacing,
        sizes_in,
        write_durably,
    )
    from workflow.system.lock import LOCK, hold, holder
    from workflow.system.packages import (
        ROOT,
        Maker,
        our_sources,
        package_versions,
        processor,
        this_maker,
        version_of,
    )
    from workflow.system.patience import Patience
    from workflow.system.process import THREADS, Interrupt, keep_memory, peak_bytes
    from workflow.system.progress import Reporter, core_time, counted, duration
    from workflow.system.terminal import forgive_streams, program

__all__, __getattr__ = public_names(__name__, __file__)
