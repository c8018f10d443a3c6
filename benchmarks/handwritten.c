/* The gyro's tick as one would write it by hand: the yardstick of the generated kernel. The same
   arithmetic, generator and features as HRG.Gyroscopes.HRGEnvelope with constant environment and drives that
   are never overloaded. handwritten [TICKS [D [N]]] prints ns per tick and the angle after them,
   of a gyro with damping anisotropy D and angle random walk N by force noise. */
#include "arithmetic.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define LANES 12
static const double PI = 3.14159265358979323846, TS = 1e-3, K = 0.277, TAU = 450.0;

typedef struct {
  double x[3][LANES], y[3][LANES], deviate[LANES], lag[8], decay[8], weight[8], walk;
} Noise;

typedef struct {
  double phase, amplitude, quadrature, angle; /* integrals of the loops */
} Loops;

typedef struct {
  double dx, dy, ds, shift, sc, ss, coupling, duffing, electrostatic; /* resonator */
  double gx, gy, skew, cubic, cx, sx, cy, sy, offset, feedthrough; /* pick-offs */
  double drive[4];
  double force_noise, pickoff_noise, walk_noise, flicker_noise, rotation_noise;
  double map[7], angle_map[6], cancel_cos, cancel_sin, loop_delay, vr_error, quadrature_aim, start;
} Parameters;

typedef struct {
  Parameters p;
  Noise noise;
  Loops loops;
  double z[4], reference, command[4], force[4], modal, commanded, counted, bias, correction, clock;
  double gyro_angle, gyro_rate, valid;
} Gyro;

static double scrambled(double number) {
  double low = number - 67108864.0 * m_floor(number / 67108864.0);
  double sum = low * low + number;
  return sum - 4294944442.0 * m_floor(sum / 4294944442.0);
}

static void seed_noise(Noise *n, double seed) {
  double h = seed + 1234567891.0, memory[72];
  for (int i = 0; i < 4; i++) h = scrambled(h);
  for (int i = 0; i < LANES; i++) memory[i] = seed + 1.0;
  for (int i = LANES; i < 72; i++) memory[i] = (h = scrambled(h + 40014.0 * (i + 1))) + 1.0;
  memcpy(n->x, memory, sizeof n->x);
  memcpy(n->y, memory + 36, sizeof n->y);
  double constant = 0.01;
  for (int i = 0; i < 8; i++, constant *= 8.0) {
    n->decay[i] = m_exp(-TS / constant);
    n->weight[i] = (1.0 - n->decay[i]) * sqrt(constant / TS);
  }
}

static inline double central(double q) {
  double s = 8.329862557267806 * q * q - 1.0;
  return q *
         ((((((0.0054353253574168925 * s - 0.24094814659690697) * s + 2.085867768156681) * s -
             7.229920605988005) * s + 12.004639702300098) * s - 9.569279759886662) * s +
          2.948094204210258) /
         ((((((0.00758311536957823 * s - 0.16421354994318896) * s + 1.0762563110819825) * s -
             3.171980919292821) * s + 4.7153814310954) * s - 3.462207353924893) * s + 1.0);
}

static double tail(double u) {
  double p = u < 0.5 ? u : 1.0 - u, r = sqrt(-m_log(p)) - 1.6;
  double q =
      (((((((7.7454501427834140764e-4 * r + 0.0227238449892691845833) * r +
            0.24178072517745061177) * r + 1.27045825245236838258) * r + 3.64784832476320460504) * r +
          5.7694972214606914055) * r + 4.6303378461565452959) * r + 1.42343711074968357734) /
      (((((((1.05075007164441684324e-9 * r + 5.475938084995344946e-4) * r +
            0.0151986665636164571966) * r + 0.14810397642748007459) * r + 0.68976733498510000455) * r +
          1.6763848301838038494) * r + 2.05319162663775882187) * r + 1.0);
  return u < 0.5 ? -q : q;
}

