/* The yardstick: recursive Newton-Euler for any chain of revolute joints in plain scalar C, one state after another. */
#include <math.h>
#include <stddef.h>

enum { MOST = 8 };

typedef struct {
    double axis[3], link[3], mass, centre[3], inertia[9];
} part;

static void cross(const double *u, const double *v, double *w)
{
    w[0] = u[1] * v[2] - u[2] * v[1];
    w[1] = u[2] * v[0] - u[0] * v[2];
    w[2] = u[0] * v[1] - u[1] * v[0];
}

static void times(const double *R, const double *v, double *w)
{
    for (int i = 0; i < 3; i++)
        w[i] = R[3 * i] * v[0] + R[3 * i + 1] * v[1] + R[3 * i + 2] * v[2];
}

static void times_transposed(const double *R, const double *v, double *w)
{
    for (int i = 0; i < 3; i++)
        w[i] = R[i] * v[0] + R[3 + i] * v[1] + R[6 + i] * v[2];
}

static void rotation(const double *a, double q, double *R)
{
    double s = sin(q), c = cos(q), d = 1 - c, x = a[0], y = a[1], z = a[2];
    R[0] = c + d * x * x, R[1] = d * x * y - s * z, R[2] = d * x * z + s * y;
    R[3] = d * x * y + s * z, R[4] = c + d * y * y, R[5] = d * y * z - s * x;
    R[6] = d * x * z - s * y, R[7] = d * y * z + s * x, R[8] = c + d * z * z;
}

void inverse_dynamics(const part *parts, size_t n, const double *gravity, const double *q, const double *qd,
                      const double *qdd, double *torque, size_t count)
{
    for (size_t s = 0; s < count; s++, q += n, qd += n, qdd += n, torque += n) {
        double R[MOST][9], F[MOST][3], N[MOST][3], t[3], u[3];
        double w[3] = {0}, a[3] = {0}, v[3] = {-gravity[0], -gravity[1], -gravity[2]};
        for (size_t i = 0; i < n; i++) {
            const part *p = &parts[i];
            double w0[3], a0[3], v0[3];
            if (i > 0) {
                const double *link = parts[i - 1].link;
                cross(a, link, t);
                for (int k = 0; k < 3; k++) v[k] += t[k];
                cross(w, link, t);
                cross(w, t, u);
                for (int k = 0; k < 3; k++) v[k] += u[k];
            }
            rotation(p->axis, q[i], R[i]);
            times_transposed(R[i], w, w0);
            times_transposed(R[i], a, a0);
            times_transposed(R[i], v, v0);
            double rate[3] = {p->axis[0] * qd[i], p->axis[1] * qd[i], p->axis[2] * qd[i]};
            cross(w0, rate, t);
            for (int k = 0; k < 3; k++) {
                w[k] = w0[k] + rate[k];
                a[k] = a0[k] + t[k] + p->axis[k] * qdd[i];
                v[k] = v0[k];
            }
            cross(a, p->centre, t);
            cross(w, p->centre, u);
            double x[3];
            cross(w, u, x);
            for (int k = 0; k < 3; k++) F[i][k] = p->mass * (v[k] + t[k] + x[k]);
            times(p->inertia, a, t);
            times(p->inertia, w, u);
            cross(w, u, x);
            for (int k = 0; k < 3; k++) N[i][k] = t[k] + x[k];
        }
        double f[3] = {0}, m[3] = {0};
        for (size_t i = n; i-- > 0;) {
            const part *p = &parts[i];
            /* f and m act at the end of this link, in its frame. */
            cross(p->link, f, t);
            cross(p->centre, F[i], u);
            for (int k = 0; k < 3; k++) {
                m[k] += N[i][k] + t[k] + u[k];
                f[k] += F[i][k];
            }
            torque[i] = p->axis[0] * m[0] + p->axis[1] * m[1] + p->axis[2] * m[2];
            times(R[i], f, t);
            times(R[i], m, u);
            for (int k = 0; k < 3; k++) f[k] = t[k], m[k] = u[k];
        }
    }
}
