#include "lanes.h"

#define LANES WIDTH /* before the model's own source, whose numbers are vectors then: real.h */
#include "model.c"

#include "core.c"

static _Thread_local Core lanes;

double *lanes_values(unsigned reference) { return (double *)&lanes.v[reference]; }

void lanes_begin(double start, double offset, long long ticks) {
  lanes.start = start;
  lanes.offset = offset;
  lanes.ticks = ticks;
  lanes_part = 0;
  core_touch(&lanes);
}

double lanes_offset(void) { return lanes.offset; }

long long lanes_ticks(void) { return lanes.ticks; }

void lanes_touch(void) { core_touch(&lanes); }

void lanes_refresh(void) { core_refresh(&lanes); }

int lanes_advance(double time) {
  core_advance(&lanes, time);
  return model_is_finite(lanes.v) && !lanes_part;
}
