/* FMI 3.0 co-simulation: translates calls, knows no physics. */
#include "fmi3Functions.h"
#include "instance.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  fmi3InstanceEnvironment environment;
  fmi3LogMessageCallback log;
} Logger;

/* The instance comes first, so that either pointer serves. */
typedef struct {
  Instance instance;
  Logger logger;
} Component;

static fmi3Status status(int success) { return success ? fmi3OK : fmi3Error; }

static void report(void *context, const char *name, const char *message) {
  const Logger *logger = context;
  (void)name;
  if (logger && logger->log)
    logger->log(logger->environment, fmi3Error, "logStatusError", message);
}

static fmi3Status refuse(fmi3Instance c, const char *what) {
  return status(instance_refuse(c, "%s is not supported", what));
}

const char *fmi3GetVersion(void) { return fmi3Version; }

fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
    fmi3Boolean events, fmi3Boolean early_return, const fmi3ValueReference intermediate[],
    size_t intermediates, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3IntermediateUpdateCallback update) {
  (void)resources, (void)visible, (void)logging, (void)early_return, (void)intermediate, (void)update;
  Logger logger = {environment, log};
  if (events || intermediates) {
    report(&logger, name, "event mode and intermediate variables are not supported");
    return NULL;
  }
  Instance *checked = instance_create(name, token, report, &logger);
  if (!checked) return NULL;
  Component *component = calloc(1, sizeof *component);
  if (component) {
    component->instance = *checked;
    component->logger = logger;
    component->instance.context = &component->logger;
  }
  free(checked);
  return component;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log) {
  (void)token, (void)resources, (void)visible, (void)logging;
  Logger logger = {environment, log};
  report(&logger, name, "only co-simulation is supported");
  return NULL;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback update,
                                               fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock) {
  (void)token, (void)resources, (void)visible, (void)logging, (void)update, (void)lock, (void)unlock;
  Logger logger = {environment, log};
  report(&logger, name, "only co-simulation is supported");
  return NULL;
}

void fmi3FreeInstance(fmi3Instance c) { free(c); }

fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t n, const fmi3String categories[]) {
  (void)on;
  for (size_t i = 0; i < n; i++)
    if (strcmp(categories[i], "logStatusError") != 0)
      return status(instance_refuse(c, "there is no log category %s", categories[i]));
  return fmi3OK;
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean tolerance_defined,
                                       fmi3Float64 tolerance, fmi3Float64 start,
                                       fmi3Boolean stop_defined, fmi3Float64 stop) {
  (void)tolerance_defined, (void)tolerance;
  return status(instance_setup(c, start, stop_defined, stop) && instance_enter_initialization(c));
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
  return status(instance_exit_initialization(c));
}

fmi3Status fmi3Terminate(fmi3Instance c) {
  ((Instance *)c)->now.phase = TERMINATED;
  return fmi3OK;
}

fmi3Status fmi3Reset(fmi3Instance c) {
  instance_reset(c);
  return fmi3OK;
}

static int same_size(fmi3Instance c, size_t references, size_t values) {
  return references == values ||
         instance_refuse(c, "%u values for %u scalar variables", (unsigned)values, (unsigned)references);
}

fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Float64 value[],
                          size_t values) {
  int success = same_size(c, n, values);
  for (size_t i = 0; i < n && success; i++) success = instance_get(c, vr[i], 0, &value[i]);
  return status(success);
}

fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n,
                          const fmi3Float64 value[], size_t values) {
  int success = same_size(c, n, values);
  for (size_t i = 0; i < n && success; i++) success = instance_set(c, vr[i], 0, value[i]);
  instance_settle(c);
  return status(success);
}

fmi3Status fmi3GetInt32(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Int32 value[],
                        size_t values) {
  int success = same_size(c, n, values);
  for (size_t i = 0; i < n && success; i++) {
    double number = 0.0;
    success = instance_get(c, vr[i], 1, &number);
    if (success) value[i] = (fmi3Int32)number;
  }
  return status(success);
}