static void draw(Noise *n) {
  const double m1 = 4294967087.0, m2 = 4294944443.0;
  double u[LANES];
  for (int i = 0; i < LANES; i++) {
    double x = 1403580.0 * n->x[1][i] - 810728.0 * n->x[0][i];
    double y = 527612.0 * n->y[2][i] - 1370589.0 * n->y[0][i];
    x -= m1 * m_floor(x / m1);
    y -= m2 * m_floor(y / m2);
    n->x[0][i] = n->x[1][i], n->x[1][i] = n->x[2][i], n->x[2][i] = x;
    n->y[0][i] = n->y[1][i], n->y[1][i] = n->y[2][i], n->y[2][i] = y;
    double d = x - y;
    u[i] = (d > 0.0 ? d : d + m1) * (1.0 / 4294967088.0);
  }
  for (int i = 0; i < 8; i++) n->deviate[i] = central(u[i] - 0.5);
  for (int i = 0; i < 8; i++)
    if (fabs(u[i] - 0.5) > 0.49) n->deviate[i] = tail(u[i]);
  for (int i = 8; i < LANES; i++) n->deviate[i] = 3.4641016151377544 * (u[i] - 0.5);
  for (int i = 0; i < 8; i++) n->lag[i] = n->lag[i] * n->decay[i] + n->deviate[8] * n->weight[i];
}

static inline void rates(const Gyro *g, const double *z, double *dz) {
  const Parameters *p = &g->p;
  double xx = z[0] * z[0] + z[1] * z[1], yy = z[2] * z[2] + z[3] * z[3], swing = p->duffing * (xx + yy);
  double turn = p->coupling + 2.0 / 3.0 * p->duffing * (z[0] * z[3] - z[2] * z[1]);
  double nx = g->reference - p->shift + p->sc - (swing - p->electrostatic * xx);
  double ny = g->reference - p->shift - p->sc - (swing - p->electrostatic * yy);
  dz[0] = -p->dx * z[0] - p->ds * z[2] - nx * z[1] - p->ss * z[3] + turn * z[2] + g->force[0];
  dz[1] = -p->dx * z[1] - p->ds * z[3] + nx * z[0] + p->ss * z[2] + turn * z[3] + g->force[1];
  dz[2] = -p->dy * z[2] - p->ds * z[0] - ny * z[3] - p->ss * z[1] - turn * z[0] + g->force[2];
  dz[3] = -p->dy * z[3] - p->ds * z[1] + ny * z[2] + p->ss * z[0] - turn * z[1] + g->force[3];
}

static void step(Gyro *g) {
  double k1[4], k2[4], k3[4], k4[4], y[4];
  rates(g, g->z, k1);
  for (int i = 0; i < 4; i++) y[i] = g->z[i] + 0.5 * TS * k1[i];
  rates(g, y, k2);
  for (int i = 0; i < 4; i++) y[i] = g->z[i] + 0.5 * TS * k2[i];
  rates(g, y, k3);
  for (int i = 0; i < 4; i++) y[i] = g->z[i] + TS * k3[i];
  rates(g, y, k4);
  for (int i = 0; i < 4; i++) g->z[i] += TS / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
}

static inline double loop(double *integral, double w, double error) {
  *integral += TS * error;
  return 2.0 * w * error + w * w * *integral;
}

