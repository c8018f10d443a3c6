/* An FMU that plays the motion of a vehicle from the file resources/trajectory.bin, FMI 2.0 co-simulation:
   a magic, the interval, the number of intervals, and that many rows and one, all but the magic
   doubles of little-endian order. A row holds the mean rotation rate and the mean specific force
   along the body axes over its interval, and height and climb rate at its begin. */
#include "fmi2Functions.h"
#include "token.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAGIC "HRGPATH1"
#define FILE_NAME "/trajectory.bin"
#define CATEGORY "logStatusError"

enum { RATE, FORCE = 3, HEIGHT = 6, CLIMB, COLUMNS };
enum { GYROS = 3, AXES = 3, MOTION = 1 + AXES };
/* Value references: parameters, then outputs. */
enum {
  CASE_AXES,
  LEAD_IN = GYROS * AXES * 3,
  CASE_MOTION,
  SPECIFIC_FORCE = CASE_MOTION + GYROS * MOTION,
  ROW = SPECIFIC_FORCE + 3,
  REFERENCE_HEIGHT,
  REFERENCE_CLIMB,
  VARIABLES
};

typedef enum { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED } Phase;

typedef struct {
  double parameters[CASE_MOTION];
  double elapsed, error; /* since the start: sum of the steps, and its rounding error */
  Phase phase;
  double interval, count, *rows;
  fmi2CallbackLogger logger;
  fmi2ComponentEnvironment environment;
  char name[128];
} Player;

static fmi2Status refuse(const Player *player, const char *message) {
  if (player && player->logger)
    player->logger(player->environment, player->name, fmi2Error, CATEGORY, message);
  return fmi2Error;
}

static int is_in(const Player *player, unsigned phases) {
  return player && ((1u << player->phase) & phases);
}

