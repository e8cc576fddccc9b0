#include "ui/driver_reset.h"

#include <dlfcn.h>

#include <cstring>

// Qt looks OpenGL's functions up by name. The program's own glXGetProcAddress stands in front of the library's (the
// build exports it), and hands out one that can be made to say that the driver was reset.
namespace {

using Function = void (*)();
using GetProcAddress = Function (*)(const unsigned char*);

constexpr unsigned kNoError = 0;
constexpr unsigned kUnknownContextReset = 0x8255;

bool reset = false;
bool broken = false;
int told = 0;

unsigned resetStatus() {
  if (!reset && !broken) return kNoError;
  reset = false;
  ++told;
  return kUnknownContextReset;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) Function glXGetProcAddress(const unsigned char* name);
extern "C" Function glXGetProcAddress(const unsigned char* name) {
  static const auto next = reinterpret_cast<GetProcAddress>(dlsym(RTLD_NEXT, "glXGetProcAddress"));
  if (std::strcmp(reinterpret_cast<const char*>(name), "glGetGraphicsResetStatus") == 0)
    return reinterpret_cast<Function>(&resetStatus);
  return next(name);
}

namespace dermis::test {

void resetDriver() { reset = true; }

void breakDriver() { broken = true; }

void mendDriver() { broken = false; }

int contextsTold() { return told; }

}  // namespace dermis::test
