/* Classical Runge-Kutta step of fourth order; included where STATES and derivatives() are known. */
static inline void runge_kutta_4(const real *v, real *x, double h) {
  real k1[STATES], k2[STATES], k3[STATES], k4[STATES], y[STATES];
  derivatives(v, x, k1);
  for (int i = 0; i < STATES; i++) y[i] = x[i] + 0.5 * h * k1[i];
  derivatives(v, y, k2);
  for (int i = 0; i < STATES; i++) y[i] = x[i] + 0.5 * h * k2[i];
  derivatives(v, y, k3);
  for (int i = 0; i < STATES; i++) y[i] = x[i] + h * k3[i];
  derivatives(v, y, k4);
  for (int i = 0; i < STATES; i++) x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
}
