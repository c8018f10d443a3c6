/* Two FMUs in one program: this file is compiled with each one's prefix, and once without for main,
   which turns both side by side and prints their angles in hexadecimal. */
#include <stdio.h>

#if defined FMI2_FUNCTION_PREFIX || defined FMI3_FUNCTION_PREFIX
#include "door.h"
#include "names.h"

static void on_message(int is_error, const char *category, const char *message) {
  if (is_error) printf("%s: %s\n", category, message);
}

void *OWN(begin)(void) {
  Handle c = door_create(TOKEN, 0);
  return c && door_initialize(c, 0.0, 0, 0.0) && door_exit(c) ? c : NULL;
}

int OWN(turn)(void *c, double time, double step) {
  Reference rate = RATE;
  double value = 0.5;
  return door_set(c, &rate, 1, 0, &value) && door_step(c, time, step);
}

double OWN(end)(void *c) {
  Reference angle = GYRO_ANGLE;
  double value = 0.0;
  if (!door_get(c, &angle, 1, 0, &value)) value = -1.0;
  door_free(c);
  return value;
}

#else

#define DECLARE(prefix)                                   \
  void *prefix##begin(void);                              \
  int prefix##turn(void *c, double time, double step);    \
  double prefix##end(void *c);
DECLARE(first_)
DECLARE(second_)

int main(void) {
  void *first = first_begin(), *second = second_begin();
  if (!first || !second) return 1;
  for (int i = 0; i < 20; i++)
    if (!first_turn(first, 0.1 * i, 0.1) || !second_turn(second, 0.1 * i, 0.1)) return 2;
  printf("%a %a\n", first_end(first), second_end(second));
  return 0;
}

#endif
