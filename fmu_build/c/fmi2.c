/* FMI 2.0 co-simulation: translates calls, knows no physics. */
#include "fmi2Functions.h"

#include "derivative.h"
#include "inputs.h"
#include "instance.h"
#include "snapshot.h"

#include <stdlib.h>

static fmi2Status status(int success) { return success ? fmi2OK : fmi2Error; }

static fmi2Status answered(Answer answer) {
  return answer == DISCARDED ? fmi2Discard : status(answer == DONE);
}

static const fmi2Status told_as[LOG_CATEGORIES] = {fmi2Error, fmi2Discard, fmi2OK};

/* The message goes as the format itself, since many importers show it unformatted; a per cent
   sign, which only a caller's own text could bring in, would be a conversion to the others. */
static void tell(const Listener *listener, const char *name, Category category, const char *message) {
  fmi2CallbackLogger logger = (fmi2CallbackLogger)listener->logger;
  char text[512];
  size_t i = 0;
  for (; message[i] && i < sizeof text - 1; i++) text[i] = message[i] == '%' ? '_' : message[i];
  text[i] = '\0';
  logger(listener->environment, name, told_as[category], log_categories[category], text);
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible,
                              fmi2Boolean logging) {
  (void)resources, (void)visible;
  Listener listener = {tell, NULL, NULL};
  if (callbacks) {
    listener.environment = callbacks->componentEnvironment;
    listener.logger = (void (*)(void))callbacks->logger;
  }
  if (type == fmi2CoSimulation)
    return instance_create(sizeof(Instance), name, guid, MODEL_VARIABLES, &listener, logging);
  if (listener.logger) tell(&listener, name, LOG_ERROR, "only co-simulation is supported");
  return NULL;
}

void fmi2FreeInstance(fmi2Component c) { free(c); }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n,
                               const fmi2String categories[]) {
  return status(instance_log(c, on, n, categories));
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
  (void)tolerance_defined, (void)tolerance;
  return status(instance_setup(c, start, stop_defined, stop));
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  return status(instance_enter_initialization(c));
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  return status(instance_exit_initialization(c));
}

fmi2Status fmi2Terminate(fmi2Component c) { return status(instance_terminate(c)); }
fmi2Status fmi2Reset(fmi2Component c) { return status(instance_reset(c)); }

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
  return status(instance_get(c, vr, n, REAL, value));
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          fmi2Integer value[]) {
  return status(instance_get(c, vr, n, INTEGER, value));
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                       const fmi2Real value[]) {
  return answered(instance_set(c, vr, n, REAL, value));
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          const fmi2Integer value[]) {
  return answered(instance_set(c, vr, n, INTEGER, value));
}

/* Kinds of variables that the model does not have. */
static fmi2Status none(fmi2Component c, size_t n, unsigned phases, const char *call) {
  if (!instance_may(c, phases, call)) return fmi2Error;
  return n ? status(instance_refuse(c, "there are no variables for %s", call)) : fmi2OK;
}

#define NO_VARIABLES(Kind)                                                                            \
  fmi2Status fmi2Get##Kind(fmi2Component c, const fmi2ValueReference vr[], size_t n,                 \
                           fmi2##Kind value[]) {                                                     \
    (void)vr, (void)value;                                                                           \
    return none(c, n, READABLE, "fmi2Get" #Kind);                                                    \
  }                                                                                                   \
  fmi2Status fmi2Set##Kind(fmi2Component c, const fmi2ValueReference vr[], size_t n,                 \
                           const fmi2##Kind value[]) {                                               \
    (void)vr, (void)value;                                                                           \
    return none(c, n, SETTABLE, "fmi2Set" #Kind);                                                    \
  }

NO_VARIABLES(Boolean)
NO_VARIABLES(String)

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_rollback) {
  (void)no_rollback;
  return status(instance_step(c, time, step, NULL));
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) {
  return status(snapshot_save(c, state));
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  return status(snapshot_restore(c, state));
}

fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
  return status(snapshot_free(c, state));
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
  return status(snapshot_size(c, state, size));
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  return status(snapshot_serialize(c, state, bytes, size));
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
  return status(snapshot_deserialize(c, bytes, size, state));
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknowns[], size_t nu,
                                        const fmi2ValueReference knowns[], size_t nk,
                                        const fmi2Real seed[], fmi2Real sensitivity[]) {
  return status(derivative_directional(c, unknowns, nu, knowns, nk, seed, sensitivity));
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                       const fmi2Integer order[], const fmi2Real value[]) {
  return status(inputs_set_slopes(c, vr, n, order, value));
}

/* Outputs are sampled: maxOutputDerivativeOrder is 0. */
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                        const fmi2Integer order[], fmi2Real value[]) {
  (void)vr, (void)order, (void)value;
  return none(c, n, READABLE & ~IN(INITIALIZING), "fmi2GetRealOutputDerivatives");
}

/* Steps are done when fmi2DoStep returns: none is ever pending. */
fmi2Status fmi2CancelStep(fmi2Component c) { return status(instance_may(c, 0, "fmi2CancelStep")); }

/* The standard's answer where there is nothing to tell is fmi2Discard. */
static fmi2Status discarded(fmi2Component c, const void *value) {
  if (!instance_may(c, READABLE & ~IN(INITIALIZING), "asking for a status")) return fmi2Error;
  return value ? fmi2Discard : status(instance_refuse(c, "a null pointer for a status"));
}

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value) {
  (void)kind;
  return discarded(c, value);
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
  fmi2Status answer = discarded(c, value);
  if (answer != fmi2Discard || kind != fmi2LastSuccessfulTime) return answer;
  *value = ((const Instance *)c)->now.time;
  return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value) {
  (void)kind;
  return discarded(c, value);
}

/* The gyro never asks for the end of the simulation. */
fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value) {
  fmi2Status answer = discarded(c, value);
  if (answer != fmi2Discard || kind != fmi2Terminated) return answer;
  *value = fmi2False;
  return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String *value) {
  (void)kind;
  return discarded(c, value);
}
