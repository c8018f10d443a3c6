#include "inputs.h"

#include "limits.h"
#include "number.h"

static int is_input(unsigned reference) {
  for (int i = 0; i < MODEL_INPUTS; i++)
    if (model_inputs[i] == reference) return 1;
  return 0;
}

int inputs_set_slopes(Instance *instance, const unsigned *references, size_t n, const int *orders,
                      const double *slopes) {
  if (!instance_may(instance, SETTABLE, "setting derivatives of inputs")) return 0;
  if (n && !(references && orders && slopes))
    return instance_refuse(instance, "a null pointer for %lu derivatives", (unsigned long)n);
  for (size_t i = 0; i < n; i++) {
    if (!is_input(references[i]))
      return instance_refuse(instance, "no real input has the value reference %u", references[i]);
    if (orders[i] != 1 || !isfinite(slopes[i]))
      return instance_refuse(instance, "the derivative of order %d of %s is %s, expected order 1",
                             orders[i], limits[references[i]].name, NUMBER(slopes[i]));
  }
  for (size_t i = 0; i < n; i++) core_slope(&instance->now.core, references[i], slopes[i]);
  instance_touch(instance);
  return 1;
}

static int is_within(Instance *instance, unsigned reference, double value) {
  const Limits *limit = &limits[reference];
  return limits_hold(limit, value) ||
         instance_refuse(instance, "the step leads to %s = %s, which is outside its range%s",
                         limit->name, NUMBER(value), RANGE(limit->minimum, limit->maximum));
}

static double value_after(const Core *core, int i, double step) {
  return core->v[model_inputs[i]] + step * core->slopes[i];
}

int inputs_begin(Instance *instance, double step) {
  Situation *now = &instance->now;
  double rate = 0.0, turn = 0.0;
  for (int i = 0; i < MODEL_INPUTS; i++) {
    double value = value_after(&now->core, i, step);
    if (now->core.is_sloping && !is_within(instance, model_inputs[i], value)) return 0;
    if (model_inputs[i] == MODEL_RATE) rate = value;
    if (model_inputs[i] == MODEL_ANGLE) turn = value - now->angle;
  }
  now->turn_rate = turn / step;
  return turn == 0.0 || is_within(instance, MODEL_RATE, rate + now->turn_rate);
}

void inputs_advance(Instance *instance, double time) {
  Situation *now = &instance->now;
  double *rate = &now->core.v[MODEL_RATE], set = *rate;
  if (now->turn_rate == 0.0) {
    core_advance(&now->core, time);
    return;
  }
  *rate += now->turn_rate;
  core_touch(&now->core);
  core_advance(&now->core, time);
  *rate = now->core.is_sloping ? *rate - now->turn_rate : set;
  core_touch(&now->core);
}

void inputs_end(Instance *instance, double duration, int is_whole) {
  Situation *now = &instance->now;
  now->angle = is_whole ? inputs_angle(&now->core) : now->angle + now->turn_rate * duration;
  now->turn_rate = 0.0;
  core_hold(&now->core);
}
