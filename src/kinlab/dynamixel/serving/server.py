"""The loop that lets clients talk to a chain: it sleeps until somebody does."""

import heapq
import select
import socket
from collections.abc import Callable, Iterable
from itertools import count

from kinlab.dynamixel.chain import Chain, RealClock, Receiver
from kinlab.dynamixel.chain.chain import wire_time
from kinlab.dynamixel.chain.receiver import GAP
from kinlab.dynamixel.serving.links import Link
from kinlab.dynamixel.serving.tcp import MOST_CLIENTS, TcpListener

Watcher = Callable[[str, bytes, float], None]


class Server:
    """Serves a chain to the clients of any number of links."""

    def __init__(
        self,
        chain: Chain,
        links: Iterable[Link] = (),
        listener: TcpListener | None = None,
        watch: Watcher | None = None,
        after_change: Callable[[], None] | None = None,
    ) -> None:
        """Set up.

        Args:
            watch: is told of all traffic: "->" to the servos or "<-" from them, the bytes, the time in s.
            after_change: is called when the EEPROM of a servo has changed.
        """
        self.chain = chain
        self.clock = RealClock()
        chain.begin(self.clock.now())
        self._receivers = {link: Receiver(chain) for link in links}
        self._listener = listener
        self._watch = watch
        self._after_change = after_change
        self._due: list[tuple[float, int, Link, bytes]] = []
        self._order = count()
        # A pair of sockets, for pipes cannot be waited on everywhere.
        self._waker, self._wake = socket.socketpair()
        self._stopped = False

    def run(self) -> None:
        """Serve until `stop` is called."""
        try:
            while not self._stopped:
                self._turn()
        finally:
            self._close()

    def stop(self) -> None:
        """End `run` from another thread, or from a signal handler."""
        self._stopped = True
        self._wake.send(b"x")

    def _turn(self) -> None:
        sources: list[Link | TcpListener | socket.socket] = [*self._receivers, self._waker]
        if self._listener and len(self._receivers) <= MOST_CLIENTS:
            sources.append(self._listener)
        for source in select.select(sources, [], [], self._patience())[0]:
            if source is self._listener:
                client = self._listener.accept()
                if client:
                    self._receivers[client] = Receiver(self.chain)
            elif not isinstance(source, socket.socket | TcpListener):
                self._serve(source)
        now = self.clock.now()
        while self._due and self._due[0][0] <= now:
            _, _, link, data = heapq.heappop(self._due)
            self._send(link, data, now)

    def _patience(self) -> float | None:
        """How long nothing needs to be done unless a client speaks; None: for ever."""
        if self._due:
            return max(0.0, self._due[0][0] - self.clock.now())
        return GAP if any(receiver.pending for receiver in self._receivers.values()) else None

    def _serve(self, link: Link) -> None:
        data = link.receive()
        if data is None:
            del self._receivers[link]
            link.close()
            return
        now = self.clock.now()
        if self._watch and data:
            self._watch("->", data, now)
        changes = self.chain.eeprom_writes
        baud = link.baud
        for burst in self._receivers[link].feed(data, now, baud):
            due = burst.start
            if self.chain.byte_times:
                due = burst.end + (wire_time(len(data), baud) if baud else 0.0)
            if due <= now and not self._due:
                self._send(link, burst.data, now)
            else:
                heapq.heappush(self._due, (due, next(self._order), link, burst.data))
        if self._after_change and self.chain.eeprom_writes != changes:
            self._after_change()

    def _send(self, link: Link, data: bytes, now: float) -> None:
        if link in self._receivers:
            if self._watch:
                self._watch("<-", data, now)
            link.send(data)

    def _close(self) -> None:
        for link in self._receivers:
            link.close()
        if self._listener:
            self._listener.close()
        self._waker.close()
        self._wake.close()
