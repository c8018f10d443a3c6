#include "instance.h"

#include "inputs.h"
#include "limits.h"
#include "number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const phase_names[] = {"before initialization", "during initialization",
                                          "between steps",         "within a step",
                                          "after a failed step",   "after termination"};

static const char *const kind_names[KINDS] = {"real", "integer", "Boolean"};

int instance_may(Instance *instance, unsigned phases, const char *call) {
  if (!instance) return 0;
  if (phases & IN(instance->now.phase)) return 1;
  return instance_refuse(instance, "%s is not legal %s", call, phase_names[instance->now.phase]);
}

static void start_over(Instance *instance) {
  memset(&instance->now, 0, sizeof instance->now);
  core_reset(&instance->now.core);
  instance_touch(instance);
}

void *instance_create(size_t size, const char *name, const char *token, unsigned references,
                      const Listener *listener, int logging) {
  Instance *instance = calloc(1, size);
  if (!instance) return NULL;
  instance->listener = *listener;
  instance->references = references;
  instance->logged[LOG_ERROR] = instance->logged[LOG_DISCARD] = 1;
  instance->logged[LOG_EVENT] = logging;
  snprintf(instance->name, sizeof instance->name, "%s", name ? name : "");
  if (!token || strcmp(token, model_token) != 0) {
    instance_refuse(instance, "the token %.100s is not that of this model, %s",
                    token ? token : "(null)", model_token);
    free(instance);
    return NULL;
  }
  start_over(instance);
  return instance;
}

int instance_reset(Instance *instance) {
  if (!instance_may(instance, OUTSIDE_A_STEP, "a reset")) return 0;
  start_over(instance);
  instance_note(instance, "reset");
  return 1;
}

int instance_setup(Instance *instance, double start, int stop_defined, double stop) {
  if (!instance_may(instance, IN(INSTANTIATED), "setting up the experiment")) return 0;
  if (!(start >= EARLIEST_TIME && start <= LATEST_START))
    return instance_refuse(instance, "the start time %s is outside its range%s", NUMBER(start),
                           RANGE(EARLIEST_TIME, LATEST_START));
  if (stop_defined && !(stop >= start))
    return instance_refuse(instance, "the stop time %s lies before the start time %s", NUMBER(stop),
                           NUMBER(start));
  Situation *now = &instance->now;
  now->start = now->time = start;
  now->stop = stop_defined ? stop : 0.0;
  now->stop_defined = stop_defined != 0;
  return 1;
}

int instance_enter_initialization(Instance *instance) {
  if (!instance_may(instance, IN(INSTANTIATED), "entering initialization")) return 0;
  instance->now.phase = INITIALIZING;
  return 1;
}

/* The step or initialization that made it so is lost; the instance can be reset or restored. */
static int fail(Instance *instance, const char *variable) {
  instance->now.phase = FAILED;
  return instance_refuse(instance, "%s is no longer finite at %s s", variable,
                         NUMBER(instance->now.time));
}

static const char *first_not_finite(Core *core) {
  core_refresh(core);
  for (int i = 0; i < MODEL_VARIABLES; i++)
    if (!isfinite(core->v[i])) return limits[i].name;
  return NULL;
}

int instance_exit_initialization(Instance *instance) {
  if (!instance_may(instance, IN(INITIALIZING), "leaving initialization")) return 0;
  core_initialize(&instance->now.core, instance->now.start);
  const char *bad = first_not_finite(&instance->now.core);
  if (bad) return fail(instance, bad);
  instance->now.angle = inputs_angle(&instance->now.core);
  instance->now.phase = STEPPING;
  instance_note(instance, "initialized");
  return 1;
}

void instance_touch(Instance *instance) { instance->first_fresh = 0; }

