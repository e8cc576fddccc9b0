#include "ui/document/preset_memory.h"

namespace dermis {

bool PresetMemory::holds(const std::string& path, const Material& content) {
  if (path.empty()) return false;
  if (const auto move = m_moves.find(path); move != m_moves.end()) {
    if (move->second.to != path)
      m_moves.erase(move);
    else
      move->second.metadata = content.metadata;
  }
  std::shared_ptr<const Material>& known = m_contents[path];
  if (known && *known == content) return false;
  const bool other = known != nullptr;
  known = std::make_shared<const Material>(content);
  return other;
}

void PresetMemory::rewritten(const std::string& from, const std::string& to, const Material& before,
                             const Material& after) {
  m_moves.erase(to);  // nothing leads in a circle: the newest path leads nowhere
  if (const auto known = m_contents.find(from); known != m_contents.end()) {
    Material content = *known->second;
    content.name = after.name;
    content.metadata = after.metadata;
    m_contents.erase(known);
    m_contents[to] = std::make_shared<const Material>(std::move(content));
  }
  m_moves[from] = {to, before.name, after.name, after.metadata};
}

void PresetMemory::clear() {
  m_contents.clear();
  m_moves.clear();
}

bool PresetMemory::refresh(MaterialBinding& binding) const {
  const MaterialBinding before = binding;
  for (auto move = m_moves.find(binding.presetPath); move != m_moves.end(); move = m_moves.find(binding.presetPath)) {
    if (binding.material.name == move->second.oldName) binding.material.name = move->second.newName;
    binding.material.metadata = move->second.metadata;
    if (move->second.to == binding.presetPath) break;  // the same file, with other words in it
    binding.presetPath = move->second.to;
  }
  if (const auto known = m_contents.find(binding.presetPath); known != m_contents.end()) {
    binding.edited = !(*known->second == binding.material);
    binding.missing = false;
  }
  return !(binding == before);
}

bool PresetMemory::refresh(SlotLook& look) const {
  if (!look.binding) return false;
  const bool changed = refresh(*look.binding);
  look.worn.material.name = look.binding->material.name;
  look.worn.material.metadata = look.binding->material.metadata;
  if (const auto known = m_contents.find(look.binding->presetPath); known != m_contents.end())
    look.preset = known->second;
  return changed;
}

}  // namespace dermis
