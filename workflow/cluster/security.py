"""Access control: certificates on every connection, and no unprotected HTTP pages.

Without certificates, anyone who can connect to a port of dask can run code as its owner.
"""

import ssl
import sys
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import dask
from distributed.security import Security

from ..ground import UserError
from ..study import Cluster

ENCRYPTED = "tls://"
CREDENTIALS = ("key", "cert")
# Keys of the table [cluster] -> arguments of dask's Security.
TLS_FILES = {
    "tls_ca_file": "tls_ca_file",
    "tls_cert": "tls_client_cert",
    "tls_key": "tls_client_key",
}
# Validity of a certificate after and before its creation, as clocks differ or are set back.
VALIDITY, CLOCK_MARGIN = timedelta(days=365), timedelta(days=2)


def scheduler_options(dashboard: bool) -> dict[str, Any]:
    """Return options of a scheduler whose HTTP port is reachable only from this machine."""
    return {"dashboard": dashboard, "dashboard_address": "127.0.0.1:0"}  # 0: any free port


def no_pages(security: Any, dashboard: bool) -> dict[str, Any]:
    """Return settings of dask that disable all HTTP pages except the dashboard.

    Without the dashboard, the HTTP port uses TLS: clients without certificate are refused at once.
    """
    workers: dict[str, Any] = {"distributed.worker.http.routes": []}
    if dashboard:
        return workers
    tls = {"distributed.scheduler.dashboard.tls.cert": security.tls_worker_cert}
    return workers | tls | {"distributed.scheduler.http.routes": []}


def new_security(folder: str) -> Security:
    """Create a certificate for this run; return a Security that refuses connections without it.

    folder : private folder for the certificate and its key. ``Security.temporary`` is not used:
    its certificate is valid only from its creation, and fails if the clock is set back.
    """
    from cryptography import x509
    from cryptography.hazmat.primitives import hashes, serialization
    from cryptography.hazmat.primitives.asymmetric import rsa

    key = rsa.generate_private_key(public_exponent=65537, key_size=2048)
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "elastomer-friction")])
    now = datetime.now(UTC)
    certificate = (
        x509.CertificateBuilder(name, name, key.public_key(), x509.random_serial_number())
        .not_valid_before(now - CLOCK_MARGIN)
        .not_valid_after(now + VALIDITY)
        .sign(key, hashes.SHA256())
    )
    formats = serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    private = key.private_bytes(serialization.Encoding.PEM, *formats)
    file = Path(folder) / "run.pem"
    file.touch(0o600)
    file.write_bytes(private + certificate.public_bytes(serialization.Encoding.PEM))
    parts = [
        f"tls_{who}_{part}" for who in ("client", "scheduler", "worker") for part in CREDENTIALS
    ]
    return Security(require_encryption=True, **dict.fromkeys(["tls_ca_file", *parts], str(file)))


def security_of(cluster: Cluster) -> Security | None:
    """Return the Security of a running scheduler, or None with a warning if it does not use TLS.

    Raises UserError if the certificates are missing or cannot be used.
    """
    if not cluster.where.startswith(ENCRYPTED):
        print(
            f"warning: --scheduler {cluster.where}: neither encrypted nor authenticated: anyone "
            "who reaches it can run code as you; start it with TLS "
            "(docs/cluster.md, Who may connect)",
            file=sys.stderr,
        )
        return None
    if not (cluster.tls_ca_file and cluster.tls_cert):
        if dask.config.get("distributed.comm.tls.ca-file"):
            return Security(require_encryption=True)  # with dask's own configuration
        raise UserError(
            f"--scheduler {cluster.where}: needs cluster.tls_ca_file, cluster.tls_cert and "
            "cluster.tls_key, or dask's own configuration of TLS"
        )
    files = {name: getattr(cluster, name) for name in TLS_FILES if getattr(cluster, name)}
    paths = {TLS_FILES[name]: str(Path(file).expanduser()) for name, file in files.items()}
    security = Security(require_encryption=True, **paths)
    try:
        security.get_connection_args("client")
    except (OSError, ssl.SSLError) as error:
        keys = ", ".join(f"cluster.{name} = {file!r}" for name, file in files.items())
        raise UserError(f"{keys}: cannot be used for TLS: {error}") from error
    return security
