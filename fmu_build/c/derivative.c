#include "derivative.h"

#include "limits.h"

/* The core at -2, -1, 1 and 2 steps of one known from where it is. */
typedef struct {
  Core at[4];
  double step;
} Stencil;

/* Scale over which a known matters: itself where its sign is given, else a share of its range. */
static double scale_of(const Limits *limit, double value) {
  double range = limit->maximum - limit->minimum;
  if (limit->minimum >= 0.0 && value > 0.0) return value;
  return fmax(fabs(value), range < UNLIMITED ? 1e-3 * range : 1.0);
}

static void stretch(const Instance *instance, unsigned known, Stencil *stencil) {
  static const double steps[4] = {-2.0, -1.0, 1.0, 2.0};
  stencil->step = 1e-3 * scale_of(&limits[known], instance->now.core.v[known]);
  for (int i = 0; i < 4; i++) {
    Core *core = &stencil->at[i];
    *core = instance->now.core;
    core->v[known] += steps[i] * stencil->step;
    core_touch(core);
    if (instance->now.phase == INITIALIZING) {
      core_settle(core);
      core_initialize(core, instance->now.start);
    }
    core_refresh(core);
  }
}

static double partial(const Stencil *stencil, unsigned unknown) {
  const Core *at = stencil->at;
  double inner = at[2].v[unknown] - at[1].v[unknown], outer = at[3].v[unknown] - at[0].v[unknown];
  return (8.0 * inner - outer) / (12.0 * stencil->step);
}

static int is_unknown(Instance *instance, unsigned reference) {
  if (!instance_knows(reference, REAL))
    return instance_refuse(instance, "no real variable has the value reference %u", reference);
  return limits[reference].settable == SET_NEVER ||
         instance_refuse(instance, "%s is set, not computed: it has no derivative",
                         limits[reference].name);
}

static int is_variable_now(Instance *instance, unsigned reference) {
  if (!instance_knows(reference, REAL))
    return instance_refuse(instance, "no real variable has the value reference %u", reference);
  return limits[reference].settable == SET_INPUT ||
         (limits[reference].settable != SET_NEVER && instance->now.phase == INITIALIZING) ||
         instance_refuse(instance, "nothing can be differentiated by %s in this phase",
                         limits[reference].name);
}

static int are_legal(Instance *instance, const unsigned *unknowns, size_t nu, const unsigned *knowns,
                     size_t nk, const double *seed, const double *sensitivity) {
  if (!instance_may(instance, IN(INITIALIZING) | IN(STEPPING) | IN(TERMINATED), "differentiation"))
    return 0;
  if ((nu && !unknowns) || (nk && !knowns) || ((nu || nk) && (!seed || !sensitivity)))
    return instance_refuse(instance, "a null pointer for a derivative");
  for (size_t i = 0; i < nu; i++)
    if (!is_unknown(instance, unknowns[i])) return 0;
  for (size_t k = 0; k < nk; k++)
    if (!is_variable_now(instance, knowns[k])) return 0;
  return 1;
}

static int are_sensitivities_finite(Instance *instance, const double *sensitivity, size_t n) {
  for (size_t i = 0; i < n; i++)
    if (!isfinite(sensitivity[i]))
      return instance_refuse(instance, "derivative %lu does not exist at the present values",
                             (unsigned long)i);
  return 1;
}

int derivative_directional(Instance *instance, const unsigned *unknowns, size_t nu,
                           const unsigned *knowns, size_t nk, const double *seed,
                           double *sensitivity) {
  if (!are_legal(instance, unknowns, nu, knowns, nk, seed, sensitivity)) return 0;
  for (size_t i = 0; i < nu; i++) sensitivity[i] = 0.0;
  for (size_t k = 0, s = 0; k < nk; k++)
    for (unsigned e = 0; e < instance_count(knowns[k]); e++, s++) {
      Stencil stencil;
      stretch(instance, knowns[k] + e, &stencil);
      for (size_t i = 0; i < nu; i++) sensitivity[i] += partial(&stencil, unknowns[i]) * seed[s];
    }
  return are_sensitivities_finite(instance, sensitivity, nu);
}

int derivative_adjoint(Instance *instance, const unsigned *unknowns, size_t nu,
                       const unsigned *knowns, size_t nk, const double *seed, double *sensitivity) {
  if (!are_legal(instance, unknowns, nu, knowns, nk, seed, sensitivity)) return 0;
  size_t s = 0;
  for (size_t k = 0; k < nk; k++)
    for (unsigned e = 0; e < instance_count(knowns[k]); e++, s++) {
      Stencil stencil;
      stretch(instance, knowns[k] + e, &stencil);
      sensitivity[s] = 0.0;
      for (size_t i = 0; i < nu; i++) sensitivity[s] += partial(&stencil, unknowns[i]) * seed[i];
    }
  return are_sensitivities_finite(instance, sensitivity, s);
}
