/* Random calls that initialize, step, read, set, differentiate and log. */
#ifndef FUZZ_CALLS_H
#define FUZZ_CALLS_H

#include "fuzz_oracle.h"

static void try_initialize(void) {
  double start = chance(3) ? 0.0 : chance(8) ? wild() : between(-2e6, 2e6);
  if (chance(2)) start = (double)below(100);
  int stop_defined = chance(4);
  double stop = start + (chance(4) ? -1.0 : 1e5);
  int legal = known.phase == FRESH && start >= -1e6 && start <= 1e6 && !(stop_defined && stop < start);
  if (JUDGE("initialization", legal, door_initialize(handle, start, stop_defined, stop))) {
    known.phase = INITIALIZING;
    known.time = start;
  }
}

/* What is read during initialization is what the start time has. */
static void try_exit(void) {
  static double during[MODEL_VARIABLES], at_start[MODEL_VARIABLES];
  int legal = known.phase == INITIALIZING, compared = legal && chance(2);
  if (compared) all_values(during);
  prepare(legal);
  if (!may_fail("end of initialization", legal, door_exit(handle))) return;
  known.phase = RUNNING;
  known.on_tick = 1;
  known.angle = input(MODEL_ANGLE);
  if (!compared) return;
  all_values(at_start);
  same_values(during, at_start, "during initialization", "at its end");
}

static void try_step(void) {
  static const double odd_steps[] = {0.0, -1e-3, NAN, INFINITY, 1e9};
  double period = tick(), time = known.time, step = period * (1 + below(5));
  int legal = known.phase == RUNNING, exact = !chance(10);
  if (!exact) time += between(-0.9e-9, 0.9e-9) * (1.0 + fabs(time));
  if (chance(20)) {
    step = odd_steps[below(5)];
    legal = 0;
  } else if (chance(20)) {
    time += chance(2) ? 0.5 : INFINITY;
    legal = 0;
  } else if (chance(30)) {
    step *= between(0.1, 1.0) * (chance(5) ? 1e-9 : 1.0);
  }
  legal = legal && can_turn(step);
  prepare(legal);
  if (may_fail("a step", legal, door_step(handle, time, step))) {
    known.angle = input(MODEL_ANGLE);
    known.time = fmax(time + step, known.time);
    known.on_tick &= exact && step > 0.9 * period && fabs(step / period - round(step / period)) < 1e-9;
  }
}

/* What can't be read during initialization is what its end fails by; and what is computed from
   states that grow beyond all bounds overflows before they do, by a step. */
static void must_fail(void) {
  double period = tick();
  if (known.phase == RUNNING && !can_turn(period)) return;
  prepare(1);
  if (may_fail("what follows", 1, known.phase == INITIALIZING ? door_exit(handle)
                                                              : door_step(handle, known.time, period)))
    finding("a state that could not be read was taken");
}

static void try_get(void) {
  Reference references[4];
  double values[4 * MOST + 1];
  Kind kind = some_kind();
  int n = below(5), legal = is_open();
  size_t count = 0;
  for (int i = 0; i < n; i++) {
    references[i] = chance(30) ? (Reference)draw() % (MODEL_VARIABLES + 2000) : pick(kind, 0);
    int is_time = FMI == 3 && kind == REAL && references[i] == MODEL_VARIABLES;
    legal &= is_time || is_variable(references[i], kind);
    count += (size_t)count_of(references[i]);
  }
  size_t told = miscounted(count);
  legal &= told == count;
  if (known.phase == FAILED) return; /* each value may or may not be finite */
  int null = n && chance(30);
  size_t bytes = known.phase == FRESH ? 0 : state_of(before);
  prepare(legal && !null);
  int success =
      door_get_all(handle, n ? references : NULL, (size_t)n, (int)kind, null || !n ? NULL : values, told);
  if (legal && !null && is_excused(success, "is not finite at")) {
    if (known.phase == RUNNING || known.phase == INITIALIZING) must_fail();
    return;
  }
  judged("reading", legal && !null, success);
  if (success && (state_of(after) != bytes || memcmp(before, after, bytes) != 0))
    finding("reading changed the state");
  for (size_t k = 0; success && kind == REAL && k < count; k++)
    if (!isfinite(values[k])) finding("value %lu of %s ... was read as %g", (unsigned long)k,
                                      limits[references[0] % MODEL_VARIABLES].name, values[k]);
}

