/* Loads an FMU's library by its path, runs one scenario, prints every output as bytes.

   `host LIBRARY TOKEN SETTING...`, where a setting is KIND:REFERENCE:VALUE. Kinds: `p` and `n` a real
   and an integer parameter, `i` an input that swings between plus and minus its value, `o` an output,
   `b` a Boolean one (printed as 1 or 0), `x` an input that must be refused; messages are printed after a `#`.
   Uneven steps, and a second half that is run again from a saved, serialized state. */
#ifdef _WIN32
#include <windows.h>
static HMODULE library;
#define OPEN(path) (library = LoadLibraryA(path))
#define FIND(name) ((void (*)(void))GetProcAddress(library, name))
#else
#include <dlfcn.h>
static void *library;
#define OPEN(path) (library = dlopen(path, RTLD_NOW | RTLD_LOCAL))
#define FIND(name) ((void (*)(void))dlsym(library, name))
#endif

#define F(name) (*(name##TYPE *)found(#name))
static void (*found(const char *name))(void);

#include "door.h"

#include <stdio.h>
#include <stdlib.h>

#define STEPS 200
#define MOST 64

typedef struct {
  char kind;
  Reference reference;
  double value;
} Setting;

static Setting settings[MOST];
static int setting_count;

static void on_message(int is_error, const char *category, const char *message) {
  if (is_error) printf("# %s: %s\n", category, message);
}

static void need(int success, const char *what) {
  if (success) return;
  fprintf(stderr, "failed: %s\n", what);
  exit(1);
}

static void (*found(const char *name))(void) {
  void (*function)(void) = FIND(name);
  need(function != NULL, name);
  return function;
}

static void set_parameters(Handle c) {
  for (int i = 0; i < setting_count; i++) {
    const Setting *s = &settings[i];
    int whole = (int)s->value;
    if (s->kind == 'p') need(door_set(c, &s->reference, 1, 0, &s->value), "a real parameter");
    if (s->kind == 'n') need(door_set(c, &s->reference, 1, 1, &whole), "an integer parameter");
  }
}

static void set_inputs(Handle c, int step) {
  for (int i = 0; i < setting_count; i++) {
    double value = settings[i].value * ((step * (i + 3)) % 17 - 8) / 8.0;
    if (settings[i].kind == 'i') need(door_set(c, &settings[i].reference, 1, 0, &value), "an input");
  }
}

static void print_outputs(Handle c, int step) {
  printf("%d", step);
  for (int i = 0; i < setting_count; i++) {
    union {
      double value;
      unsigned long long bits;
    } number;
    if (settings[i].kind == 'b') {
      _Bool flag;
      need(door_get(c, &settings[i].reference, 1, 2, &flag), "a Boolean output");
      number.value = flag;
    } else if (settings[i].kind == 'o') {
      need(door_get(c, &settings[i].reference, 1, 0, &number.value), "an output");
    } else {
      continue;
    }
    printf(" %08lx%08lx", (unsigned long)(number.bits >> 32), (unsigned long)(number.bits & 0xffffffff));
  }
  printf("\n");
}

static double run(Handle c, double time, int first, int last) {
  for (int step = first; step < last; step++) {
    double size = 0.001 * (1 + step % 13) + (step % 5 ? 0.0 : 0.0003);
    set_inputs(c, step);
    need(door_step(c, time, size), "a step");
    time += size;
    print_outputs(c, step);
  }
  return time;
}

/* The state by way of its bytes. */
static void *through_bytes(Handle c, void *state) {
  size_t n = 0;
  need(door_size(c, state, &n), "the size of a state");
  void *bytes = malloc(n), *again = NULL;
  need(bytes && door_write(c, state, bytes, n) && door_read(c, bytes, n, &again), "a state as bytes");
  free(bytes);
  return again;
}

int main(int count, char **arguments) {
  need(count > 3 && count - 3 <= MOST, "usage: host LIBRARY TOKEN SETTING...");
  need(OPEN(arguments[1]) != NULL, "loading the library");
  for (int i = 3; i < count; i++) {
    Setting *s = &settings[setting_count++];
    need(sscanf(arguments[i], "%c:%u:%lf", &s->kind, &s->reference, &s->value) == 3, arguments[i]);
  }
  Handle c = door_create(arguments[2], 0);
  need(c != NULL, "an instance");
  set_parameters(c);
  need(door_initialize(c, 0.0, 0, 0.0) && door_exit(c), "initialization");
  double half = run(c, 0.0, 0, STEPS / 2);
  void *state = NULL;
  need(door_save(c, &state), "saving");
  void *again = through_bytes(c, state);
  run(c, half, STEPS / 2, STEPS);
  need(door_restore(c, again), "restoring");
  run(c, half, STEPS / 2, STEPS);
  need(door_drop(c, &state) && door_drop(c, &again), "forgetting");
  for (int i = 0; i < setting_count; i++)
    if (settings[i].kind == 'x')
      need(!door_set(c, &settings[i].reference, 1, 0, &settings[i].value), "a refusal");
  door_terminate(c);
  door_free(c);
  return 0;
}
