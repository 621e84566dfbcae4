"""The shape of a robots file: what may stand where. `load` turns it into robots."""

from typing import Literal

from msgspec import Struct, field

Axis = Literal["x", "y", "z", "-x", "-y", "-z"]
Kind = Literal["hexapod", "quadruped", "humanoid", "arm"]
Protocol = Literal["1.0", "2.0", "pwm"]


class Sourced(Struct, forbid_unknown_fields=True, kw_only=True):
    """At most one of the three says where the figure comes from."""

    printed: str | None = None
    inferred: str | None = None
    assumed: str | None = None


class Length(Sourced):
    mm: float


class Mass(Sourced):
    g: float


class Point(Sourced):
    mm: tuple[float, float, float]


class Area(Sourced):
    mm: tuple[float, float]


class Range(Sourced):
    deg: tuple[float, float]


class PaperAxes(Sourced):
    x: Axis
    y: Axis
    z: Axis


class Current(Sourced):
    ma: float


class ServoModelSpec(Sourced):
    protocol: Protocol
    positions: tuple[int, int]
    deg_per_step: float
    torque_nm: float
    speed_rpm: float
    standby: Current | float | None = None


class Mounting(Sourced):
    model: str
    zero: float
    sign: Literal[1, -1]


class JointSpec(Struct, forbid_unknown_fields=True):
    name: str
    axis: Axis | tuple[float, float, float]
    link: dict[str, str] = {}


class Member(Struct, forbid_unknown_fields=True):
    at: Point | tuple[float, float, float]
    turn: float = 0.0
    mounting: str | None = None
    ids: list[int] = []
    paper_axes: PaperAxes | None = None


class Group(Struct, forbid_unknown_fields=True):
    """A group of equal limbs; keys that are not named here are its lengths."""

    joints: Literal["leg"] | list[JointSpec]
    members: dict[str, Member]
    limits: dict[str, Range | tuple[float, float]] = {}
    mountings: dict[str, dict[str, Mounting]] = {}
    stance: Point | tuple[float, float, float] | None = None
    sole: Area | tuple[float, float] | None = None
    paper_axes: PaperAxes | None = None
    masses: dict[str, Mass | float] = {}
    lengths: dict[str, Length | float] = {}


class RobotSpec(Struct, forbid_unknown_fields=True):
    """A robot; keys that are not named here are its groups of limbs."""

    title: str = ""
    kind: Kind = "arm"
    paper: str | None = None
    mass: Mass | float | None = None
    centre: Point | tuple[float, float, float] | None = None
    body: dict[str, float | Length] = {}
    notes: list[str] = []
    groups: dict[str, Group] = field(default_factory=dict)


class GaitSpec(Sourced):
    """A gait; fractions as numbers or as texts such as 5/6."""

    kind: Kind
    duty: float | str
    touchdown: dict[str, float | str]
