// A light rig of a scene's own, as an environment holds it.
#pragma once

#include <memory>

namespace dermis {

struct LightRig;

/// None, or a rig that never changes: a scene is copied at every edit, its rig is shared. Equal where the rigs are.
class InlineRig {
 public:
  InlineRig() = default;
  explicit InlineRig(LightRig rig);
  explicit operator bool() const { return m_rig != nullptr; }
  const LightRig& operator*() const { return *m_rig; }
  const LightRig* operator->() const { return m_rig.get(); }
  void reset() { m_rig.reset(); }
  bool operator==(const InlineRig& other) const;

 private:
  std::shared_ptr<const LightRig> m_rig;
};

}  // namespace dermis
