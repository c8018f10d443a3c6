/* FMI 2.0 co-simulation: FMI and no physics. */
#include "core.h"
#include "fmi2Functions.h"
#include "limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED } Phase;

typedef struct {
  Core core;
  Phase phase;
  double time;
  double start;
  double stop;
  int stop_defined;
  const fmi2CallbackFunctions *callbacks;
  int logging;
  char name[256];
} Instance;

/* What a saved state holds: no pointers, and a version. */
typedef struct {
  char version[64];
  Core core;
  Phase phase;
  double time, start, stop;
  int stop_defined;
} Snapshot;

static void report(const Instance *instance, const char *text) {
  if (instance->callbacks && instance->callbacks->logger)
    instance->callbacks->logger(instance->callbacks->componentEnvironment, instance->name, fmi2Error,
                                "logStatusError", text);
}

static fmi2Status fail(const Instance *instance, const char *what) {
  report(instance, what);
  return fmi2Error;
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible,
                              fmi2Boolean logging) {
  (void)resources;
  (void)visible;
  Instance *instance = calloc(1, sizeof *instance);
  if (!instance) return NULL;
  instance->callbacks = callbacks;
  instance->logging = logging;
  snprintf(instance->name, sizeof instance->name, "%s", name ? name : "");
  if (type != fmi2CoSimulation || !guid || strcmp(guid, model_guid) != 0) {
    report(instance, type != fmi2CoSimulation ? "only co-simulation is supported"
                                              : "the GUID is not that of this model");
    free(instance);
    return NULL;
  }
  core_reset(&instance->core);
  return instance;
}

void fmi2FreeInstance(fmi2Component c) { free(c); }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n,
                               const fmi2String categories[]) {
  (void)n;
  (void)categories;
  ((Instance *)c)->logging = on;
  return fmi2OK;
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
  (void)tolerance_defined;
  (void)tolerance;
  Instance *instance = c;
  if (instance->phase != INSTANTIATED)
    return fail(instance, "fmi2SetupExperiment is legal only before initialization");
  instance->start = start;
  instance->stop = stop;
  instance->stop_defined = stop_defined;
  return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  Instance *instance = c;
  if (instance->phase != INSTANTIATED)
    return fail(instance, "fmi2EnterInitializationMode is legal only once, after instantiation");
  instance->phase = INITIALIZING;
  return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  Instance *instance = c;
  if (instance->phase != INITIALIZING)
    return fail(instance, "fmi2ExitInitializationMode is legal only in initialization");
  core_initialize(&instance->core, instance->start);
  instance->time = instance->start;
  instance->phase = STEPPING;
  return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component c) {
  ((Instance *)c)->phase = TERMINATED;
  return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component c) {
  Instance *instance = c;
  core_reset(&instance->core);
  instance->phase = INSTANTIATED;
  instance->start = instance->time = 0.0;
  instance->stop_defined = 0;
  return fmi2OK;
}

static fmi2Status out_of_range(const Instance *instance, const char *call, unsigned reference) {
  char text[160];
  snprintf(text, sizeof text, "%s: there is no such variable: value reference %u", call, reference);
  return fail(instance, text);
}

static int is_known(unsigned reference, int integer) {
  return reference < MODEL_VARIABLES && limits[reference].integer == integer;
}

static fmi2Status get(Instance *instance, const char *call, unsigned reference, int integer,
                      double *value) {
  if (!is_known(reference, integer)) return out_of_range(instance, call, reference);
  core_refresh(&instance->core);
  *value = instance->core.v[reference];
  return fmi2OK;
}

static fmi2Status set(Instance *instance, const char *call, unsigned reference, int integer,
                      double value) {
  if (!is_known(reference, integer)) return out_of_range(instance, call, reference);
  const Limits *limit = &limits[reference];
  char text[512];
  if (limit->settable == SET_NEVER ||
      (limit->settable == SET_PARAMETER && instance->phase >= STEPPING)) {
    snprintf(text, sizeof text, "%s: %s can't be set %s", call, limit->name,
             limit->settable == SET_NEVER ? "at all" : "after initialization");
    return fail(instance, text);
  }
  if (!(value >= limit->minimum && value <= limit->maximum)) { /* catches NaN */
    snprintf(text, sizeof text, "%s: %s = %.17g is outside its range from %g to %g", call,
             limit->name, value, limit->minimum, limit->maximum);
    return fail(instance, text);
  }
  instance->core.v[reference] = value;
  instance->core.outputs_fresh = 0;
  return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
  for (size_t i = 0; i < n; i++)
    if (get(c, "fmi2GetReal", vr[i], 0, &value[i]) != fmi2OK) return fmi2Error;
  return fmi2OK;
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          fmi2Integer value[]) {
  for (size_t i = 0; i < n; i++) {
    double number;
    if (get(c, "fmi2GetInteger", vr[i], 1, &number) != fmi2OK) return fmi2Error;
    value[i] = (fmi2Integer)number;
  }
  return fmi2OK;
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          fmi2Boolean value[]) {
  (void)value;
  return n ? out_of_range(c, "fmi2GetBoolean", vr[0]) : fmi2OK;
}

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                         fmi2String value[]) {
  (void)value;
  return n ? out_of_range(c, "fmi2GetString", vr[0]) : fmi2OK;
}

