// A fault of the program itself stops the run. Never used to judge input files or sensor values.
#pragma once

#include <cstdio>
#include <cstdlib>

#define DOCKYARD_CHECK(condition)                                                        \
  do {                                                                                   \
    if (!(condition)) {                                                                  \
      std::fprintf(stderr, "%s:%d: check failed: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                      \
    }                                                                                    \
  } while (false)
