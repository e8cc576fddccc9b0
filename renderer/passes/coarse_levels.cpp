#include "passes/coarse_levels.h"

#include <chrono>

#include "core/base/background.h"

namespace dermis {
namespace {

template <class T>
bool isReady(const std::future<T>& future) {
  return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

std::shared_ptr<const std::vector<CoarseMesh>> CoarseLevels::of(const std::shared_ptr<const Model>& model) {
  std::erase_if(m_unwanted, [](const auto& future) { return isReady(future); });
  if (m_model != model) {
    if (m_coming.valid()) m_unwanted.push_back(std::move(m_coming));
    m_model = model;
    m_levels = nullptr;
    // Half a millimetre on a bust: what a picture of half the side can't show.
    constexpr float kShareOfRadius = 0.001F;
    m_coming = std::async(std::launch::async, [model]() -> Levels {
      giveWay();
      return std::make_shared<const std::vector<CoarseMesh>>(
          coarseMeshes(*model, kShareOfRadius * model->bounds.radius()));
    });
  }
  if (m_coming.valid() && isReady(m_coming)) m_levels = m_coming.get();
  return m_levels;
}

}  // namespace dermis
