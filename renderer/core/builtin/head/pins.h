// Points that the skin passes through: the character of the head.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace dermis::sculpt {

/// Millimetres: x to the left ear, y up, z forward; the origin lies between the pupils in x and y and above the ear
/// canal in z. A pin with x > 0 stands for its mirror image too. The soft parts that come later (nose, lips, lids, ear)
/// lie in front of them.
struct Pin {
  std::string_view name;
  glm::vec3 place;
};
[[nodiscard]] std::span<const Pin> headPins();

/// Places where the rough form is left as it is, so that the pins' pull stays near them.
[[nodiscard]] std::span<const glm::vec3> headAnchors();

}  // namespace dermis::sculpt
