/* Random legal and illegal calls, held to a small model of what the standard allows.

   `fuzz SEED CALLS` prints what it did; at the first finding it prints that and ends with status 1.
   An illegal call must give an error, a message, and leave every byte of the state as it was; a
   legal one must succeed without a message; saved states must come back byte for byte; and a span
   of ticks must not depend on the steps that it is made of. */
#define _POSIX_C_SOURCE 200809L
#include "fuzz_calls.h"
#include "fuzz_states.h"

#include <signal.h>
#include <unistd.h>

#define HANGING 120 /* s */

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
              door_derivative(NULL, &r, 1, &r, 1, &value, 1, &value);
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
