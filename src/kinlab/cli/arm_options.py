"""The options that the commands of `kinlab arm` share."""

from pathlib import Path
from typing import Annotated

import typer

Kp = Annotated[float, typer.Option(help="Position gain of (2.20), 1/s2.")]
Kv = Annotated[float, typer.Option(help="Velocity gain of (2.20), 1/s. The paper's conclusion prints 0.02.")]
Summed = Annotated[
    bool,
    typer.Option("--sum", help="Sum accelerations up into rates without the cycle time, another reading."),
]
EnvironmentName = Annotated[
    str, typer.Option("--environment", "-e", help="A printed set: table-4.1 or conclusion.")
]
Kf = Annotated[float | None, typer.Option(help="Instead of the set's: rad per kgf cm, times Kenv.")]
Kenv = Annotated[float | None, typer.Option(help="Instead of the set's: the virtual spring.")]
Denv = Annotated[float | None, typer.Option(help="Instead of the set's: the virtual damper.")]
Menv = Annotated[float | None, typer.Option(help="Instead of the set's: the virtual mass.")]
Alpha = Annotated[float, typer.Option(help="Of the torque's low-pass filter.")]
Slope = Annotated[int, typer.Option(help="Compliance slope of the servos; 64 is printed, 32 the factory's.")]
Margin = Annotated[int, typer.Option(help="Compliance margin of the servos.")]
Punch = Annotated[int, typer.Option(help="Punch of the servos.")]
Profile = Annotated[str, typer.Option(help="How the line is run through: steps, trapezoid or quintic.")]
Pushes = Annotated[
    list[str] | None,
    typer.Option(
        help='A hand, as in "t=0.5 dur=0.4 at=hand force=-5,0,0": s, s, hand or a joint, N. Repeatable.'
    ),
]
Csv = Annotated[
    Path | None, typer.Option(help="Write every cycle to this file; a second run gets its name added.")
]
Real = Annotated[
    str | None, typer.Option("--real", metavar="PORT", help="Real servos: /dev/ttyUSB0, a pty, or HOST:PORT.")
]
BAUD = 1_000_000
Baud = Annotated[int, typer.Option(help="Speed of the real bus, bps.")]
TorqueLimit = Annotated[
    float, typer.Option(help="The most torque of the servos, share of stall. Real: 0.4 at most.")
]
SpeedLimit = Annotated[float, typer.Option(help="The highest speed they are told, deg/s. Real: 200 at most.")]
Live = Annotated[bool, typer.Option("--live", help="Watch it in real time.")]
Drop = Annotated[float, typer.Option(help="The chance that the emulated wire loses a byte.")]