static void tick(Gyro *g, double rotation, double setpoint) {
  const Parameters *p = &g->p;
  Noise *n = &g->noise;
  draw(n);
  const double *z = g->z;
  double y0 = z[2] + p->skew * z[0], y1 = z[3] + p->skew * z[1];
  double gx = p->gx * (1.0 + 0.75 * p->cubic * (z[0] * z[0] + z[1] * z[1]));
  double gy = p->gy * (1.0 + 0.75 * p->cubic * (y0 * y0 + y1 * y1));
  double a = gx * (p->cx * z[0] + p->sx * z[1]) + p->offset + p->feedthrough * g->command[0];
  double b = gx * (p->cx * z[1] - p->sx * z[0]) + p->feedthrough * g->command[1];
  double c = gy * (p->cy * y0 + p->sy * y1) + p->feedthrough * g->command[2];
  double d = gy * (p->cy * y1 - p->sy * y0) + p->feedthrough * g->command[3];
  a += p->pickoff_noise * n->deviate[4], b += p->pickoff_noise * n->deviate[5];
  c += p->pickoff_noise * n->deviate[6], d += p->pickoff_noise * n->deviate[7];
  double energy = a * a + b * b + c * c + d * d, r = a * a + b * b - c * c - d * d;
  double s = 2.0 * (a * c + b * d), principal = m_atan2(s, r) / 2.0, before = g->modal;
  double length = sqrt(r * r + s * s), major = sqrt((1.0 + fabs(r / length)) / 2.0);
  double minor = s / length / (2.0 * major), turns = m_floor((g->modal - principal) / PI + 0.5);
  double sign = 1.0 - 2.0 * (turns - 2.0 * m_floor(turns / 2.0));
  g->modal = principal + PI * turns;
  double cs = sign * (r >= 0.0 ? major : fabs(minor));
  double sn = sign * (r >= 0.0 ? minor : principal < 0.0 ? -major : major);
  double amplitude = sqrt((energy + length) / 2.0), quadrature = (a * d - c * b) / amplitude;
  double phase = m_atan2(-(b * cs + d * sn), a * cs + c * sn);
  g->clock += TS;
  g->valid = fabs(amplitude - setpoint) <= 0.2 * setpoint && fabs(phase) <= 0.05;
  g->reference = loop(&g->loops.phase, 200.0, phase);
  double growth = loop(&g->loops.amplitude, 6.0, setpoint - amplitude);
  double square = loop(&g->loops.quadrature, 6.0, p->quadrature_aim - quadrature);
  double c4 = cs * cs - sn * sn, s4 = 2.0 * cs * sn;
  g->correction += TS * g->bias;
  g->bias = p->map[0] + p->map[1] * cs + p->map[2] * sn + p->map[3] * c4 + p->map[4] * s4 +
            p->map[5] * (c4 * c4 - s4 * s4) + p->map[6] * 2.0 * c4 * s4;
  g->commanded += TS * g->counted;
  g->counted = K * rotation;
  double slow = 0.0;
  for (int i = 0; i < 8; i++) slow += n->lag[i];
  n->walk += p->walk_noise * n->deviate[9];
  double rate = g->counted * (1.0 + p->vr_error + p->rotation_noise * n->deviate[10]) +
                p->cancel_sin * c4 - p->cancel_cos * s4 + n->walk + p->flicker_noise * slow;
  const double *m = p->angle_map;
  double error = m[0] * cs + m[1] * sn + m[2] * c4 + m[3] * s4 + m[4] * (c4 * c4 - s4 * s4) +
                 m[5] * 2.0 * c4 * s4;
  double angle = (g->commanded - (g->modal / 2.0 - error)) / K - g->correction;
  g->gyro_rate = (angle - g->gyro_angle) / TS;
  g->gyro_angle = angle;
  double lag = p->loop_delay * (g->modal - before) / TS, lc = 1.0 - lag * lag / 2.0;
  double ls = lag - lag * lag * lag / 6.0, fc = cs * lc + sn * ls, fs = sn * lc - cs * ls;
  double antinode = growth, node = 2.0 * rate * amplitude;
  g->command[0] = antinode * fc - node * fs, g->command[1] = -square * fs;
  g->command[2] = antinode * fs + node * fc, g->command[3] = square * fc;
  const double *u = g->command;
  for (int i = 0; i < 2; i++) {
    g->force[i] = p->drive[0] * u[i] + p->drive[1] * u[i + 2] + p->force_noise * n->deviate[i];
    g->force[i + 2] = p->drive[2] * u[i] + p->drive[3] * u[i + 2] + p->force_noise * n->deviate[i + 2];
  }
}

int main(int count, char **arguments) {
  static Gyro g;
  long ticks = count > 1 ? atol(arguments[1]) : 1000000;
  double d = count > 2 ? atof(arguments[2]) : 1e-6, start = 0.6;
  double mean = 1.0 / TAU, axis = 0.0, walk = count > 3 ? atof(arguments[3]) : 0.0;
  g.p = (Parameters){.dx = mean + d / 2.0 * m_cos(axis), .dy = mean - d / 2.0 * m_cos(axis),
                     .gx = 1.0, .gy = 1.0, .cx = 1.0, .cy = 1.0, .drive = {1.0, 0.0, 0.0, 1.0}};
  g.p.force_noise = 2.0 * K * sqrt(walk * walk / TS);
  seed_noise(&g.noise, 1.0);
  g.z[0] = m_cos(2.0 * start), g.z[2] = m_sin(2.0 * start);
  g.modal = 2.0 * start, g.commanded = start, g.loops.amplitude = mean / 36.0;
  tick(&g, 0.0, 1.0);
  struct timespec from, to;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
  for (long i = 0; i < ticks; i++) {
    step(&g);
    tick(&g, 0.0, 1.0);
  }
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
  double elapsed = (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
  printf("%.17g %.17g\n", elapsed / (double)ticks, g.gyro_angle);
  return 0;
}
