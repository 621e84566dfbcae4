"""Figures and packets in the arm paper's text and conclusion, and the lengths that its appendix computes with."""

import math
from collections.abc import Iterator

import numpy as np

from kinlab.dynamics import GRAVITY
from kinlab.dynamixel.codec.checks import checksum
from kinlab.dynamixel.codec.hextext import show_hex
from kinlab.dynamixel.codec.instructions import BY_NAME
from kinlab.dynamixel.codec.packets import Packet, encode, status
from kinlab.dynamixel.tables import load_table
from kinlab.kinematics.shoulder_arm import shoulder_arm_ik
from kinlab.papers.recompute.finding import Cause, Finding
from kinlab.papers.recompute.receptionist_tables import AX_12_OF_2006, CLOCK, JUDGE, NAME, SERVO
from kinlab.papers.tables import printed_table

STEPS, RANGE_DEG = 1024, 300
XTAL, PRESCALER, RELOAD = 16_000_000, 1024, 0x64
START = (-11.322, 7.653)


def text() -> Iterator[Finding]:
    """Section by section."""
    yield from specifications()
    yield from protocol()
    yield from packets()
    yield from settings()
    yield from timers()
    yield from lengths()
    yield from experiments()
    yield from references()


def specifications() -> Iterator[Finding]:
    """Section 2.3.1."""
    where = "section 2.3.1"
    tick = RANGE_DEG / STEPS
    yield JUDGE.figure(f"{where}, resolution", "0.29", tick, "deg", f"{RANGE_DEG} / {STEPS} = {tick:.4f}")
    yield JUDGE.figure(
        f"{where}, gear reduction", "193", SERVO.gear_ratio, "", f"RX-24F: {SERVO.gear_ratio:g}"
    )
    kgf_cm = SERVO.stall_nm / GRAVITY * 100
    yield JUDGE.figure(
        f"{where}, stall torque", "26", kgf_cm, "kgf cm",
        f"RX-24F: {SERVO.stall_nm} N m / {GRAVITY} * 100 = {kgf_cm:.2f}",
        [Cause("1 N m taken as 10 kgf cm", SERVO.stall_nm * 10, arithmetic=f"{SERVO.stall_nm} * 10 = 26")],
    )  # fmt: skip
    yield JUDGE.figure(f"{where}, stall current", "2.4", SERVO.stall_a, "A", f"RX-24F: {SERVO.stall_a} A")
    coldest, older = -5, AX_12_OF_2006[SERVO.find("temperature_limit").address]
    yield JUDGE.figure(
        f"{where}, running temperature, lowest", "-56", coldest, "degC", f"RX-24F: {coldest} degC",
        [Cause("the degree sign behind -5 was read as a 6", float(f"{coldest}6"),
               arithmetic=f"{coldest} and a 6: {coldest}6")], damaged=True,
    )  # fmt: skip
    yield JUDGE.figure(
        f"{where}, running temperature, highest", "856", float(SERVO.find("temperature_limit").initial), "degC",
        "RX-24F: 80 degC", [Cause("the degree sign behind 85 was read as a 6; 85 is the AX-12's", float(f"{older}6"),
               arithmetic=f"{older} and a 6: {older}6")], damaged=True,
    )  # fmt: skip
    initial = printed_table(NAME, "2.1").rows["address 4"]["initial"].figure.value
    own = CLOCK / (initial + 1)
    leaves = float(SERVO.find("baud_rate").initial)
    usual = printed_table(NAME, "2.2").rows[f"value {leaves:g}"]["goal"].figure.value
    yield JUDGE.figure(
        f"{where}, default baud rate", "57600", own, "bps", f"Table 2.1: {CLOCK} / ({initial:g} + 1) = {own:.0f}",
        [Cause(f"the usual rate next to that of value {leaves:g}, with which the RX-24F leaves the factory", usual,
               arithmetic=f"Table 2.2: {CLOCK} / ({leaves:g} + 1) = {CLOCK / (leaves + 1):.0f}, beside it {usual:g}")],
        table="2.1",
    )  # fmt: skip
    yield JUDGE.figure(f"{where}, number of IDs", "254", 253 + 1, "", "0 to 253: 253 + 1 = 254")
    slowest = CLOCK / 255
    yield JUDGE.figure(
        f"{where}, lowest speed", "7843", slowest, "bps", f"{CLOCK} / (254 + 1) = {slowest:.1f}"
    )
    yield JUDGE.figure(
        f"{where}, highest speed", "1", CLOCK / 2 / 1e6, "Mbps", f"{CLOCK} / (1 + 1) = 1000000"
    )


