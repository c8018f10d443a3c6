/* A bare C host: gyros driven at a fixed rate straight through the core, without FMI.
   host SETTINGS RATES STEP OUT: SETTINGS has lines "gyro offset value", the offsets of rate and
   angle first; RATES and OUT are doubles. Prints ns a tick. */
#include "core.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { GYROS = 3 };
static Core gyros[GYROS];

int main(int count, char **arguments) {
  if (count != 5) return 2;
  FILE *settings = fopen(arguments[1], "r"), *rates = fopen(arguments[2], "rb");
  FILE *out = fopen(arguments[4], "wb");
  int rate, angle, gyro, offset;
  double value, step = atof(arguments[3]);
  if (!settings || !rates || !out || fscanf(settings, "%d %d", &rate, &angle) != 2) return 2;
  for (int i = 0; i < GYROS; i++) core_reset(&gyros[i]);
  while (fscanf(settings, "%d %d %lf", &gyro, &offset, &value) == 3) gyros[gyro].v[offset] = value;
  fseek(rates, 0, SEEK_END);
  size_t steps = (size_t)ftell(rates) / sizeof(double);
  rewind(rates);
  double *in = malloc(steps * sizeof *in), *angles = malloc(steps * sizeof *angles);
  if (!in || !angles || fread(in, sizeof *in, steps, rates) != steps) return 2;
  double elapsed = 0.0;
  for (int i = 0; i < GYROS; i++) {
    core_settle(&gyros[i]);
    core_initialize(&gyros[i], 0.0);
    struct timespec from, to;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
    for (size_t n = 0; n < steps; n++) {
      gyros[i].v[rate] = in[n];
      core_touch(&gyros[i]);
      core_advance(&gyros[i], (double)n * step + step);
      angles[n] = gyros[i].v[angle];
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
    elapsed += (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
    fwrite(angles, sizeof *angles, steps, out);
  }
  fclose(out);
  printf("%.17g\n", elapsed / (double)(gyros[0].ticks - 1) / GYROS);
  return 0;
}
