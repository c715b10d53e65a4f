// main of every test executable. Takes doctest's options (--help).

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>

#include "crsh/leaks.h"
#include "support/device.h"

int main(int count, char** arguments) {
  doctest::Context context(count, arguments);
  const int result = context.run();
  const unsigned long long messages = crsh::test::close_device();  // before the driver's own clean-up at exit
  if (messages == 0) return result;
  std::fprintf(stderr, "%llu validation messages\n", messages);
  return 1;
}
