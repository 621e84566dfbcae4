"""What a client's connection looks like to the server, whatever carries it."""

from typing import Protocol


class Link(Protocol):
    """One client's connection.

    Attributes:
        baud: the client's speed in bps; None where the carrier has none.
    """

    @property
    def baud(self) -> int | None: ...

    def fileno(self) -> int:
        """For waiting on."""

    def receive(self) -> bytes | None:
        """What the client sent; None when it is gone for good."""

    def send(self, data: bytes) -> None:
        """Pass bytes to the client; a client that does not read loses them."""

    def close(self) -> None:
        """End the connection and leave nothing behind."""
