// Levels of fewer triangles, made beside the frames once they are wanted.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "core/scene/coarse_mesh.h"

namespace dermis {

/// Of the model that was asked for last.
class CoarseLevels {
 public:
  /// The model's, or null as long as they aren't ready; the first question of a model begins to make them.
  [[nodiscard]] std::shared_ptr<const std::vector<CoarseMesh>> of(const std::shared_ptr<const Model>& model);

 private:
  using Levels = std::shared_ptr<const std::vector<CoarseMesh>>;
  std::shared_ptr<const Model> m_model;
  std::future<Levels> m_coming;
  Levels m_levels;
  std::vector<std::future<Levels>> m_unwanted;  ///< of models left meanwhile: a future waits where it is destroyed
};

}  // namespace dermis
