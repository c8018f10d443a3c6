/* FMI 3.0 co-simulation: translates calls, knows no physics. */
#include "fmi3Functions.h"

#include "derivative.h"
#include "instance.h"
#include "snapshot.h"

#include <stdlib.h>

typedef struct {
  Instance instance;
  fmi3IntermediateUpdateCallback update;
  fmi3Boolean may_return_early;
} Component;

static fmi3Status status(int success) { return success ? fmi3OK : fmi3Error; }
static const fmi3Status told_as[LOG_CATEGORIES] = {fmi3Error, fmi3Discard, fmi3OK};

static void tell(const Listener *listener, const char *name, Category category, const char *message) {
  fmi3LogMessageCallback logger = (fmi3LogMessageCallback)listener->logger;
  (void)name;
  logger(listener->environment, told_as[category], log_categories[category], message);
}

const char *fmi3GetVersion(void) { return fmi3Version; }

static void *refuse_instance(const Listener *listener, const char *message) {
  if (listener->logger) tell(listener, "", LOG_ERROR, message);
  return NULL;
}

static int are_updated(const fmi3ValueReference references[], size_t n) {
  for (size_t i = 0; i < n; i++)
    if (!references || !(instance_knows(references[i], REAL) || instance_knows(references[i], BOOLEAN)))
      return 0;
  return 1;
}

fmi3Instance fmi3InstantiateCoSimulation(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
    fmi3Boolean events, fmi3Boolean early_return, const fmi3ValueReference intermediate[],
    size_t intermediates, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3IntermediateUpdateCallback update) {
  (void)resources, (void)visible;
  Listener listener = {tell, environment, (void (*)(void))log};
  if (events) return refuse_instance(&listener, "event mode is not supported");
  if (!are_updated(intermediate, intermediates))
    return refuse_instance(&listener, "a required intermediate variable is neither real nor Boolean");
  Component *component = instance_create(sizeof *component, name, token, MODEL_VARIABLES + 1,
                                         &listener, logging);
  if (!component) return NULL;
  component->update = update;
  component->may_return_early = early_return;
  return component;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log) {
  (void)name, (void)token, (void)resources, (void)visible, (void)logging;
  Listener listener = {tell, environment, (void (*)(void))log};
  return refuse_instance(&listener, "only co-simulation is supported");
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback update,
                                               fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock) {
  (void)name, (void)token, (void)resources, (void)visible, (void)logging;
  (void)update, (void)lock, (void)unlock;
  Listener listener = {tell, environment, (void (*)(void))log};
  return refuse_instance(&listener, "only co-simulation is supported");
}

void fmi3FreeInstance(fmi3Instance c) { free(c); }

fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t n, const fmi3String categories[]) {
  return status(instance_log(c, on, n, categories));
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

fmi3Status fmi3Terminate(fmi3Instance c) { return status(instance_terminate(c)); }
fmi3Status fmi3Reset(fmi3Instance c) { return status(instance_reset(c)); }

/* Whether as many values are given as the variables have; a refusal names an array. */
static int are_as_many(fmi3Instance c, const fmi3ValueReference vr[], size_t n, size_t given) {
  unsigned long expected = 0, first = 0, last = 0;
  for (size_t i = 0; i < n; i++) {
    const unsigned count = vr ? instance_count(vr[i]) : 1;
    if (count > 1) last = (first = vr[i]) + count - 1;
    expected += count;
  }
  return expected == given ||
         instance_refuse(c, first == last ? "%lu values were given, expected %lu"
                                          : "%lu values were given, expected %lu, with those from %s to %s",
                         (unsigned long)given, expected, limits[first].name, limits[last].name);
}

static fmi3Status set(fmi3Instance c, const fmi3ValueReference vr[], size_t n, Kind kind,
                      const void *value, size_t values) {
  Answer answer = are_as_many(c, vr, n, values) ? instance_set(c, vr, n, kind, value) : REFUSED;
  return answer == DISCARDED ? fmi3Discard : status(answer == DONE);
}

#define VARIABLES(Type, kind)                                                                         \
  fmi3Status fmi3Get##Type(fmi3Instance c, const fmi3ValueReference vr[], size_t n,                  \
                           fmi3##Type value[], size_t values) {                                      \
    return status(are_as_many(c, vr, n, values) && instance_get(c, vr, n, kind, value));             \
  }                                                                                                   \
  fmi3Status fmi3Set##Type(fmi3Instance c, const fmi3ValueReference vr[], size_t n,                  \
                           const fmi3##Type value[], size_t values) {                                \
    return set(c, vr, n, kind, value, values);                                                       \
  }

VARIABLES(Float64, REAL)
VARIABLES(Int32, INTEGER)
VARIABLES(Boolean, BOOLEAN)

