/* One gyro as an importer handles it: phases, checked access, steps, log.
   The FMI shells translate their calls into these; nothing here belongs to one FMI version. */
#ifndef INSTANCE_H
#define INSTANCE_H

#include "core.h"
#include "limits.h"

#include <stddef.h>

/* UPDATING: within a step, while the importer is told of a tick. FAILED: a state is not finite. */
typedef enum { INSTANTIATED, INITIALIZING, STEPPING, UPDATING, FAILED, TERMINATED } Phase;

/* s; a double can tell ticks apart up to the last of them. */
#define EARLIEST_TIME -1e6
#define LATEST_START 1e6
#define LATEST_TIME 1e7

#define IN(phase) (1u << (phase))
#define BEFORE_STEPS (IN(INSTANTIATED) | IN(INITIALIZING))
#define SETTABLE (BEFORE_STEPS | IN(STEPPING) | IN(UPDATING))
#define READABLE (IN(INITIALIZING) | IN(STEPPING) | IN(UPDATING) | IN(FAILED) | IN(TERMINATED))
#define OUTSIDE_A_STEP (BEFORE_STEPS | IN(STEPPING) | IN(FAILED) | IN(TERMINATED))
#define ALWAYS (OUTSIDE_A_STEP | IN(UPDATING))

typedef enum { LOG_ERROR, LOG_DISCARD, LOG_EVENT, LOG_CATEGORIES } Category;
extern const char *const log_categories[LOG_CATEGORIES];

/* Who is told, and how; the logger is the importer's function in the type of its FMI version. */
typedef struct Listener {
  void (*tell)(const struct Listener *listener, const char *instance, Category category,
               const char *message);
  void *environment;
  void (*logger)(void);
} Listener;

/* To a call that sets values. DISCARDED: a value is out of range, and nothing was set; the simulation
   can go on with those before. */
typedef enum { REFUSED, DONE, DISCARDED } Answer;

typedef struct {
  Core core;
  Phase phase;
  double time, start, stop;
  int stop_defined;
  double angle;     /* of the case, reached by the input MODEL_ANGLE */
  double turn_rate; /* within a step: at which it changes */
} Situation;

typedef struct Instance {
  Situation now;
  Core first;      /* during initialization: as it will be at the start time, after the first tick */
  int first_fresh; /* first belongs to what is set at present */
  Listener listener;
  unsigned references; /* value references that can be read */
  int logged[LOG_CATEGORIES];
  char name[256];
} Instance;

/* Is told of each tick within a step; may bring the end of the step forward, to that tick at least. */
typedef void (*Between)(Instance *instance, double *end);

/* All functions that return int give 1 for success, and 0 after a report with nothing changed
   (except by a step whose states are no longer finite). A null instance gives 0. */

/* A shell's own structure of this size, which begins with an Instance; free() ends it. */
void *instance_create(size_t size, const char *name, const char *token, unsigned references,
                      const Listener *listener, int logging);
int instance_reset(Instance *instance);
int instance_setup(Instance *instance, double start, int stop_defined, double stop);
int instance_enter_initialization(Instance *instance);
int instance_exit_initialization(Instance *instance);
int instance_terminate(Instance *instance);

/* To be called after the situation was changed during initialization, by whatever it was. */
void instance_touch(Instance *instance);

/* Whether the model has a variable of this kind. */
int instance_knows(unsigned reference, Kind kind);
/* Number of scalars that a reference stands for: more than one for an array, which is a parameter. */
unsigned instance_count(unsigned reference);
/* Values are double, int or bool, by kind; those of arrays one after another. */
int instance_get(Instance *instance, const unsigned *references, size_t n, Kind kind, void *values);
/* A value beyond its range by a rounding is the end of the range. */
Answer instance_set(Instance *instance, const unsigned *references, size_t n, Kind kind,
                    const void *values);
int instance_step(Instance *instance, double time, double step, Between between);

/* Errors are told from the start, events if logging is on; this call then decides for all:
   nothing when off, and when on the listed categories, or each if none is listed. */
int instance_log(Instance *instance, int on, size_t n, const char *const *categories);

/* Whether a call is legal in the present phase. */
int instance_may(Instance *instance, unsigned phases, const char *call);
int instance_refuse(Instance *instance, const char *format, ...);
Answer instance_discard(Instance *instance, const char *format, ...);
void instance_note(Instance *instance, const char *event);

#endif
