#include "number.h"

#include "limits.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Whole numbers below this have at most 15 digits, all of which a double holds. */
#define LARGEST_WHOLE 1e15

char *number_text(double value, char text[NUMBER_SIZE]) {
  if (value == floor(value) && fabs(value) < LARGEST_WHOLE) {
    snprintf(text, NUMBER_SIZE, "%.0f", value);
    return text;
  }
  int digits = 1;
  do snprintf(text, NUMBER_SIZE, "%.*g", digits, value);
  while (strtod(text, NULL) != value && ++digits <= 17);
  return text;
}

char *range_text(double minimum, double maximum, char text[RANGE_SIZE]) {
  char low[NUMBER_SIZE], high[NUMBER_SIZE];
  number_text(minimum, low);
  number_text(maximum, high);
  if (minimum <= -UNLIMITED && maximum >= UNLIMITED)
    snprintf(text, RANGE_SIZE, ": any number");
  else if (maximum >= UNLIMITED)
    snprintf(text, RANGE_SIZE, " from %s up", low);
  else if (minimum <= -UNLIMITED)
    snprintf(text, RANGE_SIZE, " up to %s", high);
  else
    snprintf(text, RANGE_SIZE, " from %s to %s", low, high);
  return text;
}
