"""Control tables and what their registers do, of the AX-12A unless a model is named. Angles in degrees."""

from kinlab.dynamixel.tables import Register, load_table
from kinlab.lessons.results import Goal, Holds

AX = "AX-12A"
BIT10 = 0x400


def title(register: str) -> str:
    """A register's name as the manual prints it."""
    return _register(register).title


def address(register: str) -> float:
    """Where a register begins."""
    return _register(register).address


def size(register: str) -> float:
    """How many bytes it has."""
    return _register(register).size


def load_bytes(share: float, clockwise: float) -> bytes:
    """What READ gives of Present Load: a share of stall torque in per cent, and 1 for clockwise."""
    register = _register("present_load")
    ticks = register.ticks(share)
    return register.encode(-ticks if clockwise else ticks)


def load(share: float, clockwise: float) -> float:
    """What those bytes mean, per cent, clockwise negative."""
    register = _register("present_load")
    return register.physical(register.decode(load_bytes(share, clockwise)))


def load_without_direction(share: float, clockwise: float) -> float:
    """As `load`, bit 10 taken for a part of the number."""
    raw = int.from_bytes(load_bytes(share, clockwise), "little")
    return _register("present_load").physical(raw)


def load_without_sign(share: float, clockwise: float) -> float:
    """As `load`, the direction left out."""
    return abs(load(share, clockwise))


def degrees(ticks: float) -> float:
    """Ticks of position as an angle."""
    return _register("goal_position").physical(round(ticks))


def torque_share(away: float, margin: float, slope: float, punch: float) -> float:
    """The drive of a servo that is `away` ticks off its goal, per cent of full.

    Nothing within the margin; beyond it punch, and on top of that the way beyond the margin over the slope.
    """
    if away <= margin:
        return 0.0
    return min(100.0, punch / 10.23 + (away - margin) / slope * 100)


def torque_share_without_margin(away: float, margin: float, slope: float, punch: float) -> float:
    """As `torque_share`, counted from the goal and not from the end of the margin."""
    return torque_share(away + margin, margin, slope, punch)


def torque_share_without_punch(away: float, margin: float, slope: float, punch: float) -> float:
    """As `torque_share`, the punch forgotten."""
    return torque_share(away, margin, slope, 0.0)


def partial(away: float, margin: float, slope: float, punch: float) -> bool:
    """Whether the servo drives, and not yet at full."""
    return 0.0 < torque_share(away, margin, slope, punch) < 95.0


def sag(share: float, margin: float, slope: float, punch: float) -> float:
    """How far off its goal a servo hangs that carries a load of `share` per cent, degrees."""
    ticks = margin + max(0.0, share / 100 - punch / 1023) * slope
    return ticks * _register("goal_position").scale


def sag_in_ticks(share: float, margin: float, slope: float, punch: float) -> float:
    """As `sag`, in ticks."""
    return sag(share, margin, slope, punch) / _register("goal_position").scale


def sag_without_margin(share: float, margin: float, slope: float, punch: float) -> float:
    """As `sag`, the margin forgotten."""
    return sag(share, 0.0, slope, punch)


def soften(servo: int, slope: int, margin: int) -> Goal:
    """Give an AX-12A a slope and a margin on both sides."""
    names = {
        "cw_compliance_margin": margin,
        "ccw_compliance_margin": margin,
        "cw_compliance_slope": slope,
        "ccw_compliance_slope": slope,
    }
    return Goal(
        f"{AX}:{servo}",
        tuple(Holds(servo, name, value, value) for name, value in names.items()),
        tuple(f"write {servo} {name} {value}" for name, value in names.items()),
    )


def _register(name: str) -> Register:
    return load_table(AX).by_name[name]
