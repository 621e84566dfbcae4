"""What a metre costs, drawn from krsri-hexapod's Table 2."""

from kinlab.canvas import Canvas, chart
from kinlab.papers.energy import GAITS, measured_energy


def per_metre(columns: int = 60, ascii_only: bool = False) -> Canvas:
    """Wh for a metre over the speed, both gaits."""
    ground = measured_energy("flat")
    speeds = (ground.speed * 1000).tolist()
    curves = {gait: list(zip(speeds, ground.energy[gait].tolist(), strict=True)) for gait in GAITS}
    return chart(curves, columns, 12, ascii_only=ascii_only)[0]
