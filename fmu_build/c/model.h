/* The seam between equations and interface: a model knows no FMI, an interface knows no physics.
   All variables lie in one array v; the generated source fills in these functions. */
#ifndef MODEL_H
#define MODEL_H

#include "model_constants.h"
#include "names.h"
#include "real.h"

/* Continuous inputs, which may change evenly within a step. */
extern const unsigned model_inputs[MODEL_INPUTS + 1];
/* Default values of settable parameters and inputs. */
void model_defaults(real *v);
/* Dependent parameters, from the settable ones. */
void model_parameters(real *v);
/* Start values of states and sampled variables, from the parameters. */
void model_start(real *v);
/* What depends on inputs and sampled variables, no state: after inputs were set. Samples keep up
   what they change themselves. */
void model_held(real *v);
/* Continuous states over a step h, inputs and sampled variables held. */
void model_step(real *v, double h);
/* One sample of the clocks that are due at this multiple of the base period MODEL_PERIOD(v). */
void model_tick(real *v, long long index);
/* Continuous variables at the present state. */
void model_outputs(real *v);
/* Whether the continuous states, the samples that act on them, and the sampled outputs are finite. */
int model_is_finite(const real *v);

#endif
