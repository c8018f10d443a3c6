/* Explicit midpoint step, second order; included where STATES, derivatives() and, for the states of v,
   first_derivatives() are known. */
static inline void midpoint(const real *v, real *x, double h) {
  real k[STATES], y[STATES];
  first_derivatives(v, x, k);
  for (int i = 0; i < STATES; i++) y[i] = x[i] + 0.5 * h * k[i];
  derivatives(v, y, k);
  for (int i = 0; i < STATES; i++) x[i] += h * k[i];
}
