/* Several instances of the FMU recorded together, each as `pyhrg.fmu.loops.record` does one. */
#include "inputs.h"
#include "instance.h"
#include "lanes.h"
#include "limits.h"

#include <stdlib.h>

#ifdef _WIN32
#define API __declspec(dllexport)
#else
#define API __attribute__((visibility("default")))
#endif

typedef enum { MOVING, HELD, ENDS, MEANS, GROUPS } Group;

/* What all gyros have in common. */
typedef struct {
  size_t rows, steps, commands; /* the first of HELD are commands */
  double start, step, tick;
  const unsigned char *is_new; /* rows */
  const unsigned *references[GROUPS];
  size_t counts[GROUPS];
} Plan;

/* Values of one gyro: moving (rows, steps, n), held (rows + 1, n), ends and means (rows, n). */
typedef struct {
  Instance *instance;
  double *values[GROUPS];
} Gyro;

typedef struct {
  const Plan *plan;
  const Gyro *gyros;
  size_t n;
  Lanes *lanes;
  double *now; /* (MEANS, lanes) */
} Flight;

/* Lanes beyond the last gyro are its twins. */
static const Gyro *gyro_in(const Flight *flight, size_t lane) {
  return &flight->gyros[lane < flight->n ? lane : flight->n - 1];
}

static int are_inputs_and_outputs(const Plan *plan) {
  for (int group = MOVING; group < GROUPS; group++)
    for (size_t k = 0; k < plan->counts[group]; k++) {
      unsigned reference = plan->references[group][k];
      if (reference >= MODEL_VARIABLES || limits[reference].kind == INTEGER || reference == MODEL_ANGLE) return 0;
      if (group <= HELD && limits[reference].settable != SET_INPUT) return 0;
    }
  return 1;
}

/* Instances between steps, at one time, which the last step does not lead beyond. */
static int can_start(const Flight *flight) {
  const Situation *first = &flight->gyros[0].instance->now;
  const Plan *plan = flight->plan;
  double duration = (double)plan->rows * (double)plan->steps * plan->step;
  for (size_t i = 0; i < flight->n; i++) {
    const Situation *now = &flight->gyros[i].instance->now;
    if (now->phase != STEPPING || now->stop_defined || now->core.start != first->core.start ||
        MODEL_PERIOD(now->core.v) != MODEL_PERIOD(first->core.v) ||
        now->core.is_sloping || now->angle != inputs_angle(&now->core) ||
        now->core.offset != first->core.offset || now->core.ticks != first->core.ticks ||
        !(fabs(plan->start - now->time) <= 1e-9 * (1.0 + fabs(now->time))) ||
        !(plan->step > 0.0 && plan->start + duration < LATEST_TIME - 1.0))
      return 0;
  }
  return 1;
}

static void load(const Flight *flight) {
  const Core *first = &flight->gyros[0].instance->now.core;
  for (unsigned i = 0; i < MODEL_VARIABLES; i++)
    for (size_t lane = 0; lane < WIDTH; lane++)
      lanes_values(flight->lanes, i)[lane] = gyro_in(flight, lane)->instance->now.core.v[i];
  lanes_begin(flight->lanes, first->start, first->offset, first->ticks);
}

static void store(const Flight *flight, double time) {
  for (size_t lane = 0; lane < flight->n; lane++) {
    Situation *now = &flight->gyros[lane].instance->now;
    for (unsigned i = 0; i < MODEL_VARIABLES; i++) now->core.v[i] = lanes_values(flight->lanes, i)[lane];
    now->core.offset = lanes_offset(flight->lanes);
    now->core.ticks = lanes_ticks(flight->lanes);
    now->core.held_fresh = now->core.outputs_fresh = 0;
    now->time = time;
  }
}

/* The first `count` inputs of a group, from a row of each gyro's values. */
static int set(const Flight *flight, Group group, size_t row, size_t count) {
  const Plan *plan = flight->plan;
  for (size_t k = 0; k < count; k++) {
    unsigned reference = plan->references[group][k];
    for (size_t lane = 0; lane < WIDTH; lane++) {
      double value = gyro_in(flight, lane)->values[group][row * plan->counts[group] + k];
      if (!(value >= limits[reference].minimum && value <= limits[reference].maximum)) return 0;
      lanes_values(flight->lanes, reference)[lane] = value;
    }
  }
  if (count) lanes_touch(flight->lanes);
  return 1;
}

