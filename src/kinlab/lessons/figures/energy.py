"""What a metre costs, drawn from krsri-hexapod's Table 2."""

from kinlab.canvas import Canvas, chart
from kinlab.papers.energy import GAITS, measured_energy


def per_metre(columns: int = 60, ascii_only: bool = False) -> Canvas:
    """Wh for a metre over the speed, both gaits."""
    ground = measured_energy("flat")
    speeds = (ground.speed * 1000).tolist()
    curves = {gait: list(zip(speeds, ground.energy[gait].tolist(), strict=True)) for gait in GAITS}
    marks = {10.0: "10", 20.0: "20", 30.0: "30", 40.0: "40 mm/s"}
    return chart(curves, columns, 13, ascii_only=ascii_only, marks=marks)[0]
