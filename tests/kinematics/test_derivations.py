"""Every closed form, derived again in symbols: it holds identically, not only in samples."""

import sympy as sp
from sympy import cos, sin

c, f, t = sp.symbols("c f t", positive=True)
alpha, beta, gamma = sp.symbols("alpha beta gamma", real=True)
x, y, z = sp.symbols("x y z", real=True)


def turn(axis, q):
    """Rodrigues' formula in symbols."""
    a = sp.Matrix(axis)
    K = sp.Matrix([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    return sp.eye(3) + sin(q) * K + (1 - cos(q)) * K * K


def tip(axes, links, q):
    """T = prod_i Rot(axis_i, q_i) Trans(link_i), as rotation and position."""
    R, p = sp.eye(3), sp.zeros(3, 1)
    for axis, link, angle in zip(axes, links, q, strict=True):
        R = R * turn(axis, angle)
        p = p + R * sp.Matrix(link)
    return R, p


def vanishes(expression):
    return sp.simplify(sp.expand_trig(sp.expand(expression))) == 0


class TestLeg:
    r = c + f * cos(beta) + t * cos(beta + gamma)
    h = f * sin(beta) + t * sin(beta + gamma)

    def test_the_chain_is_the_formula_of_r_and_h(self):
        _, p = tip(
            [(0, 0, 1), (0, -1, 0), (0, -1, 0)], [(c, 0, 0), (f, 0, 0), (t, 0, 0)], [alpha, beta, gamma]
        )
        for got, wanted in zip(p, (self.r * cos(alpha), self.r * sin(alpha), self.h), strict=True):
            assert vanishes(got - wanted)

    def test_the_tangent_of_half_the_knee_is_the_root_of_stretch_over_fold(self):
        """tan^2(gamma / 2) = stretch / fold, by (1 - cos) / (1 + cos) for any gamma."""
        d2 = (self.r - c) ** 2 + self.h**2
        stretch, fold = (f + t) ** 2 - d2, d2 - (f - t) ** 2
        assert vanishes(stretch - 2 * f * t * (1 - cos(gamma)))
        assert vanishes(fold - 2 * f * t * (1 + cos(gamma)))

    def test_sine_and_cosine_of_the_knee_are_those_that_beta_is_computed_from(self):
        """The code's `sine` is -4 f t sin(gamma), by the roots; its `cosine` is 4 f (f + t cos(gamma))."""
        d2 = (self.r - c) ** 2 + self.h**2
        stretch, fold = (f + t) ** 2 - d2, d2 - (f - t) ** 2
        assert vanishes(4 * stretch * fold - (4 * f * t * sin(gamma)) ** 2)
        assert vanishes(2 * (d2 + f * f - t * t) - 4 * f * (f + t * cos(gamma)))

    def test_beta_is_the_angle_of_the_foot_less_that_of_the_bent_leg(self):
        """With those, atan2's arguments are sin(beta) and cos(beta), times 4 f d^2 > 0."""
        r, h = self.r - c, self.h
        d2 = r * r + h * h
        sine, cosine = -4 * f * t * sin(gamma), 4 * f * (f + t * cos(gamma))
        assert vanishes(h * cosine + r * sine - 4 * f * d2 * sin(beta))
        assert vanishes(r * cosine - h * sine - 4 * f * d2 * cos(beta))

    def test_backwards_is_the_same_leg_seen_from_behind_its_axis(self):
        _, p = tip(
            [(0, 0, 1), (0, -1, 0), (0, -1, 0)],
            [(c, 0, 0), (f, 0, 0), (t, 0, 0)],
            [alpha + sp.pi, beta, gamma],
        )
        for got, wanted in zip(p, (-self.r * cos(alpha), -self.r * sin(alpha), self.h), strict=True):
            assert vanishes(got - wanted)


class TestHumanoidLeg:
    axes = ((0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 1, 0), (0, 1, 0), (1, 0, 0))
    thigh, shank, foot = sp.symbols("thigh shank foot", positive=True)
    q = sp.symbols("yaw roll pitch knee ankle_pitch ankle_roll", real=True)

    lengths = (0, 0, thigh, shank, 0, foot)

    def pose(self, q):
        return tip(self.axes, [(0, 0, -length) for length in self.lengths], q)

    def hip_seen_from_ankle(self):
        # The hip turns R and p alike, so that it drops out of R^T p: its angles may be taken as zero.
        R, p = self.pose((0, 0, 0, *self.q[3:]))
        return -R.T * p - sp.Matrix([0, 0, self.foot])

    def test_the_attitude_is_that_of_the_hip_times_that_of_the_ankle(self):
        R, _ = self.pose(self.q)
        yaw, roll, pitch, knee, ankle_pitch, ankle_roll = self.q
        hip = turn((0, 0, 1), yaw) * turn((1, 0, 0), roll) * turn((0, 1, 0), pitch)
        ankle = turn((0, 1, 0), knee + ankle_pitch) * turn((1, 0, 0), ankle_roll)
        assert all(vanishes(e) for e in R - hip * ankle)

    def test_knee_and_ankle_alone_place_the_hip_over_the_ankle(self):
        """hip = Rx(-roll) Ry(-ankle pitch) w, with w the hip over a straight ankle: the code's `w_angle`."""
        *_, knee, ankle_pitch, ankle_roll = self.q
        w = sp.Matrix([-self.thigh * sin(knee), 0, self.shank + self.thigh * cos(knee)])
        wanted = turn((1, 0, 0), -ankle_roll) * turn((0, 1, 0), -ankle_pitch) * w
        assert all(vanishes(e) for e in self.hip_seen_from_ankle() - wanted)

    def test_the_tangent_of_half_the_knee_is_the_root_of_stretch_over_fold(self):
        knee = self.q[3]
        hip = self.hip_seen_from_ankle()
        d2 = sp.simplify(hip.dot(hip))
        stretch = (self.thigh + self.shank) ** 2 - d2
        fold = d2 - (self.thigh - self.shank) ** 2
        assert vanishes(stretch - 2 * self.thigh * self.shank * (1 - cos(knee)))
        assert vanishes(fold - 2 * self.thigh * self.shank * (1 + cos(knee)))

    def test_ankle_roll_and_pitch_are_read_off_the_hip(self):
        """(y, z) of the hip turns with the roll alone; its length and x with pitch and knee alone."""
        *_, knee, ankle_pitch, ankle_roll = self.q
        hip = self.hip_seen_from_ankle()
        lateral = (self.shank + self.thigh * cos(knee)) * cos(ankle_pitch) - self.thigh * sin(knee) * sin(
            ankle_pitch
        )
        assert vanishes(hip[1] - lateral * sin(ankle_roll))
        assert vanishes(hip[2] - lateral * cos(ankle_roll))
        w_x, w_z = -self.thigh * sin(knee), self.shank + self.thigh * cos(knee)
        # The angle of (w_z, w_x) less that of (lateral, x) is the pitch.
        assert vanishes(w_x * lateral - w_z * hip[0] - (w_x**2 + w_z**2) * sin(ankle_pitch))
        assert vanishes(w_z * lateral + w_x * hip[0] - (w_x**2 + w_z**2) * cos(ankle_pitch))

    def test_the_hips_angles_are_read_off_rz_rx_ry(self):
        yaw, roll, pitch, *_ = self.q
        A = turn((0, 0, 1), yaw) * turn((1, 0, 0), roll) * turn((0, 1, 0), pitch)
        assert vanishes(-A[0, 1] - sin(yaw) * cos(roll))
        assert vanishes(A[1, 1] - cos(yaw) * cos(roll))
        assert vanishes(A[2, 1] - sin(roll))
        assert vanishes(cos(yaw) * A[1, 1] - sin(yaw) * A[0, 1] - cos(roll))
        assert vanishes(cos(yaw) * A[0, 2] + sin(yaw) * A[1, 2] - sin(pitch))
        assert vanishes(cos(yaw) * A[0, 0] + sin(yaw) * A[1, 0] - cos(pitch))

    def test_hip_over_is_the_same_attitude(self):
        yaw, roll, pitch, *_ = self.q
        A = turn((0, 0, 1), yaw) * turn((1, 0, 0), roll) * turn((0, 1, 0), pitch)
        over = turn((0, 0, 1), yaw + sp.pi) * turn((1, 0, 0), sp.pi - roll) * turn((0, 1, 0), pitch + sp.pi)
        assert all(vanishes(e) for e in A - over)


class TestShoulderArm:
    upper, fore = sp.symbols("upper fore", positive=True)
    q = sp.symbols("q1 q2 q3", real=True)

    def hand(self):
        _, p = tip(
            [(0, 0, 1), (0, 1, 0), (0, 0, 1)], [(0, 0, 0), (self.upper, 0, 0), (self.fore, 0, 0)], self.q
        )
        return p

    def test_the_chain_is_equation_3_13(self):
        q1, q2, q3 = self.q
        plane = sp.Matrix([self.upper + self.fore * cos(q3), self.fore * sin(q3), 0])
        wanted = turn((0, 0, 1), q1) * turn((0, 1, 0), q2) * plane
        assert all(vanishes(e) for e in self.hand() - wanted)

    def test_the_distance_along_the_upper_arm_follows_from_the_distance_of_the_hand(self):
        """X = (d^2 + upper^2 - fore^2) / (2 upper) = upper + fore cos(q3)."""
        p = self.hand()
        d2 = sp.simplify(p.dot(p))
        X = (d2 + self.upper**2 - self.fore**2) / (2 * self.upper)
        assert vanishes(X - self.upper - self.fore * cos(self.q[2]))

    def test_the_second_angle_is_that_of_the_height_against_the_depth(self):
        """z = -X sin(q2), and the depth X cos(q2) is the root of X^2 - z^2 as well as of h^2 - Y^2."""
        _, q2, q3 = self.q
        p = self.hand()
        X, Y = self.upper + self.fore * cos(q3), self.fore * sin(q3)
        h2 = p[0] ** 2 + p[1] ** 2
        assert vanishes(p[2] + X * sin(q2))
        assert vanishes((X * cos(q2)) ** 2 - (X**2 - p[2] ** 2))
        assert vanishes((X * cos(q2)) ** 2 - (h2 - Y**2))

    def test_the_first_angle_is_that_of_the_hand_less_that_of_depth_and_elbow(self):
        q1, q2, q3 = self.q
        p = self.hand()
        depth, Y = (self.upper + self.fore * cos(q3)) * cos(q2), self.fore * sin(q3)
        h2 = depth**2 + Y**2
        assert vanishes(p[1] * depth - p[0] * Y - h2 * sin(q1))
        assert vanishes(p[0] * depth + p[1] * Y - h2 * cos(q1))
