#include "lanes.h"

#define LANES WIDTH /* before the model's own source, whose numbers are vectors then: real.h */
#include "model.c"

#include "core.c"

#include <stdint.h>
#include <stdlib.h>

struct Lanes {
  Core core;
  void *memory;
  unsigned long long partings; /* before the first step */
};

Lanes *lanes_create(void) {
  const uintptr_t alignment = _Alignof(Lanes);
  void *memory = calloc(1, sizeof(Lanes) + alignment);
  if (!memory) return NULL;
  Lanes *lanes = (Lanes *)(((uintptr_t)memory + alignment - 1) / alignment * alignment);
  lanes->memory = memory;
  return lanes;
}

void lanes_free(Lanes *lanes) { free(lanes->memory); }

double *lanes_values(Lanes *lanes, unsigned reference) {
  return (double *)&lanes->core.v[reference];
}

void lanes_begin(Lanes *lanes, double start, double offset, long long ticks) {
  lanes->core.start = start;
  lanes->core.offset = offset;
  lanes->core.ticks = ticks;
  lanes->partings = __atomic_load_n(&partings, __ATOMIC_RELAXED);
  core_touch(&lanes->core);
}

double lanes_offset(const Lanes *lanes) { return lanes->core.offset; }

long long lanes_ticks(const Lanes *lanes) { return lanes->core.ticks; }

void lanes_touch(Lanes *lanes) { core_touch(&lanes->core); }

static int are_together(const Lanes *lanes) {
  return lanes->partings == __atomic_load_n(&partings, __ATOMIC_RELAXED);
}

int lanes_refresh(Lanes *lanes) {
  core_refresh(&lanes->core);
  return are_together(lanes);
}

int lanes_advance(Lanes *lanes, double time) {
  core_advance(&lanes->core, time);
  return model_is_finite(lanes->core.v) && are_together(lanes);
}
