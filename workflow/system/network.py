"""Network interfaces of this machine."""

import fcntl
import socket

from ..ground import UserError

ADDRESS = 0x8915  # SIOCGIFADDR of Linux
LONGEST = 15  # letters of a name


def interface_named(name: str) -> str | None:
    """Return a network interface that has an address, or None for no name. Raises UserError."""
    if not name:
        return None
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
            fcntl.ioctl(any_socket, ADDRESS, name.encode()[:LONGEST].ljust(256, b"\0"))
    except OSError:  # no such interface, or none with an address
        known = ", ".join(own for _, own in socket.if_nameindex())
        raise UserError(
            f"cluster.interface = {name!r}: is no network interface of this machine that has an "
            f"address; there are {known}: give the one by which the nodes reach this machine, or "
            "leave the key out"
        ) from None
    return name
