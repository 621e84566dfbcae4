"""A pseudo-terminal with a stable name: to a client, a serial port."""

import fcntl
import os
import struct
import termios
import tty
from pathlib import Path

from kinlab.dynamixel.ports import PortError

# Linux keeps any speed as a number in its termios2; the constants are not in Python's termios.
TCGETS2, TCSETS2, BOTHER, CBAUD = 0x802C542A, 0x402C542B, 0o010000, 0o010017
TERMIOS2 = struct.Struct("4I20B2I")
OUTPUT_SPEED = 25
CHUNK = 4096


class PtyLink:
    """A pty, and a symbolic link to it."""

    def __init__(self, link: Path, baud: int) -> None:
        """Open the pty, set to `baud` for clients that set nothing, and make the link.

        Raises:
            PortError: there is something at `link` already, or it cannot be made.
        """
        self.link = link
        self._master, self._slave = os.openpty()
        # Raw from the start: a fresh pty echoes and eats control characters until a client sets it up.
        tty.setraw(self._slave)
        self._set_speed(baud)
        os.set_blocking(self._master, False)
        # The slave stays open here: without, the master fails whenever no client has it open.
        self.device = os.ttyname(self._slave)
        try:
            if link.is_symlink() and not link.exists():
                link.unlink()  # Left behind by a chain that was killed.
            link.symlink_to(self.device)
        except FileExistsError:
            self._close_ends()
            raise PortError(f"{link} is there already: another chain has that name, or delete it") from None
        except OSError as error:
            self._close_ends()
            raise PortError(f"cannot make the link {link}: {error.strerror}") from None

    @property
    def baud(self) -> int | None:
        try:
            raw = fcntl.ioctl(self._master, TCGETS2, bytes(TERMIOS2.size))
        except OSError:
            return None
        return int(TERMIOS2.unpack(raw)[OUTPUT_SPEED])

    def _set_speed(self, baud: int) -> None:
        try:
            fields = list(TERMIOS2.unpack(fcntl.ioctl(self._slave, TCGETS2, bytes(TERMIOS2.size))))
            fields[2] = fields[2] & ~CBAUD | BOTHER
            fields[-2:] = [baud, baud]
            fcntl.ioctl(self._slave, TCSETS2, TERMIOS2.pack(*fields))
        except OSError:
            return  # Not Linux: clients set their own speed, and any is heard.

    def fileno(self) -> int:
        """The end that the server reads."""
        return self._master

    def receive(self) -> bytes | None:
        """What the client wrote."""
        try:
            return os.read(self._master, CHUNK)
        except BlockingIOError:
            return b""
        except OSError:
            return None

    def send(self, data: bytes) -> None:
        """Pass bytes to the client; what does not fit into the kernel's buffer is lost, as on a full UART."""
        try:
            os.write(self._master, data)
        except BlockingIOError:
            # Nobody reads. Old bytes would only be mistaken for answers to later questions.
            termios.tcflush(self._slave, termios.TCIFLUSH)

    def close(self) -> None:
        """Remove the link and the pty."""
        if self.link.is_symlink() and os.readlink(self.link) == self.device:
            self.link.unlink()
        self._close_ends()

    def _close_ends(self) -> None:
        os.close(self._master)
        os.close(self._slave)
