// Numbers that look random and are the same on every machine.
#pragma once

#include <cstdint>

namespace dermis {

/// SplitMix64 (Steele, Lea & Flood 2014, "Fast Splittable Pseudorandom Number Generators").
class Random {
 public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}
  /// 0..1.
  float next();
  float between(float from, float to) { return from + (to - from) * next(); }

 private:
  std::uint64_t m_state;
};

}  // namespace dermis