fmi3Status fmi3SetInt32(fmi3Instance c, const fmi3ValueReference vr[], size_t n,
                        const fmi3Int32 value[], size_t values) {
  int success = same_size(c, n, values);
  for (size_t i = 0; i < n && success; i++) success = instance_set(c, vr[i], 1, value[i]);
  instance_settle(c);
  return status(success);
}

/* Kinds of variables that the model does not have. */
#define NO_VARIABLES(Kind)                                                                            \
  fmi3Status fmi3Get##Kind(fmi3Instance c, const fmi3ValueReference vr[], size_t n,                  \
                           fmi3##Kind value[], size_t values) {                                      \
    (void)vr, (void)value, (void)values;                                                             \
    return n ? refuse(c, "a " #Kind " variable") : fmi3OK;                                           \
  }                                                                                                   \
  fmi3Status fmi3Set##Kind(fmi3Instance c, const fmi3ValueReference vr[], size_t n,                  \
                           const fmi3##Kind value[], size_t values) {                                \
    (void)vr, (void)value, (void)values;                                                             \
    return n ? refuse(c, "a " #Kind " variable") : fmi3OK;                                           \
  }

NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

fmi3Status fmi3GetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, size_t sizes[],
                         fmi3Binary value[], size_t values) {
  (void)vr, (void)sizes, (void)value, (void)values;
  return n ? refuse(c, "a Binary variable") : fmi3OK;
}

fmi3Status fmi3SetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const size_t sizes[],
                         const fmi3Binary value[], size_t values) {
  (void)vr, (void)sizes, (void)value, (void)values;
  return n ? refuse(c, "a Binary variable") : fmi3OK;
}

fmi3Status fmi3GetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Clock value[]) {
  (void)vr, (void)value;
  return n ? refuse(c, "a Clock variable") : fmi3OK;
}

fmi3Status fmi3SetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n,
                        const fmi3Clock value[]) {
  (void)vr, (void)value;
  return n ? refuse(c, "a Clock variable") : fmi3OK;
}

fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 time, fmi3Float64 step, fmi3Boolean no_rollback,
                      fmi3Boolean *event_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
                      fmi3Float64 *last_time) {
  (void)no_rollback;
  int success = instance_step(c, time, step);
  *event_needed = *terminate = *early_return = fmi3False;
  *last_time = ((Instance *)c)->now.time;
  return status(success);
}

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state) {
  Snapshot *saved = instance_save(c, *state);
  if (saved) *state = saved;
  return status(saved != NULL);
}

fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) {
  return status(instance_restore(c, state));
}

fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state) {
  (void)c;
  if (state) {
    free(*state);
    *state = NULL;
  }
  return fmi3OK;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size) {
  (void)c, (void)state;
  *size = sizeof(Snapshot);
  return fmi3OK;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
  if (!state || size < sizeof(Snapshot))
    return status(instance_refuse(c, "no state to serialize, or too little room for it"));
  memcpy(bytes, state, sizeof(Snapshot));
  return fmi3OK;
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size,
                                   fmi3FMUState *state) {
  if (size != sizeof(Snapshot))
    return status(instance_refuse(c, "%u bytes are no state of this model", (unsigned)size));
  Snapshot *saved = instance_save(c, *state);
  if (!saved) return fmi3Error;
  memcpy(saved, bytes, sizeof *saved);
  *state = saved;
  return fmi3OK;
}

