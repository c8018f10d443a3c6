/* LANES gyros of one model that advance together, a set for each thread. */
#ifndef LANES_H
#define LANES_H

/* The values of a variable, one a lane. */
double *lanes_values(unsigned reference);
/* To be called when all values are there: time of the first tick, time since the last, ticks. */
void lanes_begin(double start, double offset, long long ticks);
double lanes_offset(void);
long long lanes_ticks(void);
/* To be called after inputs were set. */
void lanes_touch(void);
/* Bring continuous variables up to date. */
void lanes_refresh(void);
/* Integrate to a time. 0 if a lane is no longer finite, or if lanes had to go different ways. */
int lanes_advance(double time);

#endif
