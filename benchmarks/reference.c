/* The yardstick: the three-joint leg in plain scalar C, the same formulas, one leg after another. */
#include <math.h>
#include <stddef.h>

void leg_fk(const double *q, double *foot, size_t count, double c, double f, double t)
{
    for (size_t i = 0; i < count; i++, q += 3, foot += 3) {
        double r = c + f * cos(q[1]) + t * cos(q[1] + q[2]);
        foot[0] = r * cos(q[0]);
        foot[1] = r * sin(q[0]);
        foot[2] = f * sin(q[1]) + t * sin(q[1] + q[2]);
    }
}

void leg_ik(const double *foot, double *q, unsigned char *reachable, size_t count, double c, double f, double t)
{
    const double slack = 2e-12;
    for (size_t i = 0; i < count; i++, q += 3, foot += 3) {
        double h = foot[2], r = sqrt(foot[0] * foot[0] + foot[1] * foot[1]) - c;
        double d2 = r * r + h * h;
        double stretch = (f + t) * (f + t) - d2, fold = d2 - (f - t) * (f - t);
        reachable[i] = stretch >= -slack * (f + t) && fold >= -slack * fabs(f - t);
        if (!reachable[i]) {
            q[0] = q[1] = q[2] = NAN;
            continue;
        }
        stretch = sqrt(stretch > 0 ? stretch : 0);
        fold = sqrt(fold > 0 ? fold : 0);
        double sine = 2 * stretch * fold, cosine = 2 * (d2 + f * f - t * t);
        q[0] = atan2(foot[1], foot[0]);
        q[1] = atan2(h * cosine + r * sine, r * cosine - h * sine);
        q[2] = -2 * atan2(stretch, fold);
    }
}
