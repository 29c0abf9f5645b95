"""Self-signed certificates of the connections between processes of one run."""

from datetime import UTC, datetime, timedelta
from pathlib import Path

# Validity of a certificate after and before its creation, as clocks differ or are set back.
VALIDITY, CLOCK_MARGIN = timedelta(days=365), timedelta(days=2)


def write_certificate(file: Path) -> None:
    """Write a new private key and its certificate to a PEM file that only this user can read."""
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
    file.touch(0o600)
    file.write_bytes(private + certificate.public_bytes(serialization.Encoding.PEM))
