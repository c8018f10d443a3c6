/* The same calls in either FMI version (FMI = 2 or 3): 1 for OK, 0 for an error.
   F(name) is an FMI function: linked, or found in a library by who includes this.
   Kinds of variables are those of limits.h: 0 real, 1 integer, 2 Boolean. */
#ifndef DOOR_H
#define DOOR_H

#include <math.h>
#include <stddef.h>

#ifndef F
#define F(name) name
#endif

typedef unsigned Reference;
typedef void *Handle;

/* Defined by the user: is given every message. */
static void on_message(int is_error, const char *category, const char *message);

#if FMI == 2
#include "fmi2Functions.h"
#define IS_OK(call) ((call) == fmi2OK)

static void door_log(void *environment, fmi2String name, fmi2Status status, fmi2String category,
                     fmi2String message, ...) {
  (void)environment, (void)name;
  on_message(status != fmi2OK, category, message);
}
static const fmi2CallbackFunctions door_callbacks = {door_log, NULL, NULL, NULL, NULL};

static inline Handle door_create(const char *token, int logging) {
  return F(fmi2Instantiate)("fuzzed", fmi2CoSimulation, token, NULL, &door_callbacks, 0, logging);
}
static inline void door_free(Handle c) { F(fmi2FreeInstance)(c); }
static inline int door_initialize(Handle c, double start, int stop_defined, double stop) {
  return IS_OK(F(fmi2SetupExperiment)(c, 0, 0.0, start, stop_defined, stop)) &&
         IS_OK(F(fmi2EnterInitializationMode)(c));
}
static inline int door_exit(Handle c) { return IS_OK(F(fmi2ExitInitializationMode)(c)); }
static inline int door_terminate(Handle c) { return IS_OK(F(fmi2Terminate)(c)); }
static inline int door_reset(Handle c) { return IS_OK(F(fmi2Reset)(c)); }
/* How many values there are is not said in FMI 2: as many as variables. */
static inline int door_get_all(Handle c, const Reference *r, size_t n, int kind, void *values, size_t count) {
  (void)count;
  if (kind == 2) return IS_OK(F(fmi2GetBoolean)(c, r, n, values));
  return IS_OK(kind == 1 ? F(fmi2GetInteger)(c, r, n, values) : F(fmi2GetReal)(c, r, n, values));
}
static inline int door_set_all(Handle c, const Reference *r, size_t n, int kind, const void *values,
                               size_t count) {
  (void)count;
  if (kind == 2) return IS_OK(F(fmi2SetBoolean)(c, r, n, values));
  return IS_OK(kind == 1 ? F(fmi2SetInteger)(c, r, n, values) : F(fmi2SetReal)(c, r, n, values));
}
static inline int door_step(Handle c, double time, double step) { return IS_OK(F(fmi2DoStep)(c, time, step, 1)); }
static inline int door_save(Handle c, void **s) { return IS_OK(F(fmi2GetFMUstate)(c, s)); }
static inline int door_restore(Handle c, void *s) { return IS_OK(F(fmi2SetFMUstate)(c, s)); }
static inline int door_drop(Handle c, void **s) { return IS_OK(F(fmi2FreeFMUstate)(c, s)); }
static inline int door_size(Handle c, void *s, size_t *n) { return IS_OK(F(fmi2SerializedFMUstateSize)(c, s, n)); }
static inline int door_write(Handle c, void *s, void *bytes, size_t n) {
  return IS_OK(F(fmi2SerializeFMUstate)(c, s, bytes, n));
}
static inline int door_read(Handle c, const void *bytes, size_t n, void **s) {
  return IS_OK(F(fmi2DeSerializeFMUstate)(c, bytes, n, s));
}
static inline int door_derivative(Handle c, const Reference *u, size_t nu, const Reference *k, size_t nk,
                           const double *seed, size_t seeds, double *result) {
  (void)seeds;
  return IS_OK(F(fmi2GetDirectionalDerivative)(c, u, nu, k, nk, seed, result));
}
static inline int door_logging(Handle c, int on, size_t n, const char *const *categories) {
  return IS_OK(F(fmi2SetDebugLogging)(c, on, n, categories));
}
/* Calls that are never legal for this component. */
#define UNSUPPORTED_CALLS 4
static inline int door_unsupported(Handle c, int which) {
  Reference r = 0;
  double value = 0.0;
  fmi2Integer order = 1;
  fmi2Boolean flag = 0;
  fmi2String text = "";
  if (which == 0) return IS_OK(F(fmi2CancelStep)(c));
  if (which == 1) return IS_OK(F(fmi2SetRealInputDerivatives)(c, &r, 1, &order, &value));
  if (which == 2) return IS_OK(F(fmi2GetBoolean)(c, &r, 1, &flag));
  return IS_OK(F(fmi2GetString)(c, &r, 1, &text));
}

