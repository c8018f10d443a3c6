/* Partial derivatives of what the model computes, by what may be set in the present phase. */
#ifndef DERIVATIVE_H
#define DERIVATIVE_H

#include "instance.h"

/* During initialization: of what the start time will have by parameters and inputs; from then on: of
   continuous variables by inputs (sampled ones do not change between ticks: exactly zero).

   Central differences of fourth order on copies of the core, a thousandth of the known's scale
   apart: errors are about 1e-10 of the unknown over that scale, 1e-13 where it is linear. Exact
   tangents would need a second emitter; importers use these for initialization and coupling,
   whose own tolerances are wider. An array has a seed, or a sensitivity, a value; arrays are known. */
int derivative_directional(Instance *instance, const unsigned *unknowns, size_t nu,
                           const unsigned *knowns, size_t nk, const double *seed,
                           double *sensitivity);
/* The transpose: of the seeded sum of the unknowns by each known. */
int derivative_adjoint(Instance *instance, const unsigned *unknowns, size_t nu,
                       const unsigned *knowns, size_t nk, const double *seed, double *sensitivity);

#endif
