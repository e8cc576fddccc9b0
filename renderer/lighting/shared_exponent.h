// Floats to three nine-bit mantissas with one exponent (EXT_texture_shared_exponent; GL_RGB9_E5), many at a time.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace dermis {

/// The largest value that a texel holds: 511/512 of 2^16.
inline constexpr float kSharedExponentMax = 65408.0F;

/// One GL_UNSIGNED_INT_5_9_9_9_REV word for each four floats (RGB and one that is left out), all finite and ≥ 0. Each
/// channel is rounded to the nearest step, so it is wrong by 2⁻⁹ of the texel's largest channel at most; the exponent
/// ends at 2⁻¹⁶, where steps are 2⁻²⁴ as a denormal half float's are.
inline void toSharedExponent(std::span<const float> rgba, std::uint32_t* to) {
  for (std::size_t i = 0; 4 * i + 3 < rgba.size(); ++i) {
    const float r = std::min(rgba[4 * i], kSharedExponentMax);
    const float g = std::min(rgba[4 * i + 1], kSharedExponentMax);
    const float b = std::min(rgba[4 * i + 2], kSharedExponentMax);
    // Half a step more carries into the exponent exactly where the largest mantissa would round up to 512.
    constexpr std::uint32_t kHalfStep = 1U << 14U;
    const std::uint32_t largest = std::bit_cast<std::uint32_t>(std::max({r, g, b})) + kHalfStep;
    const std::uint32_t floatExponent = std::max(largest >> 23U, 127U - 16U);
    const std::uint32_t exponent = floatExponent - (127U - 16U);
    // 2^(24 − exponent): mantissas are counted in steps of 2^(exponent − 15 − 9).
    const float steps = std::bit_cast<float>((127U + 24U - exponent) << 23U);
    // Values are ≥ 0, so this rounds; lround would not become vector instructions.
    const auto mantissa = [steps](float v) {
      return static_cast<std::uint32_t>(static_cast<int>(v * steps + 0.5F));  // NOLINT(bugprone-incorrect-roundings)
    };
    to[i] = mantissa(r) | mantissa(g) << 9U | mantissa(b) << 18U | exponent << 27U;
  }
}

}  // namespace dermis
