"""Who may connect: the `Host` and `Origin` of every request are checked, which a browser cannot be made to forge.

Without this, any page that somebody opens could reach a server on that person's own machine: through a
websocket, for which browsers ask no leave, or by a name that it lets point here (DNS rebinding).
"""

import ipaddress
import re
import socket
from dataclasses import dataclass

_HOST = re.compile(r"(?:\[([0-9a-f:.]+)\]|([\w.-]+))(?::\d{1,5})?", re.ASCII | re.IGNORECASE)


@dataclass(frozen=True)
class Gate:
    """The names under which a server may be asked for.

    Attributes:
        names: as they stand in an address, in lower case.
        any_number: whether any IP address will do; nobody can let those point elsewhere.
    """

    names: frozenset[str]
    any_number: bool

    @classmethod
    def of(cls, host: str) -> "Gate":
        """The gate of a server that listens on `host`."""
        if is_loopback(host):
            return cls(frozenset({"localhost", "127.0.0.1", "::1", host.casefold()}), any_number=False)
        own = socket.gethostname().casefold()
        return cls(
            frozenset({"localhost", host.casefold(), own, own.partition(".")[0] + ".local"}), any_number=True
        )

    def objection(self, host: str | None, origin: str | None, *, needs_origin: bool) -> str:
        """What speaks against a request with these headers, as the key of a sentence; "" if nothing does."""
        if not host or not self._knows(host):
            return "foreign_host"
        if origin is None:
            return "no_origin" if needs_origin else ""
        return "" if origin.casefold() == f"http://{host}".casefold() else "foreign_origin"

    def _knows(self, host: str) -> bool:
        # Nothing but a name and a port: the header goes on into the page.
        found = _HOST.fullmatch(host)
        if not found:
            return False
        name = (found[1] or found[2]).casefold()
        return name in self.names or (self.any_number and _is_number(name))


def is_loopback(host: str) -> bool:
    """Whether only this machine itself can reach a server on `host`."""
    return host.casefold() == "localhost" or (_is_number(host) and ipaddress.ip_address(host).is_loopback)


def _is_number(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