def protocol() -> Iterator[Finding]:
    """Section 2.3.2, address by address."""
    where = "section 2.3.2"
    highest = float(SERVO.find("id").high)
    yield JUDGE.figure(
        f"{where}, highest ID", "255", highest, "", f"RX-24F: IDs go to {highest:g}; 254 is everybody",
        remark="section 2.3.1 and the paragraph on the instruction packet have 0 to 253",
    )  # fmt: skip
    yield JUDGE.figure(f"{where}, highest ID of a packet", "0xFD", highest, "", f"{highest:g} = 0xFD")
    yield JUDGE.figure(
        f"{where}, model number", "0x000C", SERVO.number, "", f"RX-24F: {SERVO.number}",
        [Cause("the AX-12's", load_table("AX-12A").number, arithmetic="AX-12: 12 = 0x0C")],
    )  # fmt: skip
    alarms = {name: bit for bit, name in SERVO.find("shutdown").values}
    for error, text in (("overheating", "2"), ("input voltage", "0")):
        bit = alarms[error]
        yield JUDGE.figure(
            f"{where}, bit of the {error} error", text, bit, "", f"RX-24F: {error} is bit {bit}"
        )
    for register, place, text in (
        ("return_delay_time", "microseconds of a step of the return delay", "2"),
        ("cw_compliance_margin", "highest compliance margin", "255"),
        ("cw_compliance_slope", "highest compliance slope", "255"),
        ("cw_compliance_margin", "d, highest compliance margin", "254"),
        ("punch", "highest punch", "0x3FF"),
    ):
        item = SERVO.find(register)
        own = item.scale if "step" in place else float(item.high)
        older = (
            [Cause("the AX-12's, in its manual of 2006", 254, arithmetic="AX-12: 254")]
            if register == "cw_compliance_margin"
            else []
        )
        yield JUDGE.figure(f"{where}, {place}", text, own, "", f"RX-24F, {item.title}: {own:g}", older)
    punch = float(SERVO.find("punch").initial)
    yield JUDGE.figure(f"{where}, initial punch", "0x20", punch, "", f"RX-24F, Punch: {punch:g} = 0x20")
    volt = SERVO.find("min_voltage_limit").scale
    yield JUDGE.figure(f"{where}, voltage for 80", "8", 80 * volt, "V", f"80 * {volt} = 8")
    yield JUDGE.figure(f"{where}, value for 10 V", "0x64", 10 / volt, "", f"10 / {volt} = 100 = 0x64")
    top = STEPS - 1
    angle = top * RANGE_DEG / STEPS
    yield JUDGE.figure(
        f"{where}, angle for 0x3FF", "300", angle, "deg", f"{top} * {RANGE_DEG} / {STEPS} = {angle:.1f}"
    )
    speed = SERVO.find("moving_speed").physical(top)
    yield JUDGE.figure(f"{where}, speed for 0x3FF", "114", speed, "rpm", f"{top} * 0.111 = {speed:.2f}")
    for place in ("compliance margin", "d, compliance margin"):
        tick = RANGE_DEG / STEPS
        yield JUDGE.figure(
            f"{where}, {place}, degrees per tick", "0.2932", tick, "deg", f"{RANGE_DEG} / {STEPS} = {tick:.5f}",
            [Cause("300 / 1023, cut: the highest value for the number of steps", RANGE_DEG / top, cut=True,
                   arithmetic=f"{RANGE_DEG} / {top} = {RANGE_DEG / top:.5f}")],
        )  # fmt: skip
    yield JUDGE.figure(
        f"{where}, half of the highest torque", "8", 26 / 2, "kgf cm", "section 2.3.1: 26 / 2 = 13",
        [Cause("half of the AX-12's 16.5 kgf cm", 16.5 / 2, arithmetic="16.5 / 2 = 8.25")],
    )  # fmt: skip
    yield JUDGE.figure(f"{where}, 512 in hexadecimal", "0x1ff", 512, "", "512 = 0x200; 0x1ff = 511")


