/* Which variables may be set, and to what. */
#ifndef LIMITS_H
#define LIMITS_H

#include "names.h"

#include <math.h>

/* In place of a bound that is not given. */
#define UNLIMITED 1e300

typedef enum { SET_NEVER, SET_PARAMETER, SET_TUNABLE, SET_INPUT } Settable;

/* A Boolean is 1 or 0 in the core. */
typedef enum { REAL, INTEGER, BOOLEAN, KINDS } Kind;

typedef struct {
  const char *name; /* of the scalar */
  int count; /* values of the variable that begins here: an array's in FMI 3, 0 within one */
  Settable settable;
  Kind kind;
  int continuous; /* algebraic: computed when it is asked for */
  double minimum, maximum;
} Limits;

/* What a value may exceed its range by, over the larger end: some forty roundings of a double. */
#define ROUNDING 1e-14

/* Whether a value is within its range, but for a rounding; NaN is not. */
static inline int limits_hold(const Limits *limit, double value) {
  double low = fabs(limit->minimum), high = fabs(limit->maximum);
  double larger = fmax(low < UNLIMITED ? low : 0.0, high < UNLIMITED ? high : 0.0);
  return value >= limit->minimum - ROUNDING * larger && value <= limit->maximum + ROUNDING * larger;
}

static inline double limits_nearest(const Limits *limit, double value) {
  return value < limit->minimum ? limit->minimum : value > limit->maximum ? limit->maximum : value;
}

extern const Limits limits[]; /* by offset, MODEL_VARIABLES entries */
extern const char *const model_token;

#endif
