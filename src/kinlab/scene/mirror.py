"""A robot's present pose in a viewer that runs already."""

import re
import socket
import time
from collections.abc import Mapping
from types import TracebackType

import numpy as np
from numpy.typing import ArrayLike

from kinlab.errors import KinlabError, UsageError
from kinlab.guests import refuse_to_guests
from kinlab.robots import Limb, Robot
from kinlab.robots.body import resting
from kinlab.scene import blueprints
from kinlab.scene.page import LOOPBACK
from kinlab.scene.recording import Live, Times, part
from kinlab.scene.tree import Tree, stood
from kinlab.scene.viewer import PORT

_ADDRESS = re.compile(r"(?:rerun\+http://)?(?:([\w.-]+):)?(\d+)(?:/proxy)?")
PATIENCE = 2.0  # s that a viewer may take to answer, and to take the last of what was sent


class Mirror:
    """A robot in a viewer on this machine.

    with Mirror(robot) as mirror:
        mirror.show({"R1": [0.0, 0.5, -1.2]})      # limb by limb, rad; the others stay as they were

    Attributes:
        robot: shown.
        address: of the viewer.
    """

    def __init__(self, robot: Robot, address: str = f"{LOOPBACK}:{PORT}") -> None:
        """Connect, and draw the robot as it stands.

        Args:
            address: HOST:PORT, PORT or rerun+http://HOST:PORT/proxy of this machine.

        Raises:
            UsageError: no such address, one of another machine, or the user is a guest, who sits elsewhere.
            KinlabError: nobody listens there, or rerun is not installed.
        """
        refuse_to_guests("a viewer")
        parts = _ADDRESS.fullmatch(address)
        if parts is None or not 1 <= int(parts[2]) <= 65535:
            raise UsageError(
                f"'{address}' is no address of a viewer; write {LOOPBACK}:{PORT}, or the port alone"
            )
        host, port = parts[1] or LOOPBACK, int(parts[2])
        if host not in (LOOPBACK, "localhost"):
            raise UsageError(f"a robot is mirrored on this machine, {LOOPBACK}, not on {host}")
        self.robot, self.address = robot, f"rerun+http://{LOOPBACK}:{port}/proxy"
        self._recording = Live(f"{robot.name} live")
        try:
            socket.create_connection((LOOPBACK, port), timeout=PATIENCE).close()
        except OSError as error:
            raise KinlabError(
                f"no viewer answers at {LOOPBACK}:{port} ({error.strerror or error}); "
                f"kinlab view {robot.name} --spawn opens one, --serve one in the browser"
            ) from None
        self._recording.stream.connect_grpc(self.address)
        self._recording.stream.send_blueprint(blueprints.live(robot))
        self._tree = Tree(self._recording, robot)
        self._tree.draw()
        self._recording.pose(self._tree.body, stood(robot))
        for limb in robot.limbs.values():
            names = [f"{limb.name} {joint}" for joint in limb.joint_names]
            self._recording.still(self._curve(limb), self._recording.rr.SeriesLines(names=names))
        self._began = time.monotonic()
        self.show(resting(robot))

    def __enter__(self) -> "Mirror":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def show(
        self, angles: Mapping[str, ArrayLike], body: ArrayLike | None = None, t: float | None = None
    ) -> None:
        """Show joint angles, limb by limb (n,), in rad; NaN where nobody knows, and the joint stays.

        Args:
            body: its pose over the ground (4, 4), metres.
            t: s; the time since the mirror was opened where not given.
        """
        now = Times(np.array([time.monotonic() - self._began if t is None else t]))
        for name, q in angles.items():
            limb = self.robot.limb(name)
            row = np.asarray(q, float)[None]
            self._tree.pose(limb, row, now)
            self._recording.series(self._curve(limb), now, np.degrees(row))
        if body is not None:
            self._recording.pose(self._tree.body, np.asarray(body, float)[None], now)

    def _curve(self, limb: Limb) -> str:
        return "angles/" + part(limb.name)

    def close(self) -> None:
        """Send what is left, and let go of the viewer; it keeps what it has."""
        try:
            self._recording.stream.flush(timeout_sec=PATIENCE)
        except RuntimeError as error:
            raise KinlabError(f"the viewer at {self.address} is gone: {error}") from None
        finally:
            self._recording.stream.disconnect()
