"""What the printed form of each faulty equation gives, and what is true, at the place that its worked line names.

A verdict sees that a form is wrong; these numbers, redone by hand, see that it is the printed one. Left out are
matrices, which are told entry by entry, and equations whose first wrong place is one that was drawn at random.
"""

import re

import pytest

from kinlab.papers import eros_humanoid, krsri_hexapod, udiebot_quadruped, xl430_hexapod
from kinlab.papers.recompute import recompute

FOUND = {(f.paper, f.where): f for report in recompute() for f in report.findings}
PRINTED = {
    "xl430-hexapod": {
        "4": "the printed form has no value, true 70.513 deg",
        "5": "printed 89.5758 deg, true -42.2378 deg",
    },
    "krsri-hexapod": {
        "16": "printed (-17.3648, 158.481, -90) mm, true (27.7837, 157.569, -90) mm",
        "19": "printed 162.754 mm, true 165.753 mm",
        "20": "printed 89.9829 deg, true 46.9701 deg",
        "23": "printed 89.9799 deg, true 111.245 deg",
        "26": "printed 41 mm, true 40 mm",
    },
    "udiebot-quadruped": {
        "3": "printed 315.356 mm, true 329.796 mm",
        "4": "printed 343.896 mm, true 270.134 mm",
        "5": "printed -87.1352 deg, true -2.8648 deg",
        "6": "printed 110.192 deg, true 25.7831 deg",
        "7": "printed 51.5662 deg, true 128.434 deg",
        "8": "printed 92.4537 deg, true 17.1887 deg",
        "10": "printed -38.4338 deg, true -51.5662 deg",
    },
    "eros-humanoid": {
        "12": "printed 60.1535 mm, true 30.0767 mm",
        "13": "printed 0 mm, true 10 mm",
        "15": "printed -10 deg, true 10 deg",
        "17": "printed 170.867 mm, true 173.494 mm",
        "22": "printed -95.2628 mm, true -77.9423 mm",
        "23": "printed -65 mm, true -155 mm",
        "25": "printed 30 deg, true -30 deg",
        "27": "printed 90 deg, true -30 deg",
        "30": "printed -10 deg, true 10 deg",
        "32": "printed 30 deg, true -30 deg",
        "34": "printed 90 deg, true -30 deg",
        "39": "printed 910 mm, true 0 mm",
        "43": "printed 910 mm, true 0 mm",
        "46": "printed 60 degrees, true -30 degrees",
        "47": "printed 60 degrees, true -30 degrees",
    },
    "receptionist-arm": {
        "2.6": "printed 20.2109, true 5.0527",
        "2.13": "the printed form has no value, true 3.4641 rad/s",
        "2.14": "printed 0.7217, true 0.0513",
        "2.15": "printed 0.025, true 0.3",
        "2.17": "printed 613.371 %, true 16.3034 %",
        "2.19": "printed 1.8 / ω_n, true 1.6 / ω_n",
        "2.24": "printed 1.8, true 6",
        "2.26": "printed 17.2063, true 20.2109",
        "2.29": "printed 1.2 N m, true 12 N m",
        "2.30": "printed -1.8 N m, true 9 N m",
        "2.34": "printed 5.25 N m, true 1.25 N m",
        "2.35": "printed 10.75 N m, true 6.75 N m",
        "2.36": "printed 5.25 N m, true 1.25 N m",
        "2.37": "printed -1.9643 N m, true -0.5357 N m",
        "2.39": "printed -2 N m, true 2 N m",
        "2.40": "printed 0 N m, true 2 N m",
        "2.46": "printed 8 m/s², true -8 m/s²",
        "3.9": "printed (1.7607, 15.4503, -16.0215) cm, true (11.1357, 20.863, -34.7715) cm",
        "3.9, matrix 3": "printed (18.5, 2, 3), true (19.5, 2, 3)",
        "3.9, matrix 5": "printed (25, 2, 3), true (26, 2, 3)",
        "3.17": "printed 1, true -20.863",
        "3.24": "printed -0.5044 N m, true 0 N m",
        "3.26": "printed -0.5044 N m, true 0 N m",
        "3.28": "printed 0.1851 N m, true -0.5044 N m",
        "3.29": "printed -0.5044 N m, true 0 N m",
        "3.31": "printed -0.1851 N m, true -0.5044 N m",
        "3.33": "printed -0.5044 N m, true 0 N m",
        "3.34": "printed 3.7265 N, true 0 N",
        "3.36": "printed 0 N m, true 0.2329 N m",
    },
}  # fmt: skip


@pytest.mark.parametrize("paper", PRINTED)
def test_printed_forms_give_what_was_worked_out(paper):
    worked = {n: FOUND[paper, f"equation ({n})"].arithmetic.rpartition(": ")[2] for n in PRINTED[paper]}
    assert worked == PRINTED[paper]


def plain(text):
    """An equation's right side, without blanks, in letters that need no Greek."""
    text = re.sub(r"√(\w+)", r"sqrt(\1)", text.rpartition(" = ")[2]).replace("√", "sqrt").replace("²", "^2")
    for greek, name in (("θ", "theta"), ("β", "beta"), ("γ", "gamma"), ("deg", "")):
        text = text.replace(greek, name)
    return text.replace(" ", "")


@pytest.mark.parametrize(
    "module", [xl430_hexapod, krsri_hexapod, udiebot_quadruped, eros_humanoid], ids=lambda m: m.__name__
)
def test_as_printed_quotes_the_same_print(module):
    paper = module.__name__.rpartition(".")[2].replace("_", "-")
    for misprint in module.INVERSE.misprints:
        assert plain(misprint.printed) == plain(FOUND[paper, f"equation ({misprint.equation})"].printed)
