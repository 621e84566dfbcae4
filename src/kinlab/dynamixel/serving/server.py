"""The loop that lets clients talk to a chain: it sleeps until somebody does."""

import heapq
import select
import socket
from collections.abc import Callable
from contextlib import suppress
from itertools import count
from typing import Self

from kinlab.dynamixel.chain import Burst, Chain, RealClock, Receiver
from kinlab.dynamixel.chain.chain import wire_time
from kinlab.dynamixel.chain.receiver import GAP
from kinlab.dynamixel.serving.links import Link
from kinlab.dynamixel.serving.tcp import MOST_CLIENTS, TcpListener

Watcher = Callable[[str, bytes, float], None]


class Server:
    """Serves a chain to the clients of any number of links; `with` closes them all."""

    def __init__(
        self,
        chain: Chain,
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
        self._receivers: dict[Link, Receiver] = {}
        self._listener = listener
        self._watch = watch
        self._after_change = after_change
        self._changes_kept = chain.eeprom_writes
        self._due: list[tuple[float, int, Link, bytes]] = []
        self._order = count()
        # A pair of sockets, for pipes cannot be waited on everywhere.
        self._waker, self._wake = socket.socketpair()
        self._stopped = False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for link in self._receivers:
            link.close()
        if self._listener:
            self._listener.close()
        self._waker.close()
        self._wake.close()

    def add(self, link: Link) -> None:
        """Serve one link more."""
        self._receivers[link] = Receiver(self.chain)

    def run(self) -> None:
        """Serve until `stop` is called."""
        while not self._stopped:
            self._turn()

    def stop(self) -> None:
        """End `run`, also one that has yet to begin, from another thread or from a signal handler."""
        with suppress(OSError):  # It has ended, and is closed.
            self._wake.send(b"x")

    def _turn(self) -> None:
        sources: list[Link | TcpListener | socket.socket] = [*self._receivers, self._waker]
        if self._listener:
            sources.append(self._listener)
        for source in select.select(sources, [], [], self._patience())[0]:
            if source is self._listener:
                client = self._listener.accept()
                if client and len(self._receivers) > MOST_CLIENTS:
                    client.close()  # A client that is turned away knows at once; one left waiting never does.
                elif client:
                    self.add(client)
            elif source is self._waker:
                self._stopped = True
            elif not isinstance(source, socket.socket | TcpListener):
                self._serve(source)
        now = self.clock.now()
        self._give_up_unfinished(now)
        self._deliver(now)
        if self._after_change and self.chain.eeprom_writes != self._changes_kept:
            self._changes_kept = self.chain.eeprom_writes
            self._after_change()

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
        baud = link.baud
        sending = wire_time(len(data), baud) if baud else 0.0
        self._queue(link, self._receivers[link].feed(data, now, baud), sending)

    def _give_up_unfinished(self, now: float) -> None:
        """Look for whole packets inside those that were begun and not ended in time, as servos do."""
        for link, receiver in self._receivers.items():
            if receiver.overdue(now):
                self._queue(link, receiver.abandon(now, link.baud), 0.0)

    def _queue(self, link: Link, bursts: list[Burst], sending: float) -> None:
        """Note when bytes are due; `sending` is how long the request would have been on its way, in s."""
        for burst in bursts:
            due = burst.end + sending if self.chain.byte_times else burst.start
            heapq.heappush(self._due, (due, next(self._order), link, burst.data))

    def _deliver(self, now: float) -> None:
        """Send what is due. Answers to one client go out in one piece: each piece costs a switch of processes."""
        while self._due and self._due[0][0] <= now:
            link, pieces = self._due[0][2], []
            while self._due and self._due[0][0] <= now and self._due[0][2] is link:
                pieces.append(heapq.heappop(self._due)[3])
            if link in self._receivers:
                if self._watch:
                    for piece in pieces:
                        self._watch("<-", piece, now)
                link.send(b"".join(pieces))
