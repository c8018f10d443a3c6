#include "instance.h"

#include "limits.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int instance_refuse(Instance *instance, const char *format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (instance->report) instance->report(instance->context, instance->name, text);
  return 0;
}

Instance *instance_create(const char *name, const char *token, Report report, void *context) {
  Instance *instance = calloc(1, sizeof *instance);
  if (!instance) return NULL;
  instance->report = report;
  instance->context = context;
  snprintf(instance->name, sizeof instance->name, "%s", name ? name : "");
  if (!token || strcmp(token, model_token) != 0) {
    instance_refuse(instance, "the token %s is not that of this model, %s", token ? token : "(none)",
                    model_token);
    free(instance);
    return NULL;
  }
  instance_reset(instance);
  return instance;
}

void instance_reset(Instance *instance) {
  memset(&instance->now, 0, sizeof instance->now);
  core_reset(&instance->now.core);
}

int instance_setup(Instance *instance, double start, int stop_defined, double stop) {
  Situation *now = &instance->now;
  if (now->phase != INSTANTIATED)
    return instance_refuse(instance, "the experiment is set up before initialization, not after");
  if (!(start > -1e9 && start < 1e9))
    return instance_refuse(instance, "the start time %g is outside its range from -1e9 to 1e9", start);
  if (stop_defined && !(stop >= start))
    return instance_refuse(instance, "the stop time %g lies before the start time %g", stop, start);
  now->start = now->time = start;
  now->stop = stop;
  now->stop_defined = stop_defined;
  return 1;
}

int instance_enter_initialization(Instance *instance) {
  if (instance->now.phase != INSTANTIATED)
    return instance_refuse(instance, "initialization is entered once, after instantiation or reset");
  instance->now.phase = INITIALIZING;
  return 1;
}

int instance_exit_initialization(Instance *instance) {
  if (instance->now.phase != INITIALIZING)
    return instance_refuse(instance, "initialization is not under way");
  core_initialize(&instance->now.core, instance->now.start);
  instance->now.time = instance->now.start;
  instance->now.phase = STEPPING;
  return 1;
}

static int is_known(Instance *instance, unsigned reference, int integer) {
  if (reference < MODEL_VARIABLES && limits[reference].integer == integer) return 1;
  return instance_refuse(instance, "no %s variable has the value reference %u",
                         integer ? "integer" : "real", reference);
}

int instance_get(Instance *instance, unsigned reference, int integer, double *value) {
  if (reference == MODEL_VARIABLES && !integer) { /* the independent variable */
    *value = instance->now.time;
    return 1;
  }
  if (!is_known(instance, reference, integer)) return 0;
  if (limits[reference].continuous) core_refresh(&instance->now.core);
  *value = instance->now.core.v[reference];
  return 1;
}

int instance_set(Instance *instance, unsigned reference, int integer, double value) {
  if (!is_known(instance, reference, integer)) return 0;
  const Limits *limit = &limits[reference];
  if (limit->settable == SET_NEVER)
    return instance_refuse(instance, "%s can't be set at all", limit->name);
  if (limit->settable == SET_PARAMETER && instance->now.phase >= STEPPING)
    return instance_refuse(instance, "%s can't be set after initialization", limit->name);
  if (!(value >= limit->minimum && value <= limit->maximum)) /* catches NaN */
    return instance_refuse(instance, "%s = %.17g is outside its range from %g to %g", limit->name,
                           value, limit->minimum, limit->maximum);
  instance->now.core.v[reference] = value;
  core_touch(&instance->now.core);
  return 1;
}

void instance_settle(Instance *instance) {
  if (instance->now.phase < STEPPING) core_settle(&instance->now.core);
}

int instance_step(Instance *instance, double time, double step) {
  Situation *now = &instance->now;
  if (now->phase != STEPPING) return instance_refuse(instance, "a step is legal only after initialization");
  if (!(step > 0.0 && step < 1e9))
    return instance_refuse(instance, "the step %g is outside its range from 0 to 1e9", step);
  double slack = 1e-9 * (1.0 + fabs(now->time));
  if (!(fabs(time - now->time) <= slack))
    return instance_refuse(instance, "the step begins at %.17g, expected %.17g", time, now->time);
  if (now->stop_defined && time + step > now->stop + slack)
    return instance_refuse(instance, "the step ends at %.17g, beyond the stop time %.17g", time + step,
                           now->stop);
  core_advance(&now->core, time + step);
  now->time = time + step;
  if (!model_is_finite(now->core.v))
    return instance_refuse(instance, "the state is no longer finite at %.17g", now->time);
  return 1;
}

Snapshot *instance_save(Instance *instance, Snapshot *into) {
  if (!into) into = calloc(1, sizeof *into);
  if (!into) {
    instance_refuse(instance, "out of memory");
    return NULL;
  }
  memset(into, 0, sizeof *into);
  snprintf(into->model, sizeof into->model, "%s", model_token);
  into->situation = instance->now;
  return into;
}

int instance_restore(Instance *instance, const Snapshot *snapshot) {
  if (!snapshot || strncmp(snapshot->model, model_token, sizeof snapshot->model) != 0)
    return instance_refuse(instance, "the saved state is not one of this model");
  instance->now = snapshot->situation;
  return 1;
}
