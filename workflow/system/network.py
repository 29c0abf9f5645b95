"""Network interfaces of this machine."""

import fcntl
import socket

from ..ground import UserError

SIOCGIFADDR = 0x8915  # request of Linux for the address of an interface
MAX_NAME_LENGTH = 15


def interface_named(name: str) -> str | None:
    """Return ``name``, or None for "". Raises UserError if no such interface has an address."""
    if not name:
        return None
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
            fcntl.ioctl(any_socket, SIOCGIFADDR, name.encode()[:MAX_NAME_LENGTH].ljust(256, b"\0"))
    except OSError:
        known = ", ".join(interface for _, interface in socket.if_nameindex())
        raise UserError(
            f"cluster.interface = {name!r}: is not a network interface with an address; choose the "
            f"one by which the nodes reach this machine from {known}, or omit the key"
        ) from None
    return name