static int hex(char c) {
  return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Path of the file from the URI of the folder; 0 where it is too long or no URI of a file. */
static int find_file(const char *uri, char *path, size_t size) {
  if (!uri || strncmp(uri, "file:", 5)) return 0;
  uri += 5;
  if (!strncmp(uri, "//", 2)) {
    uri += 2;
    while (*uri && *uri != '/') uri++;
  }
  if (uri[0] == '/' && uri[1] && (uri[2] == ':' || uri[2] == '|')) uri++; /* a drive of Windows */
  size_t n = 0;
  for (; *uri; uri++) {
    int coded = *uri == '%' && hex(uri[1]) >= 0 && hex(uri[2]) >= 0;
    if (n + sizeof FILE_NAME + 1 > size) return 0;
    path[n++] = coded ? (char)(16 * hex(uri[1]) + hex(uri[2])) : *uri;
    uri += coded ? 2 : 0;
  }
  while (n && path[n - 1] == '/') n--;
  memcpy(path + n, FILE_NAME, sizeof FILE_NAME);
  return 1;
}

static int read_rows(Player *player, FILE *file) {
  char magic[8];
  double head[2];
  if (fread(magic, 1, 8, file) != 8 || memcmp(magic, MAGIC, 8)) return 0;
  if (fread(head, sizeof *head, 2, file) != 2) return 0;
  player->interval = head[0];
  player->count = head[1];
  if (!(player->interval > 0.0 && player->count >= 1.0 && player->count <= 1e9)) return 0;
  size_t cells = ((size_t)player->count + 1) * COLUMNS;
  player->rows = malloc(cells * sizeof *player->rows);
  return player->rows && fread(player->rows, sizeof *player->rows, cells, file) == cells;
}

static int load(Player *player, const char *resources) {
  char path[4096];
  FILE *file = find_file(resources, path, sizeof path) ? fopen(path, "rb") : NULL;
  int done = file && read_rows(player, file);
  if (file) fclose(file);
  return done;
}

static void set_defaults(Player *player) {
  memset(player->parameters, 0, sizeof player->parameters);
  for (int gyro = 0; gyro < GYROS; gyro++)
    for (int axis = 0; axis < AXES; axis++)
      player->parameters[CASE_AXES + 9 * gyro + 3 * axis + (gyro + 1 + axis) % 3] = 1.0;
  player->elapsed = player->error = 0.0;
  player->phase = INSTANTIATED;
}

/* The interval that begins at the present time, counted from the motion's; negative before it. */
static double present(const Player *player) {
  return floor(player->elapsed / player->interval + 1e-6) - player->parameters[LEAD_IN];
}

static double along(const double *axis, const double *vector) {
  return axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
}

static double output(const Player *player, unsigned reference) {
  double index = present(player);
  int is_moving = index >= 0.0 && index < player->count;
  const double *row = player->rows + COLUMNS * (size_t)fmin(fmax(index, 0.0), player->count);
  if (reference == ROW) return fmin(fmax(index, -1.0), player->count) + 1.0;
  if (reference == REFERENCE_HEIGHT) return row[HEIGHT];
  if (reference == REFERENCE_CLIMB) return row[CLIMB];
  if (!is_moving) return 0.0;
  if (reference >= SPECIFIC_FORCE) return row[FORCE + reference - SPECIFIC_FORCE];
  unsigned gyro = (reference - CASE_MOTION) / MOTION, place = (reference - CASE_MOTION) % MOTION;
  const double *axes = player->parameters + CASE_AXES + 9 * gyro;
  return place ? along(axes + 3 * (place - 1), row + FORCE) : along(axes + 3 * 2, row + RATE);
}

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible,
                              fmi2Boolean logging) {
  (void)visible, (void)logging;
  Player *player = calloc(1, sizeof *player);
  if (!player) return NULL;
  if (callbacks) player->logger = callbacks->logger, player->environment = callbacks->componentEnvironment;
  snprintf(player->name, sizeof player->name, "%s", name ? name : "");
  set_defaults(player);
  const char *fault = type != fmi2CoSimulation               ? "only co-simulation is supported"
                      : !guid || strcmp(guid, TOKEN)         ? "the token is not that of this FMU"
                      : !load(player, resources)             ? "resources/trajectory.bin can't be read"
                                                             : NULL;
  if (!fault) return player;
  refuse(player, fault);
  fmi2FreeInstance(player);
  return NULL;
}

void fmi2FreeInstance(fmi2Component c) {
  if (c) free(((Player *)c)->rows);
  free(c);
}

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[]) {
  (void)on, (void)n, (void)categories;
  return c ? fmi2OK : fmi2Error;
}

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
  (void)tolerance_defined, (void)tolerance, (void)stop_defined, (void)stop;
  Player *player = c;
  if (!is_in(player, 1u << INSTANTIATED) || !isfinite(start)) return refuse(player, "the experiment can't be set up");
  return fmi2OK;
}

static fmi2Status go(Player *player, unsigned from, Phase to) {
  if (!is_in(player, from)) return refuse(player, "a call that is not legal in this phase");
  player->phase = to;
  return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) { return go(c, 1u << INSTANTIATED, INITIALIZING); }
fmi2Status fmi2ExitInitializationMode(fmi2Component c) { return go(c, 1u << INITIALIZING, STEPPING); }
fmi2Status fmi2Terminate(fmi2Component c) { return go(c, 1u << STEPPING, TERMINATED); }