#else
#include "fmi3Functions.h"
#define IS_OK(call) ((call) == fmi3OK)

static void door_log(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
                     fmi3String message) {
  (void)environment;
  on_message(status != fmi3OK, category, message);
}

static inline Handle door_create(const char *token, int logging) {
  return F(fmi3InstantiateCoSimulation)("fuzzed", token, NULL, 0, logging, 0, 0, NULL, 0, NULL, door_log,
                                     NULL);
}
static inline void door_free(Handle c) { F(fmi3FreeInstance)(c); }
static inline int door_initialize(Handle c, double start, int stop_defined, double stop) {
  return IS_OK(F(fmi3EnterInitializationMode)(c, 0, 0.0, start, stop_defined, stop));
}
static inline int door_exit(Handle c) { return IS_OK(F(fmi3ExitInitializationMode)(c)); }
static inline int door_terminate(Handle c) { return IS_OK(F(fmi3Terminate)(c)); }
static inline int door_reset(Handle c) { return IS_OK(F(fmi3Reset)(c)); }
static inline int door_get_all(Handle c, const Reference *r, size_t n, int kind, void *values, size_t count) {
  if (kind == 2) return IS_OK(F(fmi3GetBoolean)(c, r, n, values, count));
  return IS_OK(kind == 1 ? F(fmi3GetInt32)(c, r, n, values, count) : F(fmi3GetFloat64)(c, r, n, values, count));
}
static inline int door_set_all(Handle c, const Reference *r, size_t n, int kind, const void *values,
                               size_t count) {
  if (kind == 2) return IS_OK(F(fmi3SetBoolean)(c, r, n, values, count));
  return IS_OK(kind == 1 ? F(fmi3SetInt32)(c, r, n, values, count) : F(fmi3SetFloat64)(c, r, n, values, count));
}
static inline int door_step(Handle c, double time, double step) {
  fmi3Boolean event, end, early;
  double last;
  if (!IS_OK(F(fmi3DoStep)(c, time, step, 1, &event, &end, &early, &last))) return 0;
  /* a begin that is early within the slack does not turn time back */
  return last >= time + step && last - (time + step) <= 1e-9 * (1.0 + fabs(last));
}
static inline int door_save(Handle c, void **s) { return IS_OK(F(fmi3GetFMUState)(c, s)); }
static inline int door_restore(Handle c, void *s) { return IS_OK(F(fmi3SetFMUState)(c, s)); }
static inline int door_drop(Handle c, void **s) { return IS_OK(F(fmi3FreeFMUState)(c, s)); }
static inline int door_size(Handle c, void *s, size_t *n) { return IS_OK(F(fmi3SerializedFMUStateSize)(c, s, n)); }
static inline int door_write(Handle c, void *s, void *bytes, size_t n) {
  return IS_OK(F(fmi3SerializeFMUState)(c, s, bytes, n));
}
static inline int door_read(Handle c, const void *bytes, size_t n, void **s) {
  return IS_OK(F(fmi3DeserializeFMUState)(c, bytes, n, s));
}
static inline int door_derivative(Handle c, const Reference *u, size_t nu, const Reference *k, size_t nk,
                           const double *seed, size_t seeds, double *result) {
  return IS_OK(F(fmi3GetDirectionalDerivative)(c, u, nu, k, nk, seed, seeds, result, nu));
}
static inline int door_logging(Handle c, int on, size_t n, const char *const *categories) {
  return IS_OK(F(fmi3SetDebugLogging)(c, on, n, categories));
}
/* Calls that are never legal for this component. */
#define UNSUPPORTED_CALLS 6
static inline int door_unsupported(Handle c, int which) {
  Reference r = 0;
  double value = 0.0;
  size_t n = 0;
  fmi3Boolean flag = 0;
  if (which == 0) return IS_OK(F(fmi3EnterConfigurationMode)(c));
  if (which == 1) return IS_OK(F(fmi3EnterStepMode)(c));
  if (which == 2) return IS_OK(F(fmi3EnterEventMode)(c));
  if (which == 3) return IS_OK(F(fmi3GetBoolean)(c, &r, 1, &flag, 1));
  if (which == 4) return IS_OK(F(fmi3GetNumberOfVariableDependencies)(c, r, &n));
  return IS_OK(F(fmi3SetFloat64)(c, &r, 1, &value, 2));
}
#endif

/* Of scalars. */
static inline int door_get(Handle c, const Reference *r, size_t n, int kind, void *values) {
  return door_get_all(c, r, n, kind, values, n);
}
static inline int door_set(Handle c, const Reference *r, size_t n, int kind, const void *values) {
  return door_set_all(c, r, n, kind, values, n);
}
#endif
