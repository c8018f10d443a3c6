/* Arithmetic that the generated equations call. The transcendental functions are our own, so that
   every platform computes the same bits; errors are below 2 units in the last place.
   Sources: S. L. Moshier, Cephes Math Library (sin, cos, atan, exp); Sun Microsystems, fdlibm (log). */
#ifndef ARITHMETIC_H
#define ARITHMETIC_H

#include <math.h>
#include <string.h>

#ifdef __GNUC__
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

/* Largest whole number not above x, for |x| < 2^51: adding 1.5 * 2^52 rounds to a whole number. */
static inline double m_floor(double x) {
  const double shift = 6755399441055744.0;
  double whole = (x + shift) - shift;
  return whole > x ? whole - 1.0 : whole;
}

static inline double m_square(double x) { return x * x; }

/* x less the nearest multiple of pi/2, which is returned modulo 4; for |x| < 1e8, beyond which the
   products with parts of pi/2 are no longer exact: no number then. */
static inline int quarter_turns(double x, double *rest) {
  if (!(fabs(x) < 1e8)) {
    *rest = NAN;
    return 0;
  }
  double n = m_floor(x * 6.36619772367581343076e-1 + 0.5);
  *rest = ((x - n * 1.57079625129699707031) - n * 7.54978941586159635335e-8) -
          n * 5.39030252995776476554e-15;
  return (int)((long long)n & 3);
}

/* For |x| <= pi/4. */
static inline double sine_kernel(double x) {
  double z = x * x;
  return x + x * z *
                 (((((1.58962301576546568060e-10 * z - 2.50507477628578072866e-8) * z +
                     2.75573136213857245213e-6) *
                        z -
                    1.98412698295895385996e-4) *
                       z +
                   8.33333333332211858878e-3) *
                      z -
                  1.66666666666666307295e-1);
}

/* For |x| <= pi/4. */
static inline double cosine_kernel(double x) {
  double z = x * x;
  return 1.0 - 0.5 * z +
         z * z *
             (((((-1.13585365213876817300e-11 * z + 2.08757008419747316778e-9) * z -
                 2.75573141792967388112e-7) *
                    z +
                2.48015872888517045348e-5) *
                   z -
               1.38888888888730564116e-3) *
                  z +
              4.16666666666665929218e-2);
}

static inline double m_sin(double x) {
  if (fabs(x) <= 0.78) return sine_kernel(x);
  double rest;
  int quarter = quarter_turns(x, &rest);
  double value = quarter & 1 ? cosine_kernel(rest) : sine_kernel(rest);
  return quarter & 2 ? -value : value;
}

static inline double m_cos(double x) {
  if (fabs(x) <= 0.78) return cosine_kernel(x);
  double rest;
  int quarter = quarter_turns(x, &rest);
  double value = quarter & 1 ? sine_kernel(rest) : cosine_kernel(rest);
  return (quarter + 1) & 2 ? -value : value;
}

/* For x >= 0. */
static inline double arc_tangent(double x) {
  double base = 0.0, low = 0.0;
  if (x > 2.41421356237309504880) {
    base = 1.57079632679489661923;
    low = 6.123233995736765886130e-17;
    x = -1.0 / x;
  } else if (x > 0.66) {
    base = 7.85398163397448309616e-1;
    low = 3.061616997868382943065e-17;
    x = (x - 1.0) / (x + 1.0);
  }
  double z = x * x;
  double p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z -
               7.500855792314704667340e1) *
                  z -
              1.228866684490136173410e2) *
                 z -
             6.485021904942025371773e1;
  double q = ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z +
               4.328810604912902668951e2) *
                  z +
              4.853903996359136964868e2) *
                 z +
             1.945506571482613964425e2;
  return base + ((x * (z * p / q) + x) + low);
}

static inline double m_atan2(double y, double x) {
  const double pi = 3.14159265358979323846;
  if (x == 0.0 && y == 0.0) return 0.0;
  double angle = arc_tangent(fabs(y) / fabs(x));
  if (x < 0.0) angle = pi - angle;
  return y < 0.0 ? -angle : angle;
}

/* For normal x > 0. */
static inline double m_log(double x) {
  unsigned long long bits;
  memcpy(&bits, &x, sizeof bits);
  int exponent = (int)(bits >> 52) - 1023;
  bits = (bits & 0xfffffffffffffULL) | 0x3ff0000000000000ULL;
  memcpy(&x, &bits, sizeof bits);
  if (x > 1.41421356237309504880) {
    x *= 0.5;
    exponent++;
  }
  double f = x - 1.0;
  double s = f / (2.0 + f);
  double z = s * s;
  double r = z * (6.666666666666735130e-01 +
                  z * (3.999999999940941908e-01 +
                       z * (2.857142874366239149e-01 +
                            z * (2.222219843214978396e-01 +
                                 z * (1.818357216161805012e-01 +
                                      z * (1.531383769920937332e-01 +
                                           z * 1.479819860511658591e-01))))));
  double half = 0.5 * f * f;
  double k = (double)exponent;
  return k * 6.93147180369123816490e-01 -
         ((half - (s * (half + r) + k * 1.90821492927058770002e-10)) - f);
}

/* For |x| < 700. */
static inline double m_exp(double x) {
  double n = m_floor(x * 1.4426950408889634073599 + 0.5);
  x = (x - n * 6.93145751953125e-1) - n * 1.42860682030941723212e-6;
  double z = x * x;
  double p = x * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z +
                  9.99999999999999999910e-1);
  double q = ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z +
              2.27265548208155028766e-1) *
                 z +
             2.00000000000000000005e0;
  unsigned long long bits = (unsigned long long)((long long)n + 1023) << 52;
  double scale;
  memcpy(&scale, &bits, sizeof scale);
  return (1.0 + 2.0 * p / (q - p)) * scale;
}

#endif
