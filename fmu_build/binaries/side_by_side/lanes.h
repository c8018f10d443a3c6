/* WIDTH gyros of one model that advance together. */
#ifndef LANES_H
#define LANES_H

typedef struct Lanes Lanes;

/* NULL if there is no memory; lanes_free() ends them. */
Lanes *lanes_create(void);
void lanes_free(Lanes *lanes);
/* The values of a variable, one a lane. */
double *lanes_values(Lanes *lanes, unsigned reference);
/* To be called when all values are there: time of the first tick, time since the last, ticks. */
void lanes_begin(Lanes *lanes, double start, double offset, long long ticks);
double lanes_offset(const Lanes *lanes);
long long lanes_ticks(const Lanes *lanes);
/* To be called after inputs were set. */
void lanes_touch(Lanes *lanes);
/* Bring continuous variables up to date. 0 if lanes had to go different ways. */
int lanes_refresh(Lanes *lanes);
/* Integrate to a time. 0 as well if a lane is no longer finite. */
int lanes_advance(Lanes *lanes, double time);

#endif