static double sensible(const Limits *limit) {
  double low = fmax(limit->minimum, -1.0), high = fmin(limit->maximum, 1.0);
  if (limit->minimum > 0.0) low = limit->minimum, high = fmin(limit->maximum, 10.0 * low);
  if (chance(5)) low = limit->minimum, high = limit->maximum;
  if (chance(10)) return chance(2) ? limit->minimum : limit->maximum;
  return between(low, high) * (chance(3) ? 1.0 : 1e-3) * (limit->minimum > 0.0 ? 0.0 : 1.0) +
         (limit->minimum > 0.0 ? between(low, high) : 0.0);
}

static int may_set(Reference r, double value) {
  const Limits *limit = &limits[r];
  return limit->settable != SET_NEVER && !(limit->settable == SET_PARAMETER && known.phase == RUNNING) &&
         limits_hold(limit, value);
}

static void try_set(void) {
  Reference references[3];
  double reals[3 * MOST];
  int integers[3 * MOST];
  _Bool flags[3 * MOST];
  const void *of_kind[KINDS] = {reals, integers, flags};
  Kind kind = some_kind();
  int n = below(4);
  int legal = known.phase == FRESH || known.phase == INITIALIZING || known.phase == RUNNING;
  size_t k = 0;
  for (int i = 0; i < n; i++) {
    Reference r = references[i] = chance(30) ? (Reference)below(MODEL_VARIABLES + 9) : pick(kind, 1);
    while (known.phase == RUNNING && kind == REAL && !chance(20) && r < MODEL_VARIABLES &&
           limits[r].settable == SET_PARAMETER)
      r = references[i] = pick(REAL, 1);
    legal &= is_variable(r, kind);
    for (Reference e = r; e < r + (Reference)count_of(r); e++, k++) {
      reals[k] = chance(20) || r >= MODEL_VARIABLES ? wild() : sensible(&limits[e]);
      integers[k] = chance(20) ? -(int)(draw() >> 34) : (int)(draw() >> 34);
      flags[k] = chance(2);
      legal = legal && may_set(e, kind == REAL ? reals[k] : kind == INTEGER ? integers[k] : flags[k]);
    }
  }
  int null = n && chance(30);
  size_t told = miscounted(k);
  const Reference *given = n && !(null && chance(2)) ? references : NULL;
  JUDGE("setting", legal && !null && told == k,
        door_set_all(handle, given, (size_t)n, (int)kind, null || !n ? NULL : of_kind[kind], told));
}

static void try_derivative(void) {
  Reference unknowns[3], knowns[2];
  double seed[2 * MOST + 1], result[3];
  int nu = below(4), nk = below(3), legal = is_open();
  size_t count = 0;
  for (int k = 0; k < 2 * MOST + 1; k++) seed[k] = k % 2 ? -2.0 : 1.0;
  for (int i = 0; i < nu; i++) {
    unknowns[i] = (Reference)below(MODEL_VARIABLES + 3);
    legal = legal && is_variable(unknowns[i], REAL) && limits[unknowns[i]].settable == SET_NEVER;
  }
  for (int i = 0; i < nk; i++) {
    knowns[i] = (Reference)below(MODEL_VARIABLES + 3);
    legal &= is_variable(knowns[i], REAL);
    count += (size_t)count_of(knowns[i]);
    if (legal) {
      Settable s = limits[knowns[i]].settable;
      legal &= s == SET_INPUT || (s != SET_NEVER && known.phase == INITIALIZING);
    }
  }
  size_t told = miscounted(count);
  legal &= told == count;
  prepare(legal);
  int success = door_derivative(handle, unknowns, (size_t)nu, knowns, (size_t)nk, seed, told, result);
  if (legal && is_excused(success, "does not exist")) return;
  judged("a derivative", legal, success);
}

static void try_logging(void) {
  const char *categories[] = {"logStatusError", "logStatusDiscard", "logEvents", "logNonsense"};
  int first = below(4), n = below(5 - first), on = !chance(4), known_names = first + n <= 3;
  if (!JUDGE("logging", known_names, door_logging(handle, on, (size_t)n, categories + first))) return;
  errors_on = on && (n == 0 || first == 0);
  discards_on = on && (n == 0 || (first <= 1 && first + n >= 2));
  events_on = on && (n == 0 || first + n == 3);
}
#endif
