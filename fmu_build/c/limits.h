/* Which variables may be set, and to what. */
#ifndef LIMITS_H
#define LIMITS_H

#include "names.h"

/* In place of a bound that is not given. */
#define UNLIMITED 1e300

typedef enum { SET_NEVER, SET_PARAMETER, SET_INPUT } Settable;

typedef struct {
  const char *name;
  Settable settable;
  int integer;
  int continuous; /* algebraic: computed when it is asked for */
  double minimum, maximum;
} Limits;

extern const Limits limits[]; /* by offset, MODEL_VARIABLES entries */
extern const char *const model_token;

#endif
