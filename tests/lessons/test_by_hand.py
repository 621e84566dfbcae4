"""The course as a student does it: every exercise solved from its text alone, with a calculator and not with the core.

Each solution takes what the question and the page show (`v`), and gives the reply: numbers, a key of the options, a
line's number, bytes, or lines for the bench. An exercise whose answer is computed from something else than its
question says is found here and nowhere else.
"""

from collections.abc import Callable, Iterable, Mapping
from math import acos, atan, atan2, ceil, cos, degrees, dist, hypot, log, pi, radians, sin, sqrt
from typing import Any

import pytest

from kinlab.lessons import Task, load_course
from kinlab.lessons.kinds import judge
from kinlab.lessons.kinds.choice import letters
from kinlab.lessons.parameters import lesson_values

STUDENTS = 4
Values = Mapping[str, Any]
G = 9.81
TICK = 300 / 1024


def turned(x: float, y: float, angle: float) -> tuple[float, float]:
    c, s = cos(radians(angle)), sin(radians(angle))
    return x * c - y * s, x * s + y * c


def links(v: Values) -> tuple[float, float, float]:
    return v["leg"]["coxa"], v["leg"]["femur"], v["leg"]["tibia"]


def foot(v: Values, alpha: float, beta: float, gamma: float) -> tuple[float, float, float]:
    c, f, t = links(v)
    b, both = radians(beta), radians(beta + gamma)
    r = c + f * cos(b) + t * cos(both)
    return *turned(r, 0.0, alpha), f * sin(b) + t * sin(both)


def two_links(v: Values, beta: float, gamma: float) -> tuple[float, float]:
    x, _, z = foot(v, 0, beta, gamma)
    return x - links(v)[0], z


def knee_up(v: Values, x: float, y: float, z: float) -> tuple[float, float, float]:
    c, f, t = links(v)
    r = hypot(x, y) - c
    gamma = -acos(cosine(v, hypot(r, z)))
    beta = atan2(z, r) - atan2(t * sin(gamma), f + t * cos(gamma))
    return degrees(atan2(y, x)), degrees(beta), degrees(gamma)


def cosine(v: Values, d: float) -> float:
    _, f, t = links(v)
    return (d * d - f * f - t * t) / (2 * f * t)


def mirrored(v: Values, x: float, z: float) -> tuple[float, float]:
    _, beta, gamma = knee_up(v, x, 0.0, z)
    return 2 * degrees(atan2(z, x - links(v)[0])) - beta, -gamma


def passes(v: Values, beta: float, gamma: float) -> bool:
    femur, tibia = v["femur"], v["tibia"]
    return femur["lower"] <= beta <= femur["upper"] and tibia["lower"] <= gamma <= tibia["upper"]


def ticks(servo: Mapping[str, float], angle: float) -> int:
    return round((servo["zero"] + servo["sign"] * angle) / TICK)


def bench(v: Values) -> str:
    own = v["own"]
    angles = knee_up(v, v["x"], v["y"], v["z"])
    return "\n".join(
        f"write {servo} goal_position {ticks({'zero': zero, 'sign': sign}, angle)}"
        for servo, zero, sign, angle in zip(own["ids"], own["zeros"], own["signs"], angles, strict=True)
    )


def rounded(v: Values) -> float:
    taken = [tick * TICK - zero for tick, zero in zip(v["ticks"], v["zeros"], strict=True)]
    return dist(foot(v, *taken), foot(v, v["alpha"], v["beta"], v["gamma"]))


def in_body(v: Values) -> tuple[float, float, float]:
    x, y = turned(v["x"], v["y"], v["mount"]["turn"])
    return x + v["mount"]["a"], y + v["mount"]["b"], v["z"]


def in_leg(mount: Mapping[str, float], x: float, y: float) -> tuple[float, float]:
    return turned(x - mount["a"], y - mount["b"], -mount["turn"])


def followed(v: Values) -> tuple[float, float, float]:
    x, y, z = v["before"]
    return knee_up(v, *in_leg(v["mount"], x - v["tx"], y), z - v["tz"])


def yawed(v: Values) -> tuple[float, float, float]:
    x, y, z = v["before"]
    return *turned(x - v["tx"], y, -v["psi"]), z


def rolled(v: Values) -> float:
    _, y, z = v["before"]
    return -y * sin(radians(v["roll"])) + z * cos(radians(v["roll"]))


def theta2(v: Values) -> float:
    return degrees(acos(v["x"] / 30))


