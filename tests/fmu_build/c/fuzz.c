/* Random legal and illegal calls, held to a small model of what the standard allows.

   `fuzz SEED CALLS` prints what it did; at the first finding it prints that and ends with status 1.
   An illegal call must give an error, a message, and leave every byte of the state as it was; a
   legal one must succeed without a message; saved states must come back byte for byte; and a span
   of ticks must not depend on the steps that it is made of. */
#define _POSIX_C_SOURCE 200809L
#include "door.h"
#include "limits.h"
#include "model.h"

#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SAVED 4
#define STATE_BYTES 65536
#define DIGEST 8 /* bytes that a serialized state begins with */
#define HANGING 120  /* s */

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

static void create(void) {
  for (int i = 0; i < SAVED; i++) {
    if (handle && !door_drop(handle, &saved[i].state)) finding("a state can't be freed");
  }
  if (handle) door_free(handle);
  errors_on = discards_on = 1;
  if (door_create("wrong", 0)) finding("a wrong token was taken");
  events_on = below(2);
  handle = door_create(model_token, events_on);
  if (!handle) finding("no instance");
  forget();
}

/* FMI 2 has no Boolean. */
static Kind some_kind(void) { return chance(5) ? INTEGER : FMI == 3 && chance(5) ? BOOLEAN : REAL; }