def packets() -> Iterator[Finding]:
    """The example at the end of section 2.3.2: a goal position for servo 1, and its answer."""
    where = "section 2.3.2, example"
    data = bytes((0x52, 0x02))
    goal = SERVO.find("goal_position")
    yield JUDGE.figure(f"{where}, data", "0x252", goal.decode(data), "", "0x52 + 256 * 0x02 = 594 = 0x252")
    yield JUDGE.figure(
        f"{where}, address", "0x1E", goal.address, "", f"RX-24F: {goal.title} at {goal.address} = 0x1E"
    )
    ticks = goal.decode(data)
    degrees = ticks * RANGE_DEG / STEPS
    yield JUDGE.figure(
        f"{where}, angle", "207.9", degrees, "deg", f"{ticks} * {RANGE_DEG} / {STEPS} = {degrees:.2f}",
        [Cause("a whole turn for the range, its tick rounded to 0.35 degrees", ticks * round(360 / STEPS, 2),
               arithmetic=f"360 / {STEPS} = {360 / STEPS:.4f}; {ticks} * 0.35 = {ticks * 0.35:.1f}")],
        remark=f"{207.9 / RANGE_DEG * STEPS:.0f} ticks would be 207.9 degrees",
    )  # fmt: skip
    params = bytes((goal.address,)) + data
    body = bytes((1, len(params) + 2, BY_NAME[1]["WRITE"].code)) + params
    total = sum(body)
    for name, text, value, line in (
        ("length", "0x05", len(params) + 2, f"{len(params)} parameters + 2 = {len(params) + 2}"),
        ("instruction", "0x03", body[2], "WRITE is 3"),
        (
            "checksum",
            "0x84",
            checksum(body),
            f"{' + '.join(str(b) for b in body)} = {total}, 255 - {total} = {255 - total}",
        ),
    ):
        yield JUDGE.figure(f"{where}, {name}", text, value, "", line)
    whole = show_hex(encode(Packet(1, 1, body[2], params)))
    yield _packet(
        f"{where}, instruction packet", "FF FF 01 05 03 1E 52 02 84", whole, "WRITE of 594 to address 30"
    )
    answer = show_hex(encode(status(1, 1)))
    line = "1 + 2 + 0 = 3, 255 - 3 = 252 = 0xFC"
    yield _packet(f"{where}, status packet", "FF FF 01 02 00 FC", answer, line)


def _packet(where: str, printed: str, own: str, line: str) -> Finding:
    return JUDGE.claim(where, printed, own, printed == own, line)


