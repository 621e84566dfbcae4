"""TCP: the chain for programs elsewhere, and for systems without ptys."""

import socket

from kinlab.dynamixel.ports import PortError
from kinlab.errors import UsageError

MOST_CLIENTS = 256
MOST_UNSENT = 65536
CHUNK = 1024


class TcpListener:
    """Takes clients in. On loopback unless a host is given."""

    def __init__(self, address: str) -> None:
        """Listen at "PORT" or "HOST:PORT"; port 0 takes any.

        Raises:
            PortError: the port is taken, or not allowed.
            UsageError: no port number.
        """
        host, _, port = address.rpartition(":")
        if not port.isdecimal() or int(port) > 65535:
            raise UsageError(f"'{address}' is no TCP address; write PORT or HOST:PORT, as in 127.0.0.1:5000")
        try:
            self._socket = socket.create_server((host or "127.0.0.1", int(port)), backlog=MOST_CLIENTS)
        except OSError as error:
            raise PortError(f"cannot listen at {address}: {error.strerror or error}") from None
        self._socket.setblocking(False)
        name = self._socket.getsockname()
        self.address = f"{name[0]}:{name[1]}"

    def fileno(self) -> int:
        """For waiting on."""
        return self._socket.fileno()

    def accept(self) -> "TcpLink | None":
        """The next client, if it is still there."""
        try:
            client, _ = self._socket.accept()
        except OSError:
            return None
        return TcpLink(client)

    def close(self) -> None:
        """Take in nobody any more."""
        self._socket.close()


class TcpLink:
    """One TCP client."""

    baud = None

    def __init__(self, client: socket.socket) -> None:
        self._socket = client
        self._unsent = b""
        client.setblocking(False)
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def fileno(self) -> int:
        """For waiting on."""
        return self._socket.fileno()

    def receive(self) -> bytes | None:
        """What the client sent; None when it is gone."""
        try:
            return self._socket.recv(CHUNK) or None
        except BlockingIOError:
            return b""
        except OSError:
            return None

    def send(self, data: bytes) -> None:
        """Pass bytes on; a client that leaves too much unread loses what is over."""
        self._unsent = (self._unsent + data)[:MOST_UNSENT]
        try:
            self._unsent = self._unsent[self._socket.send(self._unsent) :]
        except BlockingIOError:
            return
        except OSError:
            self._unsent = b""  # Gone; the next receive says so.

    def close(self) -> None:
        """End the connection."""
        self._socket.close()
