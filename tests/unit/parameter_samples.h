// Values for tests that go over the whole parameter table.
#pragma once

#include "core/material/parameter_table.h"

namespace dermis::test {

/// A value inside the row's hard range that differs from its default in every component.
inline ParameterValue otherValue(const ParameterRow& row) {
  const float step = 0.3125F * (row.hardMax - row.hardMin);
  const auto other = [&](float value) { return value + step <= row.hardMax ? value + step : value - step; };
  const auto others = [&](auto vector) {
    for (int i = 0; i < decltype(vector)::length(); ++i) vector[i] = other(vector[i]);
    return vector;
  };
  const ParameterValue value = row.defaultValue();
  switch (row.type) {
    case ParameterType::Float:
      return other(std::get<float>(value));
    case ParameterType::Vec2:
      return others(std::get<glm::vec2>(value));
    case ParameterType::Vec3:
      return others(std::get<glm::vec3>(value));
    case ParameterType::Colour:
      return Colour{others(std::get<Colour>(value).rgb)};
    case ParameterType::OptionalColour:
      return OptionalColour(Colour{{1.0F, 0.71F, 0.29F}});
    case ParameterType::Enum:
      return EnumValue{(std::get<EnumValue>(value).index + 1) % static_cast<int>(row.words.size())};
    case ParameterType::Bool:
      return !std::get<bool>(value);
    case ParameterType::Gaussians: {
      GaussianTable table;
      table.terms[0] = {0.5F, {0.25F, 0.5F, 1.0F}};
      table.terms[1] = {2.5F, {0.75F, 0.5F, 0.0F}};
      table.count = 2;
      return table;
    }
  }
  return value;
}

}  // namespace dermis::test