def settings() -> Iterator[Finding]:
    """Section 2.3.2 a to f, and 2.5."""
    where = "section 2.3.2"
    yield JUDGE.figure(f"{where} a, servos", "6", 2 * 3, "", "2 arms * 3 servos = 6")
    delay = SERVO.find("return_delay_time")
    least = int(delay.low) * delay.scale
    yield JUDGE.figure(
        f"{where} b, shortest return delay", "2", least, "us",
        f"RX-24F: from {delay.low}, {delay.scale:g} us each: {least:g}",
        remark="2 us is that of value 1; 0 is allowed",
    )  # fmt: skip
    yield JUDGE.figure(f"{where} d, slope in hexadecimal", "0x40", 64, "", "64 = 0x40")
    yield JUDGE.figure(f"{where} d, highest slope in hexadecimal", "0xfe", 254, "", "254 = 0xfe")
    yield JUDGE.figure(
        f"{where} e, highest torque", "1024", 0x3FF, "", "0x3FF = 3 * 256 + 15 * 16 + 15 = 1023"
    )
    yield JUDGE.figure(
        f"{where} e, supply", "12", 11.1, "V", "section 3.1.2: the battery's 11.1 V feed the servos directly",
        remark="12 V lies between that and a full battery, 3 * 4.2 = 12.6 V; the 26 kgf cm of the same paragraph are "
        "those at 12 V",
    )  # fmt: skip
    framed = 1e6 / (8 + 2) / 1000
    yield JUDGE.figure(
        f"{where} f, bytes per ms at 1 Mbps", "125", framed, "",
        f"8 bits, start and stop: 1000000 / 10 / 1000 = {framed:g}",
        [Cause("start and stop bit left out", 1e6 / 8 / 1000, arithmetic="1000000 / 8 / 1000 = 125")],
    )  # fmt: skip
    yield JUDGE.figure(
        "section 2.5, start bit",
        "1",
        0,
        "",
        "the sentence before it: the line rests at 1 and goes to 0 to begin",
    )
    bits = len(printed_table(NAME, "2.7").rows)
    yield JUDGE.figure("section 2.5, bits of UCSRB", "7", bits, "", f"Table 2.7 has {bits}", table="2.7")


def timers() -> Iterator[Finding]:
    """Section 2.5, 3: what the timer counts, and how often the loop runs."""
    clock = XTAL / PRESCALER
    yield JUDGE.figure(
        "section 2.5, timer clock", "15.625", clock, "Hz", f"{XTAL} / {PRESCALER} = {clock:g}",
        [Cause("the point parts thousands, as is usual in Indonesian", clock / 1000, arithmetic="15.625 = 15625")],
    )  # fmt: skip
    count = 256 - 0.010 * clock
    yield JUDGE.figure("section 2.5, TCNT1", "0x64", count, "", f"256 - 0.010 * {clock:g} = {count:g}")
    sixteen, eight = (2**16 - RELOAD) / clock * 1000, (2**8 - RELOAD) / clock * 1000
    yield JUDGE.figure(
        "section 2.5, Timer1, interrupt", "10", sixteen, "ms",
        f"16 bits: (65536 - {RELOAD}) / {clock:g} = {sixteen:.0f} ms",
        [Cause("the formula is that of a timer of 8 bits, such as Timer0", eight,
               arithmetic=f"(256 - {RELOAD}) / {clock:g} = {eight:.2f} ms")],
    )  # fmt: skip
    yield JUDGE.figure("section 2.5, sampling time", "20", 2 * 10, "ms", "2 interrupts * 10 ms = 20")
    yield JUDGE.figure(
        "section 4.1.1, sampling time",
        "16",
        20,
        "ms",
        "section 2.5: 20 ms",
        remark="the appendix has 16 ms as well",
    )


