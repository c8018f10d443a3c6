/* Numbers in messages. */
#ifndef NUMBER_H
#define NUMBER_H

#include "names.h"

#define NUMBER_SIZE 32
#define RANGE_SIZE (2 * NUMBER_SIZE + 16)

/* The shortest digits that read back as the value; whole numbers as such. */
#define NUMBER(value) number_text(value, (char[NUMBER_SIZE]){0})
char *number_text(double value, char text[NUMBER_SIZE]);

/* " from 0 to 1", " from 0 up", " up to 1" or ": any number"; follows "its range". */
#define RANGE(minimum, maximum) range_text(minimum, maximum, (char[RANGE_SIZE]){0})
char *range_text(double minimum, double maximum, char text[RANGE_SIZE]);

#endif
