/* What an instance tells its importer. */
#include "instance.h"
#include "number.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *const log_categories[LOG_CATEGORIES] = {"logStatusError", "logStatusDiscard",
                                                   "logEvents"};

static void pass_on(const Instance *instance, Category category, const char *message) {
  const Listener *listener = &instance->listener;
  if (instance->logged[category] && listener->logger)
    listener->tell(listener, instance->name, category, message);
}

static void complain(const Instance *instance, Category category, const char *format,
                     va_list arguments) {
  char text[512];
  vsnprintf(text, sizeof text, format, arguments);
  pass_on(instance, category, text);
}

int instance_refuse(Instance *instance, const char *format, ...) {
  if (!instance) return 0;
  va_list arguments;
  va_start(arguments, format);
  complain(instance, LOG_ERROR, format, arguments);
  va_end(arguments);
  return 0;
}

Answer instance_discard(Instance *instance, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  complain(instance, LOG_DISCARD, format, arguments);
  va_end(arguments);
  return DISCARDED;
}

void instance_note(Instance *instance, const char *event) {
  char text[128];
  if (!instance->logged[LOG_EVENT]) return;
  snprintf(text, sizeof text, "%s at %s s", event, NUMBER(instance->now.time));
  pass_on(instance, LOG_EVENT, text);
}

int instance_log(Instance *instance, int on, size_t n, const char *const *categories) {
  int chosen[LOG_CATEGORIES] = {0};
  if (!instance_may(instance, ALWAYS, "logging")) return 0;
  if (n && !categories) return instance_refuse(instance, "a null pointer to log categories");
  for (size_t i = 0; i < n; i++) {
    int k = 0;
    while (k < LOG_CATEGORIES && categories[i] && strcmp(categories[i], log_categories[k]) != 0) k++;
    if (k == LOG_CATEGORIES || !categories[i])
      return instance_refuse(instance, "there is no log category %.100s",
                             categories[i] ? categories[i] : "(null)");
    chosen[k] = 1;
  }
  for (int k = 0; k < LOG_CATEGORIES; k++) instance->logged[k] = on && (chosen[k] || !n);
  return 1;
}
