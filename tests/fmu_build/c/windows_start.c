/* Beside `fmu_build/windows/runtime.c`, what a program for Windows needs of a C runtime. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

int _configure_narrow_argv(int);
int main(int count, char **arguments);

int printf(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  int length = __stdio_common_vfprintf(0, stdout, format, NULL, arguments);
  va_end(arguments);
  return length;
}

int fprintf(FILE *file, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  int length = __stdio_common_vfprintf(0, file, format, NULL, arguments);
  va_end(arguments);
  return length;
}

int sscanf(const char *text, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  int count = __stdio_common_vsscanf(0, text, (size_t)-1, format, NULL, arguments);
  va_end(arguments);
  return count;
}

void mainCRTStartup(void) {
  _configure_narrow_argv(1);
  exit(main(*__p___argc(), *__p___argv()));
}

void __main(void) {} /* constructors of C++, of which there are none */
