"""Disk, process and terminal: what every stage needs of the machine below it.

Imports nothing of ours but errors.
"""

from typing import TYPE_CHECKING

from elastomer_friction.workflow.lazy import public_names

if TYPE_CHECKING:
    from elastomer_friction.workflow.system.compiling import saying_what_compiles
    from elastomer_friction.workflow.system.files import (
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
    from elastomer_friction.workflow.system.lock import LOCK, hold, holder
    from elastomer_friction.workflow.system.packages import (
        ROOT,
        VERSION,
        Maker,
        our_sources,
        package_versions,
        processor,
        this_maker,
        version_of,
    )
    from elastomer_friction.workflow.system.patience import Patience
    from elastomer_friction.workflow.system.process import (
        THREADS,
        Interrupt,
        keep_memory,
        peak_bytes,
    )
    from elastomer_friction.workflow.system.progress import Reporter, core_time, counted, duration
    from elastomer_friction.workflow.system.terminal import forgive_streams, program

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
