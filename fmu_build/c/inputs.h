/* How inputs change within a step. */
#ifndef INPUTS_H
#define INPUTS_H

#include "instance.h"

/* First derivatives of inputs at the begin of the next step, and for that step alone. */
int inputs_set_slopes(Instance *instance, const unsigned *references, size_t n, const int *orders,
                      const double *slopes);
/* Whether all inputs stay within their ranges over a step; the case's rate is that of its angle then. */
int inputs_begin(Instance *instance, double step);
/* Integrate to a time, at that rate. */
void inputs_advance(Instance *instance, double time);
/* The step ended after a time, as a whole or early; inputs hold. */
void inputs_end(Instance *instance, double duration, int is_whole);
/* The input that is the case's angle; 0 where there is none. */
static inline double inputs_angle(const Core *core) {
  return MODEL_ANGLE < MODEL_VARIABLES ? core->v[MODEL_ANGLE] : 0.0;
}

#endif
