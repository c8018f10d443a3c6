/* Random calls that save and restore states: good, damaged, forged, and none. */
#ifndef FUZZ_STATES_H
#define FUZZ_STATES_H

#include "fuzz_oracle.h"

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
  JUDGE("a derivative of nothing", 0, door_derivative(handle, NULL, 1, &r, 1, &value, 1, &value));
  JUDGE("a derivative without a seed", 0, door_derivative(handle, &r, 1, &r, 1, NULL, 1, &value));
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
#endif