/* Kinds of variables that the model does not have. */
static fmi3Status none(fmi3Instance c, size_t n, unsigned phases, const char *call) {
  if (!instance_may(c, phases, call)) return fmi3Error;
  return n ? status(instance_refuse(c, "there are no variables for %s", call)) : fmi3OK;
}

#define NO_VARIABLES(Kind)                                                                            \
  fmi3Status fmi3Get##Kind(fmi3Instance c, const fmi3ValueReference vr[], size_t n,                  \
                           fmi3##Kind value[], size_t values) {                                      \
    (void)vr, (void)value;                                                                           \
    return none(c, n | values, READABLE, "fmi3Get" #Kind);                                           \
  }                                                                                                   \
  fmi3Status fmi3Set##Kind(fmi3Instance c, const fmi3ValueReference vr[], size_t n,                  \
                           const fmi3##Kind value[], size_t values) {                                \
    (void)vr, (void)value;                                                                           \
    return none(c, n | values, SETTABLE, "fmi3Set" #Kind);                                           \
  }

NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(String)

fmi3Status fmi3GetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, size_t sizes[],
                         fmi3Binary value[], size_t values) {
  (void)vr, (void)sizes, (void)value;
  return none(c, n | values, READABLE, "fmi3GetBinary");
}

fmi3Status fmi3SetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const size_t sizes[],
                         const fmi3Binary value[], size_t values) {
  (void)vr, (void)sizes, (void)value;
  return none(c, n | values, SETTABLE, "fmi3SetBinary");
}

fmi3Status fmi3GetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Clock value[]) {
  (void)vr, (void)value;
  return none(c, n, READABLE, "fmi3GetClock");
}

fmi3Status fmi3SetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n,
                        const fmi3Clock value[]) {
  (void)vr, (void)value;
  return none(c, n, SETTABLE, "fmi3SetClock");
}

/* Every tick within a step is an intermediate update, at which inputs can be set from there on,
   variables can be read and the step can be cut short: at the tick, or at a later time before the
   end. */
static void between(Instance *instance, double *end) {
  const Component *component = (const Component *)instance;
  fmi3Boolean requested = fmi3False;
  fmi3Float64 until = instance->now.time;
  component->update(instance->listener.environment, instance->now.time, fmi3True, fmi3True, fmi3True,
                    component->may_return_early, &requested, &until);
  if (requested && component->may_return_early && until < *end)
    *end = until > instance->now.time ? until : instance->now.time;
}

fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 time, fmi3Float64 step, fmi3Boolean no_rollback,
                      fmi3Boolean *event_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
                      fmi3Float64 *last_time) {
  (void)no_rollback;
  const Component *component = c;
  if (!component) return fmi3Error;
  if (!event_needed || !terminate || !early_return || !last_time)
    return status(instance_refuse(c, "a null pointer for a result of a step"));
  int success = instance_step(c, time, step, component->update ? between : NULL);
  *event_needed = *terminate = fmi3False;
  *last_time = component->instance.now.time;
  *early_return = success && *last_time < time + step;
  return status(success);
}

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state) {
  return status(snapshot_save(c, state));
}

fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) {
  return status(snapshot_restore(c, state));
}

fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state) {
  return status(snapshot_free(c, state));
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size) {
  return status(snapshot_size(c, state, size));
}

fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
  return status(snapshot_serialize(c, state, bytes, size));
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size,
                                   fmi3FMUState *state) {
  return status(snapshot_deserialize(c, bytes, size, state));
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const fmi3ValueReference unknowns[], size_t nu,
                                        const fmi3ValueReference knowns[], size_t nk,
                                        const fmi3Float64 seed[], size_t seeds,
                                        fmi3Float64 sensitivity[], size_t n) {
  return status(are_as_many(c, knowns, nk, seeds) && are_as_many(c, unknowns, nu, n) &&
                derivative_directional(c, unknowns, nu, knowns, nk, seed, sensitivity));
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance c, const fmi3ValueReference unknowns[], size_t nu,
                                    const fmi3ValueReference knowns[], size_t nk,
                                    const fmi3Float64 seed[], size_t seeds, fmi3Float64 sensitivity[],
                                    size_t n) {
  return status(are_as_many(c, unknowns, nu, seeds) && are_as_many(c, knowns, nk, n) &&
                derivative_adjoint(c, unknowns, nu, knowns, nk, seed, sensitivity));
}

/* What belongs to model exchange, clocks, events, structural parameters and interpolation: legal in
   no phase of this component. */
#define UNSUPPORTED(name, ...)                                                                        \
  fmi3Status name(fmi3Instance c, __VA_ARGS__) { return status(instance_may(c, 0, #name)); }
#define UNSUPPORTED_PLAIN(name)                                                                       \
  fmi3Status name(fmi3Instance c) { return status(instance_may(c, 0, #name)); }

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
