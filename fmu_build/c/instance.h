/* One gyro as an importer handles it: phases, checked access, steps, saved states.
   The FMI shells translate their calls into these; nothing here belongs to one FMI version. */
#ifndef INSTANCE_H
#define INSTANCE_H

#include "core.h"

#include <stddef.h>

typedef enum { INSTANTIATED, INITIALIZING, STEPPING, TERMINATED } Phase;

/* How a refused call is told to the importer. */
typedef void (*Report)(void *context, const char *instance, const char *message);

typedef struct {
  Core core;
  Phase phase;
  double time, start, stop;
  int stop_defined;
} Situation;

typedef struct {
  Situation now;
  Report report;
  void *context;
  char name[256];
} Instance;

/* A saved situation: no pointers, and a mark of the model that it belongs to. */
typedef struct {
  char model[64];
  Situation situation;
} Snapshot;

/* All functions that return int give 1 for success and 0 after a report. */

Instance *instance_create(const char *name, const char *token, Report report, void *context);
void instance_reset(Instance *instance);
int instance_setup(Instance *instance, double start, int stop_defined, double stop);
int instance_enter_initialization(Instance *instance);
int instance_exit_initialization(Instance *instance);

/* Values by reference; integer says which of the two kinds the call is for. */
int instance_get(Instance *instance, unsigned reference, int integer, double *value);
int instance_set(Instance *instance, unsigned reference, int integer, double value);
/* To be called after a group of values was set. */
void instance_settle(Instance *instance);
int instance_step(Instance *instance, double time, double step);

Snapshot *instance_save(Instance *instance, Snapshot *into);
int instance_restore(Instance *instance, const Snapshot *snapshot);

int instance_refuse(Instance *instance, const char *format, ...);

#endif