/* What is read: during initialization, what the start time will have. */
static Core *readable(Instance *instance) {
  Situation *now = &instance->now;
  if (now->phase != INITIALIZING) return &now->core;
  if (!instance->first_fresh) {
    instance->first = now->core;
    core_initialize(&instance->first, now->start);
    instance->first_fresh = 1;
  }
  return &instance->first;
}

int instance_terminate(Instance *instance) {
  if (!instance_may(instance, IN(STEPPING) | IN(FAILED), "termination")) return 0;
  instance->now.phase = TERMINATED;
  instance_note(instance, "terminated");
  return 1;
}

int instance_knows(unsigned reference, Kind kind) {
  return reference < MODEL_VARIABLES && limits[reference].count && limits[reference].kind == kind;
}

unsigned instance_count(unsigned reference) {
  return reference < MODEL_VARIABLES && limits[reference].count ? (unsigned)limits[reference].count : 1;
}

static int is_known(Instance *instance, unsigned reference, Kind kind) {
  if (instance_knows(reference, kind)) return 1;
  return instance_refuse(instance, "no %s variable has the value reference %u", kind_names[kind],
                         reference);
}

static int are_given(Instance *instance, const void *references, size_t n, const void *values) {
  return !n || (references && values) ||
         instance_refuse(instance, "a null pointer for %lu variables", (unsigned long)n);
}

/* The reference after the model's own is that of the independent variable, where there is one. */
static int is_time(const Instance *instance, unsigned reference, Kind kind) {
  return reference == MODEL_VARIABLES && reference < instance->references && kind == REAL;
}

static int can_get(Instance *instance, unsigned reference, Kind kind) {
  if (is_time(instance, reference, kind)) return 1;
  if (!is_known(instance, reference, kind)) return 0;
  Core *core = readable(instance);
  if (limits[reference].continuous) core_refresh(core);
  return isfinite(core->v[reference]) ||
         instance_refuse(instance, "%s is not finite at %s s", limits[reference].name,
                         NUMBER(instance->now.time));
}

static void put(void *values, size_t i, Kind kind, double value) {
  if (kind == INTEGER)
    ((int *)values)[i] = (int)value;
  else if (kind == BOOLEAN)
    ((_Bool *)values)[i] = value > 0.5;
  else
    ((double *)values)[i] = value;
}

static double given(const void *values, size_t i, Kind kind) {
  if (kind == INTEGER) return ((const int *)values)[i];
  return kind == BOOLEAN ? ((const _Bool *)values)[i] : ((const double *)values)[i];
}

int instance_get(Instance *instance, const unsigned *references, size_t n, Kind kind, void *values) {
  if (!instance_may(instance, READABLE, "reading") || !are_given(instance, references, n, values))
    return 0;
  for (size_t i = 0; i < n; i++)
    if (!can_get(instance, references[i], kind)) return 0;
  const double *v = readable(instance)->v;
  for (size_t i = 0, k = 0; i < n; i++)
    for (unsigned e = 0; e < instance_count(references[i]); e++)
      put(values, k++, kind,
          is_time(instance, references[i], kind) ? instance->now.time : v[references[i] + e]);
  return 1;
}

static int may_set(Instance *instance, unsigned reference, Kind kind) {
  if (!is_known(instance, reference, kind)) return 0;
  const Limits *limit = &limits[reference];
  if (limit->settable == SET_NEVER)
    return instance_refuse(instance, "%s can't be set at all", limit->name);
  if (limit->settable == SET_PARAMETER && !(IN(instance->now.phase) & BEFORE_STEPS))
    return instance_refuse(instance, "%s can't be set after initialization", limit->name);
  if (limit->settable == SET_TUNABLE && instance->now.phase == UPDATING)
    return instance_refuse(instance, "%s can't be set within a step", limit->name);
  if (reference == MODEL_ANGLE && instance->now.phase == UPDATING)
    return instance_refuse(instance, "%s is that of the step's end, and can't be set within it",
                           limit->name);
  return 1;
}

