"""Access control: certificates on every connection, and no unprotected HTTP pages.

Without certificates, anyone who can connect to a port of dask can run code as its owner.
"""

import shlex
import ssl
from pathlib import Path
from typing import Any

from distributed.security import Security

from ..ground import UserError
from ..study import Cluster
from ..system import say, write_certificate

# Keys of the table [cluster] -> arguments of dask's Security.
TLS_FILES = {
    "tls_ca_file": "tls_ca_file",
    "tls_cert": "tls_client_cert",
    "tls_key": "tls_client_key",
}


def private_pages(security: Any, dashboard: bool) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return settings of dask without HTTP pages except the dashboard, and scheduler options.

    The HTTP port of the scheduler is reachable only from this machine. Without the dashboard it
    uses TLS: clients without certificate are refused at once.
    """
    settings: dict[str, Any] = {"distributed.worker.http.routes": []}
    if not dashboard:
        settings["distributed.scheduler.http.routes"] = []
        settings["distributed.scheduler.dashboard.tls.cert"] = security.tls_worker_cert
    return settings, {"dashboard": dashboard, "dashboard_address": "127.0.0.1:0"}  # any free port


class QuotedSecurity(Security):
    """A Security whose files of workers are quoted for the command line of a job."""

    def get_tls_config_for_role(self, role: str) -> dict[str, Any]:
        """Return the files of a role; dask-jobqueue writes those of workers unquoted."""
        files: dict[str, Any] = super().get_tls_config_for_role(role)
        if role != "worker":
            return files
        return {key: value and shlex.quote(value) for key, value in files.items()}


def new_security(folder: str, *, quoted: bool = False) -> Security:
    """Create a certificate for this run; return a Security that refuses connections without it.

    folder : private folder for the certificate and its key. quoted : whether the workers are jobs.
    ``Security.temporary`` is not used: its certificate is valid only from its creation, and fails
    if the clock is set back.
    """
    file = Path(folder) / "run.pem"
    write_certificate(file)
    parts = [f"tls_{r}_{p}" for r in ("client", "scheduler", "worker") for p in ("key", "cert")]
    kind = QuotedSecurity if quoted else Security
    return kind(require_encryption=True, **dict.fromkeys(["tls_ca_file", *parts], str(file)))


def security_of(cluster: Cluster) -> Security | None:
    """Return the Security of a running scheduler, or None with a warning if it does not use TLS.

    Certificates that are not given are those of dask's own configuration. Raises UserError if
    they are missing or cannot be used.
    """
    if not cluster.where.startswith("tls://"):
        say(
            f"warning: --scheduler {cluster.where}: neither encrypted nor authenticated: whoever "
            "reaches it can run code as you; start it with TLS (docs/cluster.md, Who may connect)"
        )
        return None
    files = {name: getattr(cluster, name) for name in TLS_FILES if getattr(cluster, name)}
    paths = {TLS_FILES[name]: str(Path(file).expanduser()) for name, file in files.items()}
    security: Any = Security(require_encryption=True, **paths)
    if not security.tls_ca_file:
        raise UserError(
            f"--scheduler {cluster.where}: needs cluster.tls_ca_file, cluster.tls_cert and "
            "cluster.tls_key, or dask's own configuration of TLS"
        )
    try:
        security.get_connection_args("client")
    except (OSError, ssl.SSLError) as error:
        keys = ", ".join(f"cluster.{name} = {file!r}" for name, file in files.items())
        raise UserError(f"{keys}: cannot be used for TLS: {error}") from error
    return security