/* What belongs to model exchange, clocks, events and derivatives. */
#define UNSUPPORTED(name, ...)                                                                        \
  fmi3Status name(fmi3Instance c, __VA_ARGS__) { return refuse(c, #name); }
#define UNSUPPORTED_PLAIN(name)                                                                       \
  fmi3Status name(fmi3Instance c) { return refuse(c, #name); }

#pragma GCC diagnostic ignored "-Wunused-parameter"

UNSUPPORTED_PLAIN(fmi3EnterEventMode)
UNSUPPORTED_PLAIN(fmi3EnterConfigurationMode)
UNSUPPORTED_PLAIN(fmi3ExitConfigurationMode)
UNSUPPORTED_PLAIN(fmi3EvaluateDiscreteStates)
UNSUPPORTED_PLAIN(fmi3EnterContinuousTimeMode)
UNSUPPORTED_PLAIN(fmi3EnterStepMode)
UNSUPPORTED(fmi3GetNumberOfVariableDependencies, fmi3ValueReference vr, size_t *n)
UNSUPPORTED(fmi3GetVariableDependencies, fmi3ValueReference vr, size_t elements[],
            fmi3ValueReference independents[], size_t independent_elements[],
            fmi3DependencyKind kinds[], size_t n)
UNSUPPORTED(fmi3GetDirectionalDerivative, const fmi3ValueReference unknowns[], size_t nu,
            const fmi3ValueReference knowns[], size_t nk, const fmi3Float64 seed[], size_t ns,
            fmi3Float64 sensitivity[], size_t n)
UNSUPPORTED(fmi3GetAdjointDerivative, const fmi3ValueReference unknowns[], size_t nu,
            const fmi3ValueReference knowns[], size_t nk, const fmi3Float64 seed[], size_t ns,
            fmi3Float64 sensitivity[], size_t n)
UNSUPPORTED(fmi3GetIntervalDecimal, const fmi3ValueReference vr[], size_t n, fmi3Float64 intervals[],
            fmi3IntervalQualifier qualifiers[])
UNSUPPORTED(fmi3GetIntervalFraction, const fmi3ValueReference vr[], size_t n, fmi3UInt64 counters[],
            fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
UNSUPPORTED(fmi3GetShiftDecimal, const fmi3ValueReference vr[], size_t n, fmi3Float64 shifts[])
UNSUPPORTED(fmi3GetShiftFraction, const fmi3ValueReference vr[], size_t n, fmi3UInt64 counters[],
            fmi3UInt64 resolutions[])
UNSUPPORTED(fmi3SetIntervalDecimal, const fmi3ValueReference vr[], size_t n,
            const fmi3Float64 intervals[])
UNSUPPORTED(fmi3SetIntervalFraction, const fmi3ValueReference vr[], size_t n,
            const fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
UNSUPPORTED(fmi3SetShiftDecimal, const fmi3ValueReference vr[], size_t n, const fmi3Float64 shifts[])
UNSUPPORTED(fmi3SetShiftFraction, const fmi3ValueReference vr[], size_t n, const fmi3UInt64 counters[],
            const fmi3UInt64 resolutions[])
UNSUPPORTED(fmi3UpdateDiscreteStates, fmi3Boolean *update, fmi3Boolean *terminate,
            fmi3Boolean *nominals, fmi3Boolean *values, fmi3Boolean *defined, fmi3Float64 *next)
UNSUPPORTED(fmi3CompletedIntegratorStep, fmi3Boolean no_rollback, fmi3Boolean *event,
            fmi3Boolean *terminate)
UNSUPPORTED(fmi3SetTime, fmi3Float64 time)
UNSUPPORTED(fmi3SetContinuousStates, const fmi3Float64 states[], size_t n)
UNSUPPORTED(fmi3GetContinuousStateDerivatives, fmi3Float64 derivatives[], size_t n)
UNSUPPORTED(fmi3GetEventIndicators, fmi3Float64 indicators[], size_t n)
UNSUPPORTED(fmi3GetContinuousStates, fmi3Float64 states[], size_t n)
UNSUPPORTED(fmi3GetNominalsOfContinuousStates, fmi3Float64 nominals[], size_t n)
UNSUPPORTED(fmi3GetNumberOfEventIndicators, size_t *n)
UNSUPPORTED(fmi3GetNumberOfContinuousStates, size_t *n)
UNSUPPORTED(fmi3GetOutputDerivatives, const fmi3ValueReference vr[], size_t n, const fmi3Int32 orders[],
            fmi3Float64 values[], size_t nv)
UNSUPPORTED(fmi3ActivateModelPartition, fmi3ValueReference clock, fmi3Float64 time)
