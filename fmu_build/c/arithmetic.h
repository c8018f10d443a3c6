/* Arithmetic that the generated equations call. */
#ifndef ARITHMETIC_H
#define ARITHMETIC_H

/* Largest whole number not above x, for |x| < 2^63. */
static inline double m_floor(double x) {
  double whole = (double)(long long)x;
  return whole > x ? whole - 1.0 : whole;
}

static inline double m_square(double x) { return x * x; }

#endif
