/* The seam between equations and interface: a model knows no FMI, an interface knows no physics.
   All variables lie in one array v; the generated source fills in these functions. */
#ifndef MODEL_H
#define MODEL_H

#include "model_constants.h"

#include <math.h>

/* Default values of settable parameters and inputs. */
void model_defaults(double *v);
/* Dependent parameters, from the settable ones. */
void model_parameters(double *v);
/* Start values of states and sampled variables, from the parameters. */
void model_start(double *v);
/* What depends on inputs and sampled variables, no state: after inputs were set. Samples keep up
   what they change themselves. */
void model_held(double *v);
/* Continuous states over a step h, inputs and sampled variables held. */
void model_step(double *v, double h);
/* One sample of the clocks that are due at this multiple of the base period MODEL_PERIOD(v). */
void model_tick(double *v, long long index);
/* Continuous variables at the present state. */
void model_outputs(double *v);
/* Whether the continuous states, the samples that act on them, and the sampled outputs are finite. */
int model_is_finite(const double *v);

#endif
