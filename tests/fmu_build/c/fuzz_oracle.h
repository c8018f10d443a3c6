/* What the fuzzer knows of the instance, draws at random, and holds each call to. */
#ifndef FUZZ_ORACLE_H
#define FUZZ_ORACLE_H

#include "door.h"
#include "limits.h"
#include "model.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAVED 4
#define STATE_BYTES 65536
#define DIGEST 8 /* bytes that a serialized state begins with */
#define MOST 8   /* values of a variable */

typedef enum { FRESH, INITIALIZING, RUNNING, FAILED, OVER } Phase;

/* What the fuzzer knows of the instance. */
typedef struct {
  Phase phase;
  double time, angle; /* angle: of the case */
  int on_tick;
} Known;

typedef struct {
  void *state;
  Known known;
} Saved;

static Handle handle;
static Known known;
static Saved saved[SAVED];
static int errors_told, events_told, errors_on, discards_on, events_on;
static char last_error[512];
static unsigned long long random_state;
static long calls_made, illegal_calls, failed_states;

static void finding(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fprintf(stderr, "call %ld, phase %d: ", calls_made, (int)known.phase);
  vfprintf(stderr, format, arguments);
  fprintf(stderr, " (last message: %s)\n", last_error);
  va_end(arguments);
  exit(1);
}

static void on_message(int is_error, const char *category, const char *message) {
  if (!is_error) {
    events_told++;
    return;
  }
  errors_told++;
  snprintf(last_error, sizeof last_error, "%s", message);
  if (!(strcmp(category, "logStatusDiscard") == 0 ? discards_on : errors_on))
    finding("%s was told though it is off", category);
}

/* Vigna, splitmix64. */
static unsigned long long draw(void) {
  unsigned long long z = (random_state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}
static int below(int n) { return (int)(draw() % (unsigned)n); }
static int chance(int one_in) { return below(one_in) == 0; }
static double between(double a, double b) { return a + (b - a) * ((double)(draw() >> 11) * 0x1p-53); }

static double wild(void) {
  const double values[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-310, -0.0, 1e18};
  return values[below(8)];
}

static size_t state_of(unsigned char *bytes) {
  void *state = NULL;
  size_t n = 0;
  if (!door_save(handle, &state) || !door_size(handle, state, &n) || n > STATE_BYTES ||
      !door_write(handle, state, bytes, n) || !door_drop(handle, &state))
    finding("the state can't be saved");
  return n;
}

/* The outcome of a call that the model of the standard says is legal or not. */
static unsigned char before[STATE_BYTES], after[STATE_BYTES];
static int errors_before;

static void prepare(int legal) {
  calls_made++;
  if (!legal && known.phase != FAILED) state_of(before);
  errors_before = errors_told;
}

static int judged(const char *call, int legal, int success) {
  int told = errors_told - errors_before;
  if (legal != success) finding("%s was %s, expected %s", call, success ? "taken" : "refused",
                                legal ? "success" : "an error");
  if (success && told) finding("%s succeeded with an error message", call);
  if (!success && errors_on && discards_on && !told) finding("%s failed without a message", call);
  if (!legal) illegal_calls++;
  if (!legal && known.phase != FAILED && memcmp(before, after, state_of(after)) != 0)
    finding("%s was refused but changed the state", call);
  return success;
}
#define JUDGE(call, legal, expression) (prepare(legal), judged(call, legal, expression))

static void forget(void) { known = (Known){FRESH, 0.0, 0.0, 1}; }

/* FMI 2 has no Boolean. */
static Kind some_kind(void) { return chance(5) ? INTEGER : FMI == 3 && chance(5) ? BOOLEAN : REAL; }

/* Within an array no variable begins. */
static int is_variable(Reference r, Kind kind) {
  return r < MODEL_VARIABLES && limits[r].count > 0 && limits[r].kind == kind;
}

static int count_of(Reference r) {
  return r < MODEL_VARIABLES && limits[r].count > 1 ? limits[r].count : 1;
}

/* A number of values that is wrong for FMI 3, at times. */
static size_t miscounted(size_t count) {
  return FMI == 3 && chance(20) ? count + 1 - 2 * (size_t)(count && chance(2)) : count;
}

static Reference pick(Kind kind, int settable) {
  for (;;) {
    Reference r = (Reference)below(MODEL_VARIABLES);
    if (is_variable(r, kind) && (!settable || limits[r].settable != SET_NEVER)) return r;
  }
}

/* The period by which the model is sampled at present, s; some models have it as a parameter. */
static double tick(void) {
  Reference r = 0;
  double period = 1e-3;
  while (strcmp(limits[r].name, "samplePeriod") != 0) r++;
  if (known.phase == RUNNING && !door_get(handle, &r, 1, 0, &period)) finding("no period");
  return period;
}

static double input(Reference r) {
  double value = 0.0;
  if (!door_get(handle, &r, 1, 0, &value)) finding("an input can't be read");
  return value;
}

/* Whether the case can turn in a step to the angle that is set. */
static int can_turn(double step) {
  if (known.phase != RUNNING) return 0;
  double turn = input(MODEL_ANGLE) - known.angle, rate = input(MODEL_RATE) + turn / step;
  return turn == 0.0 || limits_hold(&limits[MODEL_RATE], rate);
}

static int is_open(void) { return known.phase != FRESH && known.phase != FAILED; }

/* What random values may lead to, and must then be said. */
static int is_excused(int success, const char *message) {
  return !success && (!errors_on || strstr(last_error, message));
}

/* A legal start or step may end in a state that is not finite: then it says so. */
static int may_fail(const char *call, int legal, int success) {
  if (legal && is_excused(success, "no longer finite")) {
    known.phase = FAILED;
    failed_states++;
    return 0;
  }
  return judged(call, legal, success);
}

/* Every value, zero where there is none. */
static void all_values(double *values) {
  memset(values, 0, MODEL_VARIABLES * sizeof *values);
  for (Reference r = 0; r < MODEL_VARIABLES; r++)
    if (is_variable(r, REAL)) door_get_all(handle, &r, 1, 0, &values[r], (size_t)count_of(r));
}

static void same_values(const double *one, const double *other, const char *first, const char *second) {
  for (int i = 0; i < MODEL_VARIABLES; i++)
    if (memcmp(&one[i], &other[i], 8) != 0)
      finding("%s = %.17g %s, %.17g %s", limits[i].name, one[i], first, other[i], second);
}
#endif
