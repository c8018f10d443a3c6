/* The generated kernel in a plain loop, nothing else; prints ns a tick.
   bare TICKS [OFFSET VALUE ...]: variables to set before the first tick. */
#include "core.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

int main(int count, char **arguments) {
  static Core core;
  long ticks = count > 1 ? atol(arguments[1]) : 1000000;
  core_reset(&core);
  for (int i = 2; i + 1 < count; i += 2) core.v[atoi(arguments[i])] = atof(arguments[i + 1]);
  core_settle(&core);
  core_initialize(&core, 0.0);
  struct timespec from, to;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
  for (long i = 0; i < ticks; i++) {
    model_step(core.v, MODEL_PERIOD(core.v));
    model_tick(core.v, i + 1);
  }
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
  double elapsed = (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
  printf("%.17g\n", elapsed / (double)ticks);
  return 0;
}
