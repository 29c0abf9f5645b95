"""Services of the operating system: files, locks, processes, packages and terminal output.

This package imports only the package ``ground`` of this program.
"""

from typing import TYPE_CHECKING

from ..ground import public_names

if TYPE_CHECKING:
    from .certificate import write_certificate
    from .compiling import COMPILING_MIB, report_compilation
    from .disk_retry import TEMPORARY_ERRORS, DiskRetry
    from .durable_files import (
        append_durably,
        check_place,
        clear_leftovers,
        digest_of,
        make_folder,
        read_whole,
        refused,
        replacing,
        sizes_in,
        write_durably,
    )
    from .event_loop import loop_without_ctrl_c
    from .lock import LOCK, hold, holder
    from .netcdf_sandbox import unreadable
    from .network import interface_named
    from .packages import (
        PROGRAM_ROOT,
        VERSION,
        Maker,
        Versions,
        import_dask,
        our_sources,
        own_versions,
        package_versions,
        processor,
        require,
        this_maker,
        version_of,
    )
    from .process import THREADS, Interrupt, keep_memory, peak_bytes, require_memory
    from .progress import Reporter, core_time, duration
    from .sandbox import limit_cpu_time, limit_memory, read_apart, requested_paths
    from .terminal import make_streams_tolerant, program
    from .watch import BEAT_SECONDS, NO_ANSWER, QUIET_SECONDS, Watch, say

__all__, __getattr__, __dir__ = public_names(__name__, __file__)
