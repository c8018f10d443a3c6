/* The number that a model computes with: a double; or, where LANES is defined, one of each of so many
   gyros, side by side in a vector of the compiler (Clang). Every operation acts on each lane as it
   does on a double, so that the bits are the same. */
#ifndef REAL_H
#define REAL_H

#include <math.h>

#ifdef LANES

typedef double real __attribute__((ext_vector_type(LANES)));
typedef unsigned long long bits __attribute__((ext_vector_type(LANES)));
typedef __typeof__((real)0.0 < (real)0.0) truth;

/* Whether a condition holds in a lane; in all of them. */
#define ANY(condition) (__builtin_reduce_or(condition) != 0)
#define ALL(condition) (__builtin_reduce_and(condition) != 0)

/* How often lanes had to go different ways, which they can't, in all threads. */
static unsigned long long partings;
static inline int go_together(truth condition) {
  if (ANY(condition) && !ALL(condition)) __atomic_fetch_add(&partings, 1, __ATOMIC_RELAXED);
  return ANY(condition);
}

/* One of two values by lane; what no lane needs is not computed. */
#define CHOOSE(condition, yes, no)       \
  __extension__({                        \
    const truth where_ = (condition);    \
    real yes_ = 0.0, no_ = 0.0;          \
    if (ANY(where_)) yes_ = (yes);       \
    if (!ALL(where_)) no_ = (no);        \
    where_ ? yes_ : no_;                 \
  })
#define GO(condition) go_together(condition)
#define m_abs(x) __builtin_elementwise_abs(x)
#define m_sqrt(x) __builtin_elementwise_sqrt(x)
#define m_is_finite(x) ALL(m_abs(x) < INFINITY)
/* A number that all lanes have alike. */
#define FIRST(x) (((real)(x))[0])
#define TO_REAL(x) __builtin_convertvector(x, real)
#define TO_BITS(x) __builtin_convertvector(x, bits)

#else

typedef double real;
typedef unsigned long long bits;
typedef int truth;

#define ANY(condition) (condition)
#define ALL(condition) (condition)
#define CHOOSE(condition, yes, no) ((condition) ? (yes) : (no))
#define GO(condition) (condition)
#define m_abs(x) fabs(x)
#define m_sqrt(x) sqrt(x)
#define m_is_finite(x) isfinite(x)
#define FIRST(x) (x)
#define TO_REAL(x) ((real)(x))
#define TO_BITS(x) ((bits)(x))

#endif
#endif
