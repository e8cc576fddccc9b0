// The files under resources/, as the build embedded them. Read through core/base/resources.h.
#pragma once

namespace dermis::embedded {

struct Row {
  const char* path;  // relative to resources/, e.g. "shaders/sky.frag"; null in the closing row
  const char* begin;
  const char* end;
};

extern const Row kRows[];

}  // namespace dermis::embedded