def lengths() -> Iterator[Finding]:
    """The two link lengths: sections 3.1.1 and 3.2, and the products that the appendix computes with."""
    first, product = 342.25, 462.5
    L1 = math.sqrt(first)
    L2 = product / L1
    start = {pair: _first_angle(*pair) for pair in ((18.5, 25.0), (17.0, 25.0), (18.5, 18.5))}
    seen = "; ".join(f"{a:g} and {b:g}: {angle:.2f}" for (a, b), angle in start.items())
    remark = f"θ1 at the start of section 4.1.1, {START} cm, in degrees with L1 and L2 of {seen}"
    root, quotient = f"appendix: √{first} = {L1:g}", f"appendix: {product} / {L1:g} = {L2:g}"
    yield JUDGE.figure("section 3.1.1, L1", "18.5", L1, "cm", root, remark=remark)
    yield JUDGE.figure("section 3.1.1, L2", "18.5", L2, "cm", quotient, remark=remark)
    yield JUDGE.figure("section 3.2, L1", "17", L1, "cm", root, remark=remark)
    yield JUDGE.figure("section 3.2, L2", "25", L2, "cm", quotient, remark=remark)
    yield JUDGE.figure("appendix, L1 L1", "342.25", 18.5**2, "cm²", "section 3.1.1: 18.5 * 18.5 = 342.25")
    mixed = Cause("L1 of section 3.1.1 with L2 of section 3.2", 18.5 * 25, arithmetic="18.5 * 25 = 462.5")
    for place in ("C1L1L2C3", "L1L2S3"):
        line = "section 3.1.1: 18.5 * 18.5 = 342.25; section 3.2: 17 * 25 = 425"
        yield JUDGE.figure(f"appendix, L1 L2 in {place}", "462.5", 18.5**2, "cm²", line, [mixed])


def _first_angle(L1: float, L2: float) -> float:
    """θ1 in degrees, elbow counter-clockwise, with the hand at the start of the experiments."""
    found, _ = shoulder_arm_ik(np.array([*START, 0.0]), L1, L2)
    return float(np.degrees(found[0, 0]))


def experiments() -> Iterator[Finding]:
    """Section 4.1.1, and the parameters that the conclusion repeats."""
    way = 27.6530 - 7.6530
    yield JUDGE.figure("section 4.1.1, way along y", "20", way, "cm", "27.6530 - 7.6530 = 20")
    yield JUDGE.figure("conclusion, K_p", "3.8", 3.8, "", "section 4.1.2: 3.8")
    yield JUDGE.figure("conclusion, K_v", "0.02", 0.2, "", "section 4.1.2: 0.2")
    table = printed_table(NAME, "4.1")
    for row, text in (("K_f", "0.2"), ("K_env", "9"), ("D_env", "5"), ("M_env", "9")):
        own = table.rows[row]["value"].figure.value
        yield JUDGE.figure(f"conclusion, {row}", text, own, "", f"Table 4.1: {own:g}", table="4.1")


def references() -> Iterator[Finding]:
    """Equations that the text names by number."""
    for where, text, chapter, number, less, why in (
        ("section 2.1.1, the load torque", "2.22", 2, 28, 6, "τ_l is (2.28)"),
        ("section 2.1.1, the motor's torque", "2.23", 2, 29, 6, "τ_m is (2.29)"),
        ("section 2.1.1, the motor's dynamics", "4.21", 2, 27, 6, "J θ'' is (2.27)"),
        ("section 2.1.1, the parameters J and K_t", "2.24", 2, 30, 6, "both are in (2.30)"),
        ("section 2.1.1, the block diagram", "2.29", 2, 35, 6, "J_n θ'' is (2.35)"),
        ("section 3.3, the pseudo-inverse", "4.11", 3, 19, 8, "J^+ is (3.19)"),
        ("section 3.3, the Jacobian, step 2", "4.9", 3, 17, 8, "J_ij is (3.17)"),
        ("section 3.3, the inverse of the Jacobian", "4.12", 3, 20, 8, "J^-1 is (3.20)"),
        ("section 4.2.1, the disturbance", "3.3", 2, 22, 0, "τ_disturbance is (2.22), and there is no (3.3)"),
    ):
        own, earlier = f"{chapter}.{number}", f"{text[0]}.{number - less}"
        moved = "" if text[0] == str(chapter) else f", in what was then chapter {text[0]}"
        reading = f"its number before {less} equations were put in{moved}", text == earlier
        line = f"{why}; {number} - {less} = {number - less}" if reading[1] else why
        yield JUDGE.claim(f"{where}: its number", f"({text})", f"({own})", text == own, line, reading=reading)