static Reference pick(Kind kind, int settable) {
  for (;;) {
    Reference r = (Reference)below(MODEL_VARIABLES);
    if (limits[r].kind == kind && (!settable || limits[r].settable != SET_NEVER)) return r;
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
  for (Reference r = 0; r < MODEL_VARIABLES; r++) {
    values[r] = 0.0;
    if (limits[r].kind == REAL) door_get(handle, &r, 1, 0, &values[r]);
  }
}

static void same_values(const double *one, const double *other, const char *first, const char *second) {
  for (int i = 0; i < MODEL_VARIABLES; i++)
    if (memcmp(&one[i], &other[i], 8) != 0)
      finding("%s = %.17g %s, %.17g %s", limits[i].name, one[i], first, other[i], second);
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
  double values[4];
  Kind kind = some_kind();
  int n = below(5), legal = is_open();
  for (int i = 0; i < n; i++) {
    references[i] = chance(30) ? (Reference)draw() % (MODEL_VARIABLES + 2000) : pick(kind, 0);
    int is_time = FMI == 3 && kind == REAL && references[i] == MODEL_VARIABLES;
    legal &= is_time || (references[i] < MODEL_VARIABLES && limits[references[i]].kind == kind);
  }
  if (known.phase == FAILED) return; /* each value may or may not be finite */
  int null = n && chance(30);
  size_t bytes = known.phase == FRESH ? 0 : state_of(before);
  prepare(legal && !null);
  int success = door_get(handle, n ? references : NULL, (size_t)n, (int)kind, null || !n ? NULL : values);
  if (legal && !null && is_excused(success, "is not finite at")) {
    if (known.phase == RUNNING || known.phase == INITIALIZING) must_fail();
    return;
  }
  judged("reading", legal && !null, success);
  if (success && (state_of(after) != bytes || memcmp(before, after, bytes) != 0))
    finding("reading changed the state");
  for (int i = 0; success && kind == REAL && i < n; i++)
    if (!isfinite(values[i])) finding("%s was read as %g", limits[references[i]].name, values[i]);
}

static double sensible(const Limits *limit) {
  double low = fmax(limit->minimum, -1.0), high = fmin(limit->maximum, 1.0);
  if (limit->minimum > 0.0) low = limit->minimum, high = fmin(limit->maximum, 10.0 * low);
  if (chance(5)) low = limit->minimum, high = limit->maximum;
  if (chance(10)) return chance(2) ? limit->minimum : limit->maximum;
  return between(low, high) * (chance(3) ? 1.0 : 1e-3) * (limit->minimum > 0.0 ? 0.0 : 1.0) +
         (limit->minimum > 0.0 ? between(low, high) : 0.0);
}

static int may_set(Reference r, double value, Kind kind) {
  if (r >= MODEL_VARIABLES || limits[r].kind != kind) return 0;
  const Limits *limit = &limits[r];
  return limit->settable != SET_NEVER && !(limit->settable == SET_PARAMETER && known.phase == RUNNING) &&
         limits_hold(limit, value);
}

static void try_set(void) {
  Reference references[3];
  double reals[3];
  int integers[3];
  _Bool flags[3];
  const void *of_kind[KINDS] = {reals, integers, flags};
  Kind kind = some_kind();
  int n = below(4);
  int legal = known.phase == FRESH || known.phase == INITIALIZING || known.phase == RUNNING;
  for (int i = 0; i < n; i++) {
    Reference r = references[i] = chance(30) ? (Reference)below(MODEL_VARIABLES + 9) : pick(kind, 1);
    while (known.phase == RUNNING && kind == REAL && !chance(20) && r < MODEL_VARIABLES &&
           limits[r].settable == SET_PARAMETER)
      r = references[i] = pick(REAL, 1);
    reals[i] = chance(20) || r >= MODEL_VARIABLES ? wild() : sensible(&limits[r]);
    integers[i] = chance(20) ? -(int)(draw() >> 34) : (int)(draw() >> 34);
    flags[i] = chance(2);
    legal &= may_set(r, kind == REAL ? reals[i] : kind == INTEGER ? integers[i] : flags[i], kind);
  }
  int null = n && chance(30);
  const Reference *given = n && !(null && chance(2)) ? references : NULL;
  JUDGE("setting", legal && !null,
        door_set(handle, given, (size_t)n, (int)kind, null || !n ? NULL : of_kind[kind]));
}

static void try_save(void) {
  Saved *slot = &saved[below(SAVED)];
  if (JUDGE("saving", known.phase != FAILED, door_save(handle, &slot->state))) slot->known = known;
}

static void try_null_pointers(void) {
  size_t n = 0;
  double value;
  void *none = NULL;
  Reference r = 0;
  JUDGE("saving into nothing", 0, door_save(handle, NULL));
  JUDGE("restoring nothing", 0, door_restore(handle, NULL));
  JUDGE("the size of nothing", 0, door_size(handle, NULL, &n));
  JUDGE("serializing nothing", 0, door_write(handle, NULL, &value, sizeof value));
  JUDGE("reading nothing", 0, door_read(handle, NULL, sizeof value, &none));
  JUDGE("a derivative of nothing", 0, door_derivative(handle, NULL, 1, &r, 1, &value, &value));
  JUDGE("a derivative without a seed", 0, door_derivative(handle, &r, 1, &r, 1, NULL, &value));
  JUDGE("logging nothing", 0, door_logging(handle, 1, 1, NULL));
  JUDGE("freeing nothing", 1, door_drop(handle, &none) && door_drop(handle, NULL));
}

static void try_restore(void) {
  Saved *slot = &saved[below(SAVED)];
  if (JUDGE("restoring", slot->state != NULL, door_restore(handle, slot->state))) known = slot->known;
}

/* Fowler, Noll, Vo: as the state's own digest. */
static void forge_digest(unsigned char *bytes, size_t n) {
  unsigned long long hash = 14695981039346656037u;
  for (size_t i = DIGEST; i < n; i++) hash = (hash ^ bytes[i]) * 1099511628211u;
  memcpy(bytes, &hash, DIGEST);
}

/* A damaged state is refused; a forged one may be taken if it is possible, and must do no harm. */
static void try_corrupt(void) {
  static unsigned char good[STATE_BYTES], bad[STATE_BYTES];
  if (known.phase == FAILED) return;
  size_t n = state_of(good);
  void *state = NULL;
  memcpy(bad, good, n);
  size_t at = (size_t)below((int)n);
  bad[at] ^= (unsigned char)(1 + below(255));
  JUDGE("a damaged state", 0, door_read(handle, bad, n, &state));
  JUDGE("a short state", 0, door_read(handle, good, n - 1 - (size_t)below((int)n - 1), &state));
  memcpy(bad, good, n);
  double value = chance(2) ? wild() : between(-1e3, 1e3);
  unsigned long long word = chance(2) ? draw() : (unsigned long long)below(8);
  size_t field = chance(3) ? (size_t)below(16) : (size_t)below((int)(n - DIGEST) / 8);
  memcpy(bad + DIGEST + 8 * field, chance(2) ? (void *)&value : (void *)&word, 8);
  forge_digest(bad, n);
  calls_made++;
  if (!door_read(handle, bad, n, &state)) return;
  if (!door_restore(handle, state)) finding("a state that was read can't be restored");
  double time = 0.0;
  Reference r = MODEL_VARIABLES;
  if (FMI == 3 && door_get(handle, &r, 1, 0, &time)) door_step(handle, time, 0.005);
  door_step(handle, known.time, 0.005);
  door_drop(handle, &state);
  if (!door_read(handle, good, n, &state) || !door_restore(handle, state))
    finding("a good state can't be restored");
  door_drop(handle, &state);
  if (state_of(after) != n || memcmp(good, after, n) != 0) finding("a state comes back changed");
}

/* From one state over the same ticks in steps of two kinds. */
static void try_partition(void) {
  static double whole[MODEL_VARIABLES], parts[MODEL_VARIABLES];
  if (known.phase != RUNNING || !known.on_tick || known.time > 1e6) return;
  if (input(MODEL_ANGLE) != known.angle) return; /* the first step turns the case */
  void *state = NULL;
  int ticks = 2 + below(30);
  double period = tick();
  calls_made++;
  if (!door_save(handle, &state)) finding("the state can't be saved");
  if (door_step(handle, known.time, ticks * period)) {
    all_values(whole);
    double time = known.time;
    if (!door_restore(handle, state)) finding("the state can't be restored");
    for (int done = 0, step; done < ticks; done += step) {
      step = 1 + below(ticks - done);
      double end = known.time + (done + step) * period;
      if (!door_step(handle, time, end - time)) finding("a part of a good step failed");
      time = time + (end - time);
    }
    all_values(parts);
    same_values(whole, parts, "in one step", "in several");
  }
  if (!door_restore(handle, state) || !door_drop(handle, &state)) finding("the state is lost");
}

static void try_derivative(void) {
  Reference unknowns[3], knowns[2];
  double seed[2] = {1.0, -2.0}, result[3];
  int nu = below(4), nk = below(3), legal = is_open();
  for (int i = 0; i < nu; i++) {
    unknowns[i] = (Reference)below(MODEL_VARIABLES + 3);
    legal &= unknowns[i] < MODEL_VARIABLES && limits[unknowns[i]].kind == REAL &&
             limits[unknowns[i]].settable == SET_NEVER;
  }
  for (int i = 0; i < nk; i++) {
    knowns[i] = (Reference)below(MODEL_VARIABLES + 3);
    legal &= knowns[i] < MODEL_VARIABLES && limits[knowns[i]].kind == REAL;
    if (legal) {
      Settable s = limits[knowns[i]].settable;
      legal &= s == SET_INPUT || (s != SET_NEVER && known.phase == INITIALIZING);
    }
  }
  prepare(legal);
  int success = door_derivative(handle, unknowns, (size_t)nu, knowns, (size_t)nk, seed, result);
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

static void one_call(void) {
  int events = events_told;
  switch (below(20)) {
    case 0: case 1: try_initialize(); break;
    case 2: case 3: try_exit(); break;
    case 4: case 5: case 6: case 7: try_step(); break;
    case 8: case 9: try_get(); break;
    case 10: case 11: case 12: try_set(); break;
    case 13: try_save(); break;
    case 14: try_restore(); break;
    case 15: try_corrupt(); break;
    case 16: try_partition(); break;
    case 17: try_derivative(); break;
    case 18: {
      int which = below(UNSUPPORTED_CALLS);
      JUDGE("an unsupported call", 0, door_unsupported(handle, which));
      if (chance(4)) try_logging();
      if (chance(4)) try_null_pointers();
      break;
    }
    default:
      if (chance(4) || known.phase == FAILED) {
        if (JUDGE("a reset", 1, door_reset(handle))) forget();
      } else if (chance(4)) {
        if (JUDGE("termination", known.phase == RUNNING, door_terminate(handle))) known.phase = OVER;
      } else if (chance(20)) {
        create();
      }
  }
  if (!events_on && events_told != events) finding("an event was told though logging is off");
}

/* A null instance is refused by every call, and crashes none. */
static void null_instance(void) {
  Handle own = handle;
  void *state = NULL;
  double value = 0.0;
  size_t n = 0;
  Reference r = 0;
  int taken = door_initialize(NULL, 0.0, 0, 0.0) + door_exit(NULL) + door_terminate(NULL) +
              door_reset(NULL) + door_get(NULL, &r, 1, 0, &value) + door_set(NULL, &r, 1, 0, &value) +
              door_step(NULL, 0.0, 1.0) + door_save(NULL, &state) + door_restore(NULL, state) +
              door_drop(NULL, &state) + door_size(NULL, state, &n) + door_write(NULL, state, &value, n) +
              door_read(NULL, &value, n, &state) + door_logging(NULL, 1, 0, NULL) +
              door_derivative(NULL, &r, 1, &r, 1, &value, &value);
  for (int i = 0; i < UNSUPPORTED_CALLS; i++) taken += door_unsupported(NULL, i);
  if (taken) finding("%d calls were taken by a null instance", taken);
  door_free(NULL);
  handle = own;
}

static void tell_hanging(int number) {
  (void)number;
  finding("the call has not ended after %d s", HANGING);
}

int main(int count, char **arguments) {
  if (count != 3) return 2;
  signal(SIGALRM, tell_hanging);
  random_state = strtoull(arguments[1], NULL, 10);
  long calls = atol(arguments[2]);
  null_instance();
  create();
  while (calls_made < calls) {
    alarm(HANGING);
    one_call();
  }
  for (int i = 0; i < SAVED; i++) door_drop(handle, &saved[i].state);
  door_free(handle);
  printf("%ld calls, %ld illegal, %ld states not finite\n", calls_made, illegal_calls, failed_states);
  return 0;
}
