// Floats to IEEE half floats, many at a time.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace dermis {

/// Rounds to nearest even; values beyond 65504 become 65504. For finite values ≥ 0 only, so that it vectorises.
inline void toHalf(std::span<const float> from, std::uint16_t* to) {
  // Adding a power of two makes the FPU round a denormal half; normal ones are rounded on their bits (Giesen 2012,
  // "float_to_half_fast3_rtne").
  const float denormal = std::bit_cast<float>((127U - 15U + 23U - 10U + 1U) << 23U);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const float v = from[i] < 65504.0F ? from[i] : 65504.0F;
    const auto bits = std::bit_cast<std::uint32_t>(v);
    const std::uint32_t small = std::bit_cast<std::uint32_t>(v + denormal) - std::bit_cast<std::uint32_t>(denormal);
    const std::uint32_t normal = (bits + ((15U - 127U) << 23U) + 0xFFFU + ((bits >> 13U) & 1U)) >> 13U;
    to[i] = static_cast<std::uint16_t>(bits < (113U << 23U) ? small : normal);
  }
}

}  // namespace dermis