def landings(v: Values) -> dict[str, float]:
    left = {f"L{m + 1}": m * float(v["beta"]) % 1 for m in range(3)}
    right = {f"R{m + 1}": (m * float(v["beta"]) + 0.5) % 1 for m in range(3)}
    return {leg: round(at, 9) % 1 for leg, at in (left | right).items()}


def landing_order(v: Values) -> list[str]:
    at = landings(v)
    return sorted(at, key=lambda leg: at[leg])


def mistaken_line(v: Values) -> int:
    [wrong] = [
        i
        for i, (leg, at) in enumerate(landings(v).items(), 1)
        if abs(float(v[f"line{leg}"].split()[1]) - at) > 0.006
    ]
    return wrong


def margin(v: Values) -> float:
    feet = list(v["feet"].values())
    edges = zip(feet, [*feet[1:], feet[0]], strict=True)
    return min(abs(a * d - c * b) / hypot(c - a, d - b) for (a, b), (c, d) in edges)


def metres(v: Values) -> float:
    one = v["tripod"]["power"] * 1000 / (3600 * v["fast"]) + v["tripod"]["per_metre"]
    return v["volts"] * v["charge"] / 1000 * v["share"] / 100 / one


def crossover(v: Values) -> float:
    wave, tripod = v["wave"], v["tripod"]
    hours = (wave["per_metre"] - tripod["per_metre"]) / (tripod["power"] - wave["power"])
    return 1000 / (3600 * hours)


def packet1(*body: int) -> str:
    return shown((255, 255, *body, ~sum(body) & 255))


