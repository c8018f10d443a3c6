#include "snapshot.h"

#include "limits.h"
#include "number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAVED_IN (OUTSIDE_A_STEP & ~IN(FAILED))

typedef unsigned long long Word;

/* A situation as bytes: members of 8 bytes each, so that there is no padding between them. */
typedef struct {
  Word digest;
  char model[40];
  Word phase, stop_defined;
  long long ticks;
  double time, start, stop, first_tick, offset;
  double v[MODEL_VARIABLES];
  double angle, slopes[MODEL_INPUTS + 1];
} Record;

static int are_snapshots_given(Instance *instance, const void *one, const void *other) {
  return (one && other) || instance_refuse(instance, "a null pointer in place of a state");
}

/* Fowler, Noll, Vo: FNV-1a, 64 bits, of all that follows the digest. */
static Word digest_of(const Record *record) {
  const unsigned char *byte = (const unsigned char *)record->model;
  const unsigned char *end = (const unsigned char *)(record + 1);
  Word hash = 14695981039346656037u;
  while (byte < end) hash = (hash ^ *byte++) * 1099511628211u;
  return hash;
}

static void encode(const Situation *s, Record *record) {
  memset(record, 0, sizeof *record);
  snprintf(record->model, sizeof record->model, "%s", model_token);
  record->phase = (Word)s->phase;
  record->stop_defined = (Word)s->stop_defined;
  record->ticks = s->core.ticks;
  record->time = s->time;
  record->start = s->start;
  record->stop = s->stop;
  record->first_tick = s->core.start;
  record->offset = s->core.offset;
  memcpy(record->v, s->core.v, sizeof record->v);
  record->angle = s->angle;
  memcpy(record->slopes, s->core.slopes, sizeof record->slopes);
  record->digest = digest_of(record);
}

static void decode(const Record *record, Situation *s) {
  memset(s, 0, sizeof *s);
  s->phase = (Phase)record->phase;
  s->stop_defined = (int)record->stop_defined;
  s->core.ticks = record->ticks;
  s->time = record->time;
  s->start = record->start;
  s->stop = record->stop;
  s->core.start = record->first_tick;
  s->core.offset = record->offset;
  memcpy(s->core.v, record->v, sizeof record->v);
  s->angle = record->angle;
  for (int i = 0; i < MODEL_INPUTS; i++)
    if (record->slopes[i] != 0.0) core_slope(&s->core, model_inputs[i], record->slopes[i]);
}

static int has_possible_times(const Situation *s) {
  const Core *core = &s->core;
  if (s->stop_defined ? !(s->stop >= s->start) : s->stop != 0.0) return 0;
  if (!(s->start >= EARLIEST_TIME && s->start <= LATEST_START)) return 0;
  if (!(s->time >= s->start && s->time <= LATEST_TIME)) return 0;
  if (IN(s->phase) & BEFORE_STEPS)
    return s->time == s->start && core->ticks == 0 && core->offset == 0.0 && core->start == 0.0;
  return core->start == s->start && core_is_at(core, s->time);
}

static int is_possible_value(int i, double value) {
  const Limits *limit = &limits[i];
  if (!isfinite(value)) return limit->continuous; /* computed anew */
  if (limit->settable == SET_NEVER) return 1;
  return limits_hold(limit, value) && (limit->kind == REAL || value == floor(value));
}

static int is_intact(Instance *instance, const Record *record) {
  if (strncmp(record->model, model_token, sizeof record->model) != 0)
    return instance_refuse(instance, "the saved state is not one of this model");
  if (record->digest != digest_of(record))
    return instance_refuse(instance, "the saved state is damaged: its digest does not fit");
  if (record->phase > TERMINATED || !(SAVED_IN & IN(record->phase)) || record->stop_defined > 1)
    return instance_refuse(instance, "the saved state has no legal phase or flag");
  return 1;
}

static int are_finite(const double *values, int n) {
  for (int i = 0; i < n; i++)
    if (!isfinite(values[i])) return 0;
  return 1;
}

static int is_possible(Instance *instance, const Situation *s) {
  for (int i = 0; i < MODEL_VARIABLES; i++)
    if (!is_possible_value(i, s->core.v[i]))
      return instance_refuse(instance, "the saved state has %s = %s, which is outside its range",
                             limits[i].name, NUMBER(s->core.v[i]));
  if (!isfinite(s->angle) || !are_finite(s->core.slopes, MODEL_INPUTS))
    return instance_refuse(instance, "the saved state has impossible changes of inputs");
  return has_possible_times(s) || instance_refuse(instance, "the saved state has impossible times");
}

/* Room for a snapshot: what is there already, or new. */
static Situation *room(Instance *instance, void **snapshot) {
  if (!*snapshot) *snapshot = calloc(1, sizeof(Situation));
  if (!*snapshot) instance_refuse(instance, "out of memory");
  return *snapshot;
}

int snapshot_save(Instance *instance, void **snapshot) {
  if (!instance_may(instance, SAVED_IN, "saving the state") ||
      !are_snapshots_given(instance, snapshot, snapshot))
    return 0;
  if (!model_is_finite(instance->now.core.v))
    return instance_refuse(instance, "a state that is not finite can't be saved");
  core_refresh(&instance->now.core); /* what was read before does not matter */
  Situation *saved = room(instance, snapshot);
  if (saved) *saved = instance->now;
  return saved != NULL;
}

int snapshot_restore(Instance *instance, const void *snapshot) {
  if (!instance_may(instance, OUTSIDE_A_STEP, "restoring a state") ||
      !are_snapshots_given(instance, snapshot, snapshot))
    return 0;
  instance->now = *(const Situation *)snapshot;
  instance_touch(instance);
  instance_note(instance, "state restored");
  return 1;
}

int snapshot_free(Instance *instance, void **snapshot) {
  if (!instance_may(instance, OUTSIDE_A_STEP, "freeing a state")) return 0;
  if (snapshot) {
    free(*snapshot);
    *snapshot = NULL;
  }
  return 1;
}

int snapshot_size(Instance *instance, const void *snapshot, size_t *size) {
  if (!instance_may(instance, OUTSIDE_A_STEP, "serializing a state") ||
      !are_snapshots_given(instance, snapshot, size))
    return 0;
  *size = sizeof(Record);
  return 1;
}

int snapshot_serialize(Instance *instance, const void *snapshot, void *bytes, size_t size) {
  if (!instance_may(instance, OUTSIDE_A_STEP, "serializing a state") ||
      !are_snapshots_given(instance, snapshot, bytes))
    return 0;
  if (size < sizeof(Record))
    return instance_refuse(instance, "%lu bytes are too few for a state, which takes %lu",
                           (unsigned long)size, (unsigned long)sizeof(Record));
  Record record;
  encode(snapshot, &record);
  memcpy(bytes, &record, sizeof record);
  return 1;
}

int snapshot_deserialize(Instance *instance, const void *bytes, size_t size, void **snapshot) {
  if (!instance_may(instance, OUTSIDE_A_STEP, "restoring a state") ||
      !are_snapshots_given(instance, bytes, snapshot))
    return 0;
  if (size != sizeof(Record))
    return instance_refuse(instance, "%lu bytes are no state of this model, which takes %lu",
                           (unsigned long)size, (unsigned long)sizeof(Record));
  Record record;
  memcpy(&record, bytes, sizeof record);
  if (!is_intact(instance, &record)) return 0;
  Situation situation;
  decode(&record, &situation);
  if (!is_possible(instance, &situation)) return 0;
  Situation *saved = room(instance, snapshot);
  if (saved) *saved = situation;
  return saved != NULL;
}
