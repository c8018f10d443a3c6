/* FMI 2.0 co-simulation: translates calls, knows no physics. */
#include "fmi2Functions.h"
#include "instance.h"

#include <stdlib.h>
#include <string.h>

static fmi2Status status(int success) { return success ? fmi2OK : fmi2Error; }

/* The message goes as the format itself, since many importers show it unformatted; a per cent
   sign, which only a caller's own text could bring in, would be a conversion to the others. */
static void report(void *context, const char *name, const char *message) {
  const fmi2CallbackFunctions *callbacks = context;
  if (!callbacks || !callbacks->logger) return;
  char text[512];
  size_t i = 0;
  for (; message[i] && i < sizeof text - 1; i++) text[i] = message[i] == '%' ? '_' : message[i];
  text[i] = '\0';
  callbacks->logger(callbacks->componentEnvironment, name, fmi2Error, "logStatusError", text);
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible,
                              fmi2Boolean logging) {
  (void)resources, (void)visible, (void)logging;
  if (type != fmi2CoSimulation) {
    report((void *)callbacks, name ? name : "", "only co-simulation is supported");
    return NULL;
  }
  return instance_create(name, guid, report, (void *)callbacks);
}

void fmi2FreeInstance(fmi2Component c) { free(c); }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n,
                               const fmi2String categories[]) {
  (void)on;
  for (size_t i = 0; i < n; i++)
    if (strcmp(categories[i], "logStatusError") != 0)
      return status(instance_refuse(c, "there is no log category %s", categories[i]));
  return fmi2OK;
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

fmi2Status fmi2Terminate(fmi2Component c) {
  ((Instance *)c)->now.phase = TERMINATED;
  return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component c) {
  instance_reset(c);
  return fmi2OK;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
  for (size_t i = 0; i < n; i++)
    if (!instance_get(c, vr[i], 0, &value[i])) return fmi2Error;
  return fmi2OK;
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          fmi2Integer value[]) {
  for (size_t i = 0; i < n; i++) {
    double number;
    if (!instance_get(c, vr[i], 1, &number)) return fmi2Error;
    value[i] = (fmi2Integer)number;
  }
  return fmi2OK;
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                       const fmi2Real value[]) {
  int success = 1;
  for (size_t i = 0; i < n && success; i++) success = instance_set(c, vr[i], 0, value[i]);
  instance_settle(c);
  return status(success);
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          const fmi2Integer value[]) {
  int success = 1;
  for (size_t i = 0; i < n && success; i++) success = instance_set(c, vr[i], 1, value[i]);
  instance_settle(c);
  return status(success);
}

static fmi2Status none_of_this_kind(fmi2Component c, size_t n, const char *kind) {
  return n ? status(instance_refuse(c, "there are no %s variables", kind)) : fmi2OK;
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          fmi2Boolean value[]) {
  (void)vr, (void)value;
  return none_of_this_kind(c, n, "boolean");
}

fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                          const fmi2Boolean value[]) {
  (void)vr, (void)value;
  return none_of_this_kind(c, n, "boolean");
}

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                         fmi2String value[]) {
  (void)vr, (void)value;
  return none_of_this_kind(c, n, "string");
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                         const fmi2String value[]) {
  (void)vr, (void)value;
  return none_of_this_kind(c, n, "string");
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_rollback) {
  (void)no_rollback;
  return status(instance_step(c, time, step));
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) {
  Snapshot *saved = instance_save(c, *state);
  if (saved) *state = saved;
  return status(saved != NULL);
}

fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  return status(instance_restore(c, state));
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
  (void)c, (void)state;
  *size = sizeof(Snapshot);
  return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  if (!state || size < sizeof(Snapshot))
    return status(instance_refuse(c, "no state to serialize, or too little room for it"));
  memcpy(bytes, state, sizeof(Snapshot));
  return fmi2OK;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
  if (size != sizeof(Snapshot))
    return status(instance_refuse(c, "%u bytes are no state of this model", (unsigned)size));
  Snapshot *saved = instance_save(c, *state);
  if (!saved) return fmi2Error;
  memcpy(saved, bytes, sizeof *saved);
  *state = saved;
  return fmi2OK;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t nu,
                                        const fmi2ValueReference known[], size_t nk,
                                        const fmi2Real seed[], fmi2Real sensitivity[]) {
  (void)unknown, (void)nu, (void)known, (void)nk, (void)seed, (void)sensitivity;
  return status(instance_refuse(c, "directional derivatives are not supported"));
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                       const fmi2Integer order[], const fmi2Real value[]) {
  (void)vr, (void)n, (void)order, (void)value;
  return status(instance_refuse(c, "input derivatives are not supported"));
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                        const fmi2Integer order[], fmi2Real value[]) {
  (void)vr, (void)n, (void)order, (void)value;
  return status(instance_refuse(c, "output derivatives are not supported"));
}

fmi2Status fmi2CancelStep(fmi2Component c) {
  return status(instance_refuse(c, "steps are never pending"));
}

fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}

fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  *value = ((Instance *)c)->now.time;
  return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value) {
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = ((Instance *)c)->now.phase == TERMINATED;
  return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String *value) {
  (void)c, (void)kind, (void)value;
  return fmi2Discard;
}