fmi2Status fmi2Reset(fmi2Component c) {
  if (c) set_defaults(c);
  return c ? fmi2OK : fmi2Error;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
  Player *player = c;
  if (!is_in(player, ~0u ^ 1u << INSTANTIATED)) return refuse(player, "reading is not legal in this phase");
  for (size_t i = 0; i < n; i++) {
    if (vr[i] >= VARIABLES) return refuse(player, "no variable has this value reference");
    value[i] = vr[i] < CASE_MOTION ? player->parameters[vr[i]] : output(player, vr[i]);
  }
  return fmi2OK;
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[]) {
  Player *player = c;
  if (!is_in(player, 1u << INSTANTIATED | 1u << INITIALIZING))
    return refuse(player, "parameters can't be set after initialization");
  for (size_t i = 0; i < n; i++)
    if (vr[i] >= CASE_MOTION || !(fabs(value[i]) <= (vr[i] == LEAD_IN ? 1e6 : 1.0)))
      return refuse(player, "no parameter, or a value out of range");
  for (size_t i = 0; i < n; i++) player->parameters[vr[i]] = value[i];
  return fmi2OK;
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_rollback) {
  (void)no_rollback;
  Player *player = c;
  if (!is_in(player, 1u << STEPPING) || !(step > 0.0) || !isfinite(time + step)) return refuse(player, "a step that is not legal");
  /* the times of importers that add up their steps are no sums to rely on */
  const double added = step - player->error, sum = player->elapsed + added;
  player->error = (sum - player->elapsed) - added;
  player->elapsed = sum;
  return fmi2OK;
}

/* Kinds of variables, and abilities, that it does not have. */
#define NO_VARIABLES(Kind)                                                                                      \
  fmi2Status fmi2Get##Kind(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2##Kind value[]) {       \
    (void)vr, (void)value;                                                                                      \
    return n ? refuse(c, "there are no variables of this kind") : fmi2OK;                                       \
  }                                                                                                             \
  fmi2Status fmi2Set##Kind(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2##Kind value[]) { \
    (void)vr, (void)value;                                                                                      \
    return n ? refuse(c, "there are no variables of this kind") : fmi2OK;                                       \
  }
NO_VARIABLES(Integer)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

#define ABSENT(name, ...) \
  fmi2Status name(__VA_ARGS__) { return refuse(c, #name " is not supported"); }
#define _ __attribute__((unused))
ABSENT(fmi2GetFMUstate, fmi2Component c, _ fmi2FMUstate *state)
ABSENT(fmi2SetFMUstate, fmi2Component c, _ fmi2FMUstate state)
ABSENT(fmi2FreeFMUstate, fmi2Component c, _ fmi2FMUstate *state)
ABSENT(fmi2SerializedFMUstateSize, fmi2Component c, _ fmi2FMUstate state, _ size_t *size)
ABSENT(fmi2SerializeFMUstate, fmi2Component c, _ fmi2FMUstate state, _ fmi2Byte bytes[], _ size_t size)
ABSENT(fmi2DeSerializeFMUstate, fmi2Component c, _ const fmi2Byte bytes[], _ size_t size, _ fmi2FMUstate *state)
ABSENT(fmi2GetDirectionalDerivative, fmi2Component c, _ const fmi2ValueReference z[], _ size_t nz,
       _ const fmi2ValueReference v[], _ size_t nv, _ const fmi2Real dv[], _ fmi2Real dz[])
ABSENT(fmi2SetRealInputDerivatives, fmi2Component c, _ const fmi2ValueReference vr[], _ size_t n,
       _ const fmi2Integer order[], _ const fmi2Real value[])
ABSENT(fmi2GetRealOutputDerivatives, fmi2Component c, _ const fmi2ValueReference vr[], _ size_t n,
       _ const fmi2Integer order[], _ fmi2Real value[])
ABSENT(fmi2CancelStep, fmi2Component c)
ABSENT(fmi2GetStatus, fmi2Component c, _ const fmi2StatusKind kind, _ fmi2Status *value)
ABSENT(fmi2GetRealStatus, fmi2Component c, _ const fmi2StatusKind kind, _ fmi2Real *value)
ABSENT(fmi2GetIntegerStatus, fmi2Component c, _ const fmi2StatusKind kind, _ fmi2Integer *value)
ABSENT(fmi2GetBooleanStatus, fmi2Component c, _ const fmi2StatusKind kind, _ fmi2Boolean *value)
ABSENT(fmi2GetStringStatus, fmi2Component c, _ const fmi2StatusKind kind, _ fmi2String *value)
