/* The generated kernel in a plain loop: what any driver is measured against. */
#include "core.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int count, char **arguments) {
  static Core core;
  long ticks = count > 1 ? atol(arguments[1]) : 1000000;
  core_reset(&core);
  core_initialize(&core, 0.0);
  double begin = now();
  for (long i = 0; i < ticks; i++) {
    model_step(core.v, MODEL_PERIOD(core.v));
    model_tick(core.v, i + 1);
  }
  printf("%.17g\n", (now() - begin) / (double)ticks);
  return 0;
}
