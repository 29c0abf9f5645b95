"""Network interfaces of this machine."""

import socket

from ..errors import UserError


def interface_named(name: str) -> str | None:
    """Return a network interface that has an address, or None for no name. Raises UserError."""
    from distributed.utils import get_ip_interface  # slow to import

    try:
        if name:
            get_ip_interface(name)
    except ValueError:  # no such interface, or none with an address
        known = ", ".join(own for _, own in socket.if_nameindex())
        raise UserError(
            f"cluster.interface = {name!r}: is no network interface of this machine that has an "
            f"address; there are {known}: give the one by which the nodes reach this machine, or "
            "leave the key out"
        ) from None
    return name or None