static Answer can_take(Instance *instance, const Limits *limit, double value) {
  if (limits_hold(limit, value)) return DONE;
  return instance_discard(instance, "%s = %s is outside its range%s", limit->name, NUMBER(value),
                          RANGE(limit->minimum, limit->maximum));
}

/* Its values from number k on, which is then that of the next variable's. */
static Answer can_set(Instance *instance, unsigned reference, Kind kind, const void *values,
                      size_t *k) {
  if (!may_set(instance, reference, kind)) return REFUSED;
  for (unsigned e = 0; e < instance_count(reference); e++)
    if (can_take(instance, &limits[reference + e], given(values, (*k)++, kind)) != DONE)
      return DISCARDED;
  return DONE;
}

static void write_values(double *v, unsigned reference, Kind kind, const void *values, size_t *k) {
  for (unsigned r = reference; r < reference + instance_count(reference); r++)
    v[r] = limits_nearest(&limits[r], given(values, (*k)++, kind));
}

Answer instance_set(Instance *instance, const unsigned *references, size_t n, Kind kind,
                    const void *values) {
  if (!instance_may(instance, SETTABLE, "setting variables") ||
      !are_given(instance, references, n, values))
    return REFUSED;
  for (size_t i = 0, k = 0; i < n; i++) {
    Answer answer = can_set(instance, references[i], kind, values, &k);
    if (answer != DONE) return answer;
  }
  Core *core = &instance->now.core;
  int is_retuned = 0;
  for (size_t i = 0, k = 0; i < n; i++) {
    write_values(core->v, references[i], kind, values, &k);
    is_retuned |= limits[references[i]].settable == SET_TUNABLE;
  }
  core_touch(core);
  if (IN(instance->now.phase) & BEFORE_STEPS)
    core_settle(core);
  else if (is_retuned)
    core_retune(core);
  instance_touch(instance);
  return DONE;
}

static int is_step(Instance *instance, double time, double step) {
  const Situation *now = &instance->now;
  double slack = 1e-9 * (1.0 + fabs(now->time));
  if (!(step > 0.0 && fmax(time, now->time) + step <= LATEST_TIME))
    return instance_refuse(instance, "the step %s is outside its range: above 0, up to %s",
                           NUMBER(step), NUMBER(LATEST_TIME - now->time));
  if (!(fabs(time - now->time) <= slack))
    return instance_refuse(instance, "the step begins at %s, expected %s", NUMBER(time),
                           NUMBER(now->time));
  if (now->stop_defined && time + step > now->stop + slack)
    return instance_refuse(instance, "the step ends at %s, beyond the stop time %s",
                           NUMBER(time + step), NUMBER(now->stop));
  return 1;
}

/* Tick by tick, with the importer's word on each that lies within the step. */
static double told_advance(Instance *instance, double end, double drift, Between between) {
  Situation *now = &instance->now;
  now->phase = UPDATING;
  while (core_ticks_before(&now->core, end - drift)) {
    const double tick = core_next_tick(&now->core);
    now->time = tick + drift;
    inputs_advance(instance, tick);
    between(instance, &end);
  }
  now->phase = STEPPING;
  return end;
}

int instance_step(Instance *instance, double time, double step, Between between) {
  if (!instance_may(instance, IN(STEPPING), "a step") || !is_step(instance, time, step) ||
      !inputs_begin(instance, step))
    return 0;
  Situation *now = &instance->now;
  /* a begin that is early within the slack does not turn time back */
  const double begin = now->time, whole = fmax(time + step, begin);
  const double drift = core_drift(&now->core, begin);
  double end = between ? told_advance(instance, whole, drift, between) : whole;
  inputs_advance(instance, end - drift);
  inputs_end(instance, end - begin, end == whole);
  now->time = end;
  if (model_is_finite(now->core.v)) return 1;
  const char *bad = first_not_finite(&now->core);
  return fail(instance, bad ? bad : "a state");
}