/* Dependent parameters and start values follow the settable ones until the first tick. */
static fmi2Status settled(Instance *instance, fmi2Status status) {
  if (instance->phase < STEPPING) core_settle(&instance->core);
  return status;
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                       const fmi2Real value[]) {
  fmi2Status status = fmi2OK;
  for (size_t i = 0; i < n && status == fmi2OK; i++)
    status = set(c, "fmi2SetReal", vr[i], 0, value[i]);
  return settled(c, status);
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          const fmi2Integer value[]) {
  fmi2Status status = fmi2OK;
  for (size_t i = 0; i < n && status == fmi2OK; i++)
    status = set(c, "fmi2SetInteger", vr[i], 1, (double)value[i]);
  return settled(c, status);
}

fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          const fmi2Boolean value[]) {
  (void)value;
  return n ? out_of_range(c, "fmi2SetBoolean", vr[0]) : fmi2OK;
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                         const fmi2String value[]) {
  (void)value;
  return n ? out_of_range(c, "fmi2SetString", vr[0]) : fmi2OK;
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_rollback) {
  (void)no_rollback;
  Instance *instance = c;
  if (instance->phase != STEPPING) return fail(instance, "fmi2DoStep is legal only after initialization");
  if (!(step > 0.0) || !(time + step < 1e15))
    return fail(instance, "fmi2DoStep: the communication step must be positive and finite");
  double slack = 1e-9 * (1.0 + (time < 0 ? -time : time));
  if (time - instance->time > slack || instance->time - time > slack) {
    char text[160];
    snprintf(text, sizeof text, "fmi2DoStep: the communication point is %.17g, expected %.17g", time,
             instance->time);
    return fail(instance, text);
  }
  if (instance->stop_defined && time + step > instance->stop + slack) {
    char text[160];
    snprintf(text, sizeof text, "fmi2DoStep: %.17g lies beyond the stop time %.17g", time + step,
             instance->stop);
    return fail(instance, text);
  }
  core_advance(&instance->core, time + step);
  instance->time = time + step;
  return fmi2OK;
}

static void save(const Instance *instance, Snapshot *snapshot) {
  memset(snapshot, 0, sizeof *snapshot);
  snprintf(snapshot->version, sizeof snapshot->version, "%s", model_guid);
  snapshot->core = instance->core;
  snapshot->phase = instance->phase;
  snapshot->time = instance->time;
  snapshot->start = instance->start;
  snapshot->stop = instance->stop;
  snapshot->stop_defined = instance->stop_defined;
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) {
  if (!*state) *state = malloc(sizeof(Snapshot));
  if (!*state) return fail(c, "fmi2GetFMUstate: out of memory");
  save(c, *state);
  return fmi2OK;
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  Instance *instance = c;
  const Snapshot *snapshot = state;
  if (!snapshot || strcmp(snapshot->version, model_guid) != 0)
    return fail(instance, "fmi2SetFMUstate: the state is not one of this model");
  instance->core = snapshot->core;
  instance->phase = snapshot->phase;
  instance->time = snapshot->time;
  instance->start = snapshot->start;
  instance->stop = snapshot->stop;
  instance->stop_defined = snapshot->stop_defined;
  return fmi2OK;
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
  (void)c;
  if (state) {
    free(*state);
    *state = NULL;
  }
  return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
  (void)c;
  (void)state;
  *size = sizeof(Snapshot);
  return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  if (!state || size < sizeof(Snapshot))
    return fail(c, "fmi2SerializeFMUstate: no state, or too little room for it");
  memcpy(bytes, state, sizeof(Snapshot));
  return fmi2OK;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
  if (size != sizeof(Snapshot)) return fail(c, "fmi2DeSerializeFMUstate: not a state of this model");
  if (!*state) *state = malloc(sizeof(Snapshot));
  if (!*state) return fail(c, "fmi2DeSerializeFMUstate: out of memory");
  memcpy(*state, bytes, sizeof(Snapshot));
  return fmi2OK;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t nu,
                                        const fmi2ValueReference known[], size_t nk,
                                        const fmi2Real seed[], fmi2Real sensitivity[]) {
  (void)unknown, (void)nu, (void)known, (void)nk, (void)seed, (void)sensitivity;
  return fail(c, "fmi2GetDirectionalDerivative is not supported");
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                       const fmi2Integer order[], const fmi2Real value[]) {
  (void)vr, (void)n, (void)order, (void)value;
  return fail(c, "fmi2SetRealInputDerivatives is not supported");
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                        const fmi2Integer order[], fmi2Real value[]) {
  (void)vr, (void)n, (void)order, (void)value;
  return fail(c, "fmi2GetRealOutputDerivatives is not supported");
}

fmi2Status fmi2CancelStep(fmi2Component c) { return fail(c, "no step is pending"); }

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  *value = ((Instance *)c)->time;
  return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value) {
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = ((Instance *)c)->phase == TERMINATED;
  return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String *value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}
