// The first nine real spherical harmonics, in the order (l,m) 00, 1−1, 10, 11, 2−2, 2−1, 20, 21, 22 of the orthonormal
// basis without the Condon-Shortley phase (Ramamoorthi & Hanrahan 2001, "An Efficient Representation for Irradiance
// Environment Maps", equation 3).
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace dermis {

template <class T>
using Harmonics = std::array<T, 9>;

/// The basis functions in the direction `d`, of unit length.
template <class T>
[[nodiscard]] Harmonics<T> harmonicsAt(const glm::vec<3, T>& d) {
  return {T(0.28209479177387814),
          T(0.4886025119029199) * d.y,
          T(0.4886025119029199) * d.z,
          T(0.4886025119029199) * d.x,
          T(1.0925484305920792) * d.x * d.y,
          T(1.0925484305920792) * d.y * d.z,
          T(0.31539156525252005) * (T(3) * d.z * d.z - T(1)),
          T(1.0925484305920792) * d.x * d.z,
          T(0.5462742152960396) * (d.x * d.x - d.y * d.y)};
}

/// What convolution with the clamped cosine multiplies each coefficient by, over π: radiance to irradiance/π (equation
/// 8 there).
template <class T>
inline constexpr Harmonics<T> kCosineLobe = {T(1),    T(2) / 3, T(2) / 3, T(2) / 3, T(0.25),
                                             T(0.25), T(0.25),  T(0.25),  T(0.25)};

}  // namespace dermis
