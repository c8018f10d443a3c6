/* What libraries for Windows need of a C runtime and `ucrtbase.dll`, a part of Windows, has under
   other names: linked in place of the static runtime, which would have to be compiled first. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#define STANDARD 2 /* "snprintf" as in C99 */

int vsnprintf(char *text, size_t size, const char *format, va_list arguments) {
  return __stdio_common_vsprintf(STANDARD, text, size, format, NULL, arguments);
}

int snprintf(char *text, size_t size, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  int length = vsnprintf(text, size, format, arguments);
  va_end(arguments);
  return length;
}

int __fpclassify(double value) {
  return __builtin_fpclassify(FP_NAN, FP_INFINITE, FP_NORMAL, FP_SUBNORMAL, FP_ZERO, value);
}

int DllMainCRTStartup(void *library, unsigned long reason, void *reserved) {
  (void)library, (void)reason, (void)reserved;
  return 1;
}

/* Touches each page of a frame of rax bytes, so that Windows lets the stack grow. */
__attribute__((naked)) void ___chkstk_ms(void) {
  __asm__("push %rcx\n"
          "push %rax\n"
          "lea 24(%rsp), %rcx\n"
          "cmp $0x1000, %rax\n"
          "jb 2f\n"
          "1: sub $0x1000, %rcx\n"
          "test %rcx, (%rcx)\n"
          "sub $0x1000, %rax\n"
          "cmp $0x1000, %rax\n"
          "ja 1b\n"
          "2: sub %rax, %rcx\n"
          "test %rcx, (%rcx)\n"
          "pop %rax\n"
          "pop %rcx\n"
          "ret\n");
}
