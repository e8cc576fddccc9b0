#include "core/light_rig/inline_rig.h"

#include <utility>

#include "core/light_rig/light_rig.h"

namespace dermis {

InlineRig::InlineRig(LightRig rig) : m_rig(std::make_shared<const LightRig>(std::move(rig))) {}

bool InlineRig::operator==(const InlineRig& other) const {
  if (m_rig == other.m_rig) return true;
  return m_rig && other.m_rig && *m_rig == *other.m_rig;
}

}  // namespace dermis