def goal1(v: Values) -> str:
    return packet1(v["servo"], 5, 3, 0x1E, v["ticks"] % 256, v["ticks"] // 256)


def packet2(servo: int, instruction: int, *params: int) -> str:
    frame = (255, 255, 253, 0, servo, len(params) + 3, 0, instruction, *params)
    return shown((*frame, *low_first(remainder(frame))))


def remainder(data: Iterable[int]) -> int:
    row = 0
    for byte in data:
        row ^= byte << 8
        for _ in range(8):
            row, falls = row << 1 & 0xFFFF, row >> 15
            row ^= 0x8005 * falls
    return row


def low_first(value: int) -> tuple[int, int]:
    return value % 256, value // 256


def shown(data: Iterable[int]) -> str:
    return " ".join(f"{byte:02X}" for byte in data)


def refused(v: Values) -> int:
    for i in range(1, 5):
        *rest, last = v[f"line{i}"]
        if rest[3] != len(rest) - 3 or last != ~sum(rest[2:]) & 255:
            return i
    raise AssertionError("all four are in order")


ADDRESSES = {
    "return_delay_time": 5, "cw_angle_limit": 6, "torque_enable": 24, "led": 25, "moving_speed": 32,
    "torque_limit": 34, "present_position": 36, "present_load": 40, "present_voltage": 42,
    "present_temperature": 43, "punch": 48,
}  # fmt: skip
ERRORS = {0x01: "voltage", 0x02: "angle", 0x04: "heat", 0x10: "checksum", 0x20: "overload"}


def load(v: Values) -> float:
    number = v["bytes"][0] + 256 * v["bytes"][1]
    return number % 1024 / 10 * (-1 if number >= 1024 else 1)


def softened(v: Values) -> str:
    return "\n".join(
        f"write {v['servo']} {side}_compliance_{what} {v[what]}"
        for side in ("cw", "ccw")
        for what in ("margin", "slope")
    )


def heard(v: Values) -> str:
    if v["heard"] == "-" or v["heard"].startswith(shown(v["sent"])):
        return "silence" if v["heard"] == "-" else "echo"
    return ERRORS[int(v["heard"].split()[4], 16)]


def hurry(v: Values) -> float:
    """By trying a little more and a little less of the knee."""
    _, f, t = links(v)
    more, less = (sqrt(f * f + t * t + 2 * f * t * cos(radians(v["straight"] + d))) for d in (0.001, -0.001))
    return v["speed"] * 0.002 / abs(more - less)


def arm(v: Values) -> tuple[float, ...]:
    return tuple(v["arm"][name] / 1000 for name in ("upper", "upper_g", "fore", "fore_g"))


def held(v: Values) -> tuple[float, float]:
    l1, m1, l2, m2 = arm(v)
    elbow = m2 * G * l2 / 2 * sin(radians(v["shoulder"] + v["elbow"]))
    return elbow + (m1 * l1 / 2 + m2 * l1) * G * sin(radians(v["shoulder"])), elbow


def started(v: Values) -> tuple[float, float]:
    """By Lagrange's inertia matrix, where the lesson goes by Newton and Euler."""
    l1, m1, l2, m2 = arm(v)
    shoulder = m1 * l1**2 / 3 + m2 * (l1**2 + l2**2 / 3 + l1 * l2)
    return shoulder * v["acceleration"], m2 * (l2**2 / 3 + l1 * l2 / 2) * v["acceleration"]


def zeta(v: Values, **other: float) -> float:
    v = {**v, **other}
    return v["denv"] / (2 * sqrt(v["kenv"] * v["menv"]))


def damped(v: Values) -> list[str]:
    arms = {
        "base": zeta(v),
        "spring": zeta(v, kenv=v["stiffer"]),
        "damper": zeta(v, denv=v["stronger"]),
        "mass": zeta(v, menv=v["heavier"]),
    }
    return sorted(arms, key=lambda name: arms[name])


def bend(v: Values, line: float) -> float:
    a, b = v["size"]["thigh"], v["size"]["shank"]
    return 180 - degrees(acos((a * a + b * b - line * line) / (2 * a * b)))


def stepped(v: Values, down: float) -> tuple[float, float, float]:
    knee = bend(v, hypot(v["ahead"], down))
    hip = -(degrees(atan(v["ahead"] / down)) + knee / 2)
    return hip, knee, -(hip + knee)


def all_six(v: Values) -> tuple[float, ...]:
    roll = degrees(atan(v["aside"] / v["down"]))
    return 0, roll, *stepped(v, hypot(v["aside"], v["down"])), -roll


def zmp(v: Values) -> float:
    return v["place"] - v["high"] / G * v["acceleration"]


def falls(v: Values) -> str:
    if abs(zmp(v)) < v["size"]["long"] / 2:
        return "stands"
    return "forwards" if zmp(v) > 0 else "backwards"


def off(target: Iterable[float], reached: Iterable[float]) -> list[float]:
    return [abs(a - b) for a, b in zip(target, reached, strict=True)]


def odd_row(v: Values) -> int:
    for i in range(1, 5):
        target, rest = v[f"line{i}"].split(" → ")
        reached, printed = rest.split(": ")
        target, reached = ([float(n) for n in part.strip("()").split(",")] for part in (target, reached))
        if off(target, reached) != [float(n) for n in printed.split(",")]:
            return i
    raise AssertionError("all four follow")


def cause(v: Values) -> str:
    causes = {"none-needed": v["sum"] / 9, "one-more": (v["sum"] + 1) / 9, "eight": v["sum"] / 8}
    [key] = [
        key for key, value in causes.items()
        if v["average"] in (round(value, 2), int(value * 100) / 100)
    ]  # fmt: skip
    return key


BY_HAND: dict[str, Callable[[Values], Any]] = {
    "frames/two-links": lambda v: two_links(v, v["beta"], v["gamma"]),
    "frames/carried": lambda v: "along",
    "frames/body": in_body,
    "frames/stone": lambda v: (*in_leg(v["example"], v["X"], v["Y"]), -90),
    "leg-geometry/turn-coxa": lambda v: "same",
    "leg-geometry/distance": lambda v: foot(v, 0, v["beta"], v["gamma"])[0],
    "leg-geometry/foot": lambda v: foot(v, v["alpha"], v["beta"], v["gamma"]),
    "leg-geometry/knee": lambda v: knee_up(v, v["px"], v["py"], v["pz"])[2],
    "leg-geometry/back": lambda v: knee_up(v, v["x"], v["y"], v["z"]),
    "elbow/ways": lambda v: "four",
    "elbow/mirror": lambda v: mirrored(v, v["px"], v["pz"]),
    "elbow/fits": lambda v: passes(v, *knee_up(v, v["x"], 0, v["z"])[1:]) + passes(v, *mirrored(v, v["x"], v["z"])),
    "elbow/rail": lambda v: (0, *mirrored(v, v["x"], v["z"])),
    "elbow/change": lambda v: "never",
    "elbow/registers": lambda v: sorted(ticks(v["servo"], limit) for limit in (v["low"], v["high"])),
    "reach/argument": lambda v: cosine(v, hypot(v["px"] - links(v)[0], v["pz"])),
    "reach/meaning": lambda v: "far",
    "reach/band": lambda v: links(v)[0] + sqrt(sum(links(v)[1:]) ** 2 - v["z"] ** 2),
    "reach/missing": lambda v: hypot(hypot(v["x"], v["y"]) - links(v)[0], v["z"]) - sum(links(v)[1:]),
    "reach/misprint": lambda v: 3,
    "ticks/guess": lambda v: "coin",
    "ticks/servo-angle": lambda v: v["mount"]["zero"] + v["mount"]["sign"] * v["angle"],
    "ticks/tick": lambda v: ticks(v["mount"], v["angle"]),
    "ticks/bench": bench,
    "ticks/rounded": rounded,
    "ticks/dominates": lambda v: "mechanics",
    "missing-permille/which-leg": lambda v: "bare",
    "missing-permille/exact": theta2,
    "missing-permille/ratio": lambda v: v["row"]["theta2"] / theta2(v),
    "missing-permille/their-pi": lambda v: pi * theta2(v) / v["row"]["theta2"],
    "missing-permille/fraction": lambda v: "twenty-two",
    "missing-permille/knee": lambda v: (180 - 2 * theta2(v)) * pi / (22 / 7) - 180,
    "missing-permille/outlier": lambda v: (0.004 + 0.005 * 2 + 0.006 * 3 + 0.007 * 3) / 9,
    "missing-permille/copied": lambda v: "before",
    "body-pose/up": lambda v: v["before"] - v["tz"],
    "body-pose/yaw": yawed,
    "body-pose/follow": followed,
    "body-pose/roll": rolled,
    "body-pose/printed": lambda v: "backwards",
    "footsteps/arch": lambda v: "more",
    "footsteps/point": lambda v: (v["stroke"] * v["s"], v["lift"] * sin(pi * v["s"])),
    "footsteps/misprint": lambda v: 3,
    "footsteps/swing-time": lambda v: v["stroke"] / v["speed"] * (1 - v["beta"]) / v["beta"],
    "footsteps/knock": lambda v: pi * v["lift"] / v["time"],
    "footsteps/slide": lambda v: "along",
    "gaits/read": lambda v: {"tripod": 1 / 2, "ripple": 2 / 3, "tetrapod": 2 / 3, "wave": 5 / 6}[v["gait"]],
    "gaits/table": mistaken_line,
    "gaits/order": landing_order,
    "gaits/speed": lambda v: v["stroke"] / (v["time"] / (1 - v["beta"]) * v["beta"]),
    "margin/holding": lambda v: "tripod",
    "margin/static": margin,
    "margin/formula": lambda v: v["pitch"] / 2 + (1 - 3 / (4 * v["beta"])) * v["stroke"],
    "margin/order": lambda v: "metachronal",
    "margin/rise": lambda v: hypot(v["distance"], v["height"]) - v["height"],
    "energy-crossover/guess": lambda v: "wave" if v["at"] < 15 else "tripod",
    "energy-crossover/power": lambda v: v["used"] * 3600 / v["row"]["seconds"],
    "energy-crossover/crossover": crossover,
    "energy-crossover/range": metres,
    "protocol-1/length": lambda v: v["count"] + 3,
    "protocol-1/two-bytes": lambda v: shown(low_first(v["ticks"])),
    "protocol-1/ping": lambda v: packet1(v["servo"], 2, 1),
    "protocol-1/write": goal1,
    "protocol-1/refused": refused,
    "protocol-1/complaint": lambda v: ERRORS[v["said"][4]],
    "protocol-1/drive": lambda v: f"send {goal1(v)}",
    "protocol-2/order": lambda v: ["header", "reserved", "id", "length", "instruction", "parameters", "crc"],
    "protocol-2/length": lambda v: v["count"] + 5,
    "protocol-2/which-check": lambda v: "crc",
    "protocol-2/remainder": lambda v: shown(low_first(remainder([v["byte"]]))),
    "protocol-2/ping": lambda v: packet2(v["servo"], 1),
    "protocol-2/stuffing": lambda v: v["data"].replace("FF FF FD", "FF FF FD FD"),
    "protocol-2/move": lambda v: f"write {v['servo']} torque_enable 1; write {v['servo']} goal_position {v['ticks']}",
    "protocol-2/torque": lambda v: packet2(v["servo"], 3, 64, 0, 1),
    "control-tables/address": lambda v: ADDRESSES[v["register"]],
    "control-tables/load": load,
    "control-tables/drive": lambda v: 100 * (v["punch"] / 1023 + (v["away"] - v["margin"]) / v["slope"]),
    "control-tables/sag": lambda v: (v["margin"] + (v["share"] / 100 - 32 / 1023) * v["slope"]) * 0.293,
    "control-tables/soften": softened,
    "silent-bus/heard": heard,
    "silent-bus/speed": lambda v: f"baud {v['speed']}; ping {v['servo']}; write {v['servo']} led 1",
    "silent-bus/id": lambda v: f"scan; write {v['servo']} led 1",
    "silent-bus/protocol": lambda v: f"send {packet2(v['servo'], 3, 65, 0, 1)}",
    "silent-bus/cable": lambda v: f"scan; write {v['wire'][v['intact'] - 1]} led 1",
    "jacobian/coxa": lambda v: foot(v, 0, v["beta"], v["gamma"])[0] * radians(v["rate"]),
    "jacobian/femur": lambda v: (-v["place"]["up"] * radians(v["rate"]), v["place"]["out"] * radians(v["rate"])),
    "jacobian/area": lambda v: links(v)[1] * links(v)[2] / 100 * sin(radians(v["gamma"])),
    "jacobian/singular": lambda v: "none" if v["bent"] else "along",
    "jacobian/hurry": hurry,
    "torque/hung": lambda v: v["mass"] / 1000 * G * v["length"] / 1000,
    "torque/coxa": lambda v: "no",
    "torque/femur": lambda v: v["mass"] / 1000 * G / v["standing"] * v["lever"] / 1000,
    "torque/share": lambda v: v["load"] / 1.5 * 100,
    "torque/holding": held,
    "torque/walks": lambda v: ["upper-moves", "fore-moves", "fore-carries", "upper-carries"],
    "torque/starting": started,
    "compliance/steady": lambda v: degrees(v["kf"] * v["torque"] / v["kenv"]),
    "compliance/choose": lambda v: radians(v["angle"]) * v["kenv"] / v["torque"],
    "compliance/four": damped,
    "compliance/let-go": lambda v: "swings" if zeta(v) < 1 else "creeps",
    "compliance/filter": lambda v: 16 * ceil(log(1 - v["share"] / 100) / log(1 - v["alpha"])),
    "six-joint-leg/why-six": lambda v: "six",
    "six-joint-leg/knee": lambda v: bend(v, v["line"]),
    "six-joint-leg/ankle": lambda v: -(v["hip"] + v["bend"]),
    "six-joint-leg/step": lambda v: stepped(v, v["down"]),
    "six-joint-leg/whole": all_six,
    "six-joint-leg/order": lambda v: ["right_leg-lands", "left_leg-lifts", "left_leg-lands", "right_leg-lifts"],
    "six-joint-leg/zmp": zmp,
    "six-joint-leg/falls": falls,
    "reading-a-paper/off": lambda v: off(v["target"], v["reached"]),
    "reading-a-paper/row": odd_row,
    "reading-a-paper/mean": lambda v: sum(v["errors"]) / 9,
    "reading-a-paper/cause": cause,
    "reading-a-paper/equation": lambda v: 2,
}  # fmt: skip

COURSE = load_course()
EXERCISES = {
    f"{lesson.id}/{exercise.id}": (lesson, exercise)
    for lesson in COURSE.lessons.values()
    for exercise in lesson.exercises
}


def reply(task: Task, found: Any) -> str:
    """What a student types."""
    if task.exercise.kind == "choice":
        return next(letter for letter, key in letters(task).items() if key == found)
    if isinstance(found, str):
        return found
    return " ".join(part if isinstance(part, str) else f"{part:.7g}" for part in listed(found))


def listed(found: Any) -> list[Any]:
    return list(found) if isinstance(found, list | tuple) else [float(found)]


def test_every_exercise_of_the_course_has_been_done_by_hand() -> None:
    assert sorted(BY_HAND) == sorted(EXERCISES)


@pytest.mark.parametrize("name", EXERCISES)
def test_an_answer_from_the_text_alone_is_right(name: str) -> None:
    lesson, exercise = EXERCISES[name]
    for i in range(STUDENTS):
        seed = f"night-{i}"
        task = Task(lesson, exercise, seed, "en", lesson_values(lesson, seed))
        verdict = judge(task, reply(task, BY_HAND[name](task.values)))
        assert verdict.ok, (dict(task.values), verdict.message)