/* Present values of a variable; NULL if one is not finite, or lanes had to go different ways. */
static const double *get(const Flight *flight, unsigned reference) {
  if (limits[reference].continuous && !lanes_refresh(flight->lanes)) return NULL;
  const double *values = lanes_values(flight->lanes, reference);
  for (size_t lane = 0; lane < WIDTH; lane++)
    if (!isfinite(values[lane])) return NULL;
  return values;
}

static int get_now(const Flight *flight) {
  for (size_t k = 0; k < flight->plan->counts[MEANS]; k++) {
    const double *values = get(flight, flight->plan->references[MEANS][k]);
    if (!values) return 0;
    for (size_t lane = 0; lane < flight->n; lane++) flight->now[k * WIDTH + lane] = values[lane];
  }
  return 1;
}

static int get_ends(const Flight *flight, size_t row) {
  size_t count = flight->plan->counts[ENDS];
  for (size_t k = 0; k < count; k++) {
    const double *values = get(flight, flight->plan->references[ENDS][k]);
    if (!values) return 0;
    for (size_t lane = 0; lane < flight->n; lane++)
      flight->gyros[lane].values[ENDS][row * count + k] = values[lane];
  }
  return 1;
}

static void add(const Flight *flight, size_t row, double weight) {
  size_t count = flight->plan->counts[MEANS];
  for (size_t lane = 0; lane < flight->n; lane++)
    for (size_t k = 0; k < count; k++)
      flight->gyros[lane].values[MEANS][row * count + k] +=
          flight->now[k * WIDTH + lane] * weight / 2.0;
}

static int integrate(const Flight *flight, size_t row, double time, double step) {
  add(flight, row, step + flight->plan->tick);
  if (!lanes_advance(flight->lanes, time + step) || !get_now(flight)) return 0;
  add(flight, row, step - flight->plan->tick);
  return 1;
}

static int fly_row(const Flight *flight, size_t row, double *end) {
  const Plan *plan = flight->plan;
  double tick = plan->tick;
  int is_new = plan->is_new[row];
  if (!set(flight, HELD, row, plan->counts[HELD])) return 0;
  for (size_t j = 0; j < plan->steps; j++) {
    size_t before = row * plan->steps + j;
    double time = plan->start + (double)before * plan->step, rest = plan->step;
    int is_last = tick > 0.0 && j == plan->steps - 1 && plan->commands + plan->counts[MEANS];
    if (!set(flight, MOVING, before, plan->counts[MOVING])) return 0;
    while (rest > 1.5 * tick && tick > 0.0 && (is_last || is_new)) {
      double part = is_new ? tick : rest - tick;
      if (!integrate(flight, row, time, part)) return 0;
      time = time + part, rest = rest - part;
    }
    if (is_last && !set(flight, HELD, row + 1, plan->commands)) return 0;
    if (!integrate(flight, row, time, rest)) return 0;
    *end = time + rest;
  }
  for (size_t i = 0; i < flight->n * plan->counts[MEANS]; i++)
    flight->gyros[i % flight->n].values[MEANS][row * plan->counts[MEANS] + i / flight->n] /=
        (double)plan->steps * plan->step;
  return get_ends(flight, row);
}

/* All rows of up to WIDTH gyros: 1. Or 0, with the instances as they were, where that is impossible:
   each by itself will then say why, or do it. */
API int record_together(const Plan *plan, const Gyro *gyros, size_t n) {
  Flight flight = {plan, gyros, n, NULL, NULL};
  if (n < 1 || n > WIDTH || !are_inputs_and_outputs(plan) || !can_start(&flight)) return 0;
  flight.lanes = lanes_create();
  flight.now = calloc(plan->counts[MEANS] * WIDTH + 1, sizeof *flight.now);
  int done = flight.lanes && flight.now;
  double end = plan->start;
  if (done) load(&flight);
  done = done && get_now(&flight);
  for (size_t row = 0; done && row < plan->rows; row++) done = fly_row(&flight, row, &end);
  if (done) store(&flight, end);
  free(flight.now);
  if (flight.lanes) lanes_free(flight.lanes);
  return done;
}
