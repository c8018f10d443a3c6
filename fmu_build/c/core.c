#include "core.h"

#include <string.h>

/* A communication point this close to a tick is the tick: a millionth of the period, and what a
   double may lose of a time that was added up. In periods. */
static double same_instant(double time, double period) {
  return 1e-6 + 1e-15 * fabs(time) / period;
}

void core_reset(Core *core) {
  memset(core, 0, sizeof *core);
  model_defaults(core->v);
  core_settle(core);
}

void core_settle(Core *core) {
  model_parameters(core->v);
  model_start(core->v);
  core_touch(core);
}

void core_retune(Core *core) {
  model_parameters(core->v);
  core_touch(core);
}

void core_touch(Core *core) { core->held_fresh = core->outputs_fresh = 0; }

static void refresh_held(Core *core) {
  if (!core->held_fresh) model_held(core->v);
  core->held_fresh = 1;
}

void core_slope(Core *core, unsigned input, double slope) {
  for (int i = 0; i < MODEL_INPUTS; i++)
    if (model_inputs[i] == input) core->slopes[i] = slope;
  core->is_sloping = 1;
}

void core_hold(Core *core) {
  if (core->is_sloping) memset(core->slopes, 0, sizeof core->slopes);
  core->is_sloping = 0;
}

static void move_inputs(Core *core, double h) {
  if (!core->is_sloping) return;
  for (int i = 0; i < MODEL_INPUTS; i++) core->v[model_inputs[i]] += h * core->slopes[i];
  model_held(core->v);
}

/* Inputs that change count by their mean, so that a rate's integral is exact. */
static void integrate(Core *core, double h) {
  move_inputs(core, 0.5 * h);
  model_step(core->v, h);
  move_inputs(core, 0.5 * h);
}

void core_initialize(Core *core, double start) {
  core->start = start;
  core->offset = 0.0;
  core->ticks = 1;
  refresh_held(core);
  model_tick(core->v, 0);
  core->outputs_fresh = 0;
}

void core_advance(Core *core, double time) {
  refresh_held(core);
  /* Ticks are counted, never accumulated, so that no rounding builds up over hours. */
  const double period = FIRST(MODEL_PERIOD(core->v));
  const double slack = same_instant(time, period);
  double target = (time - core->start) / period;
  while ((double)core->ticks <= target + slack) {
    integrate(core, period - core->offset);
    model_tick(core->v, core->ticks);
    core->offset = 0.0;
    core->ticks++;
  }
  double rest = (target - (double)(core->ticks - 1)) * period;
  if (rest - core->offset > slack * period) {
    integrate(core, rest - core->offset);
    core->offset = rest;
  }
  core->outputs_fresh = 0;
}

void core_refresh(Core *core) {
  if (!core->outputs_fresh) model_outputs(core->v);
  core->outputs_fresh = core->held_fresh = 1;
}

double core_next_tick(const Core *core) {
  return core->start + (double)core->ticks * FIRST(MODEL_PERIOD(core->v));
}

int core_ticks_before(const Core *core, double time) {
  const double period = FIRST(MODEL_PERIOD(core->v));
  return (time - core->start) / period > (double)core->ticks + same_instant(time, period);
}

double core_now(const Core *core) {
  const double period = FIRST(MODEL_PERIOD(core->v));
  return core->start + (double)(core->ticks - 1) * period + core->offset;
}

int core_is_at(const Core *core, double time) {
  const double period = FIRST(MODEL_PERIOD(core->v));
  return core->ticks >= 1 && core->offset >= 0.0 && core->offset < period &&
         fabs(core_now(core) - time) <= 1e-6 * (1.0 + fabs(time));
}

double core_drift(const Core *core, double time) {
  double drift = time - core_now(core);
  return fabs(drift) > 5e-7 * FIRST(MODEL_PERIOD(core->v)) ? drift : 0.0;
}
