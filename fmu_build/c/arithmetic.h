/* Arithmetic that the generated equations call. The transcendental functions are our own, so that
   every platform computes the same bits; errors are below 2 units in the last place.
   Sources: S. L. Moshier, Cephes Math Library (sin, cos, atan, exp); Sun Microsystems, fdlibm (log). */
#ifndef ARITHMETIC_H
#define ARITHMETIC_H

#include "real.h"

#include <string.h>

#ifdef __GNUC__
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

/* Largest whole number not above x, for |x| < 2^51: adding 1.5 * 2^52 rounds to a whole number. */
static inline real m_floor(real x) {
  const double shift = 6755399441055744.0;
  real whole = (x + shift) - shift;
  return whole > x ? whole - 1.0 : whole;
}

static inline real m_square(real x) { return x * x; }

/* x less the nearest multiple of pi/2, which is returned modulo 4; for |x| < 1e8, beyond which the
   products with parts of pi/2 are no longer exact: no number then. */
static inline real quarter_turns(real x, real *rest) {
  real n = m_floor(x * 6.36619772367581343076e-1 + 0.5);
  real less = ((x - n * 1.57079625129699707031) - n * 7.54978941586159635335e-8) -
              n * 5.39030252995776476554e-15;
  *rest = m_abs(x) < 1e8 ? less : (real)NAN;
  return n - 4.0 * m_floor(0.25 * n);
}

/* For |x| <= pi/4. */
static inline real sine_kernel(real x) {
  real z = x * x;
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
static inline real cosine_kernel(real x) {
  real z = x * x;
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

/* Where the series' first term is the result to the last bit, it is returned at once: a mechanism that
   is off costs no series. */
static inline real m_sin(real x) {
  if (ALL(m_abs(x) < 1e-8)) return x + 0.0;
  if (ALL(m_abs(x) <= 0.78)) return sine_kernel(x);
  real rest, quarter = quarter_turns(x, &rest);
  truth odd = quarter == 1.0 || quarter == 3.0;
  real value = CHOOSE(odd, cosine_kernel(rest), sine_kernel(rest));
  return quarter >= 2.0 ? -value : value;
}

static inline real m_cos(real x) {
  if (ALL(m_abs(x) < 1e-8)) return 1.0;
  if (ALL(m_abs(x) <= 0.78)) return cosine_kernel(x);
  real rest, quarter = quarter_turns(x, &rest);
  truth odd = quarter == 1.0 || quarter == 3.0;
  real value = CHOOSE(odd, sine_kernel(rest), cosine_kernel(rest));
  return quarter == 1.0 || quarter == 2.0 ? -value : value;
}

/* For x >= 0. */
static inline real arc_tangent(real x) {
  real base = 0.0, low = 0.0;
  const truth above = x > 2.41421356237309504880, middle = x > 0.66;
  if (ANY(middle)) {
    base = above ? 1.57079632679489661923 : middle ? 7.85398163397448309616e-1 : base;
    low = above ? 6.123233995736765886130e-17 : middle ? 3.061616997868382943065e-17 : low;
    x = (above ? -1.0 : middle ? x - 1.0 : x) / (above ? x : middle ? x + 1.0 : 1.0);
  }
  real z = x * x;
  real p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z -
               7.500855792314704667340e1) *
                  z -
              1.228866684490136173410e2) *
                 z -
             6.485021904942025371773e1;
  real q = ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z +
               4.328810604912902668951e2) *
                  z +
              4.853903996359136964868e2) *
                 z +
             1.945506571482613964425e2;
  return base + ((x * (z * p / q) + x) + low);
}

static inline real m_atan2(real y, real x) {
  const double pi = 3.14159265358979323846;
  const truth nowhere = x == 0.0 && y == 0.0;
  if (ALL(nowhere)) return 0.0;
  real angle = arc_tangent(m_abs(y) / m_abs(x));
  angle = x < 0.0 ? pi - angle : angle;
  angle = y < 0.0 ? -angle : angle;
  return nowhere ? 0.0 : angle;
}

/* For normal x > 0. */
static inline real m_log(real x) {
  bits all;
  memcpy(&all, &x, sizeof all);
  real k = TO_REAL(all >> 52) - 1023.0;
  all = (all & 0xfffffffffffffULL) | 0x3ff0000000000000ULL;
  memcpy(&x, &all, sizeof x);
  const truth high = x > 1.41421356237309504880;
  x = high ? 0.5 * x : x;
  k = high ? k + 1.0 : k;
  real f = x - 1.0;
  real s = f / (2.0 + f);
  real z = s * s;
  real r = z * (6.666666666666735130e-01 +
                  z * (3.999999999940941908e-01 +
                       z * (2.857142874366239149e-01 +
                            z * (2.222219843214978396e-01 +
                                 z * (1.818357216161805012e-01 +
                                      z * (1.531383769920937332e-01 +
                                           z * 1.479819860511658591e-01))))));
  real half = 0.5 * f * f;
  return k * 6.93147180369123816490e-01 -
         ((half - (s * (half + r) + k * 1.90821492927058770002e-10)) - f);
}

/* Right for |x| < 700; 0 or infinite beyond, for |x| < 2^50. */
static inline real m_exp(real x) {
  if (ALL(m_abs(x) < 1e-17)) return 1.0;
  real n = m_floor(x * 1.4426950408889634073599 + 0.5);
  x = (x - n * 6.93145751953125e-1) - n * 1.42860682030941723212e-6;
  real z = x * x;
  real p = x * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z +
                  9.99999999999999999910e-1);
  real q = ((3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z +
              2.27265548208155028766e-1) *
                 z +
             2.00000000000000000005e0;
  real power = CHOOSE(n > -1023.0, n, -1023.0);
  bits all = TO_BITS(CHOOSE(power < 1024.0, power, 1024.0) + 1023.0) << 52;
  real scale;
  memcpy(&scale, &all, sizeof scale);
  return (1.0 + 2.0 * p / (q - p)) * scale;
}

#endif
