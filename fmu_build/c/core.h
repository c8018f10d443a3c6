/* A model in time: continuous states between the ticks of one sample clock. */
#ifndef CORE_H
#define CORE_H

#include "model.h"

typedef struct {
  real v[MODEL_VARIABLES];
  real slopes[MODEL_INPUTS + 1]; /* of model_inputs: change per second */
  int is_sloping;                /* whether there is any slope */
  double start;      /* time of the first tick */
  double offset;     /* time since the last tick */
  long long ticks;   /* ticks executed */
  int held_fresh;    /* what depends on inputs alone belongs to the present ones */
  int outputs_fresh; /* continuous outputs belong to the present state */
} Core;

/* Defaults, before any parameter is set. */
void core_reset(Core *core);
/* What depends on parameters, before the first tick. */
void core_settle(Core *core);
/* What depends on parameters, after one was set that is tunable. */
void core_retune(Core *core);
/* To be called after an input was set. */
void core_touch(Core *core);
/* From here on an input of model_inputs changes evenly, at a slope. */
void core_slope(Core *core, unsigned input, double slope);
/* From here on inputs hold. */
void core_hold(Core *core);
/* Execute the tick at the start time. */
void core_initialize(Core *core, double start);
/* Integrate to a time; a tick that falls on it is executed. */
void core_advance(Core *core, double time);
/* Bring continuous outputs up to date. */
void core_refresh(Core *core);
/* Time of the next tick, and whether it lies before a time, not on it. */
double core_next_tick(const Core *core);
int core_ticks_before(const Core *core, double time);
/* Time that the core has reached. */
double core_now(const Core *core);
/* What an importer's time is ahead of the core's, where it is more than rounding: by importers that
   add up their steps, 1e-6 s after 2 h at 1 ms. */
double core_drift(const Core *core, double time);
/* Whether ticks and offset are those of an importer's time after the first tick. */
int core_is_at(const Core *core, double time);

#endif
