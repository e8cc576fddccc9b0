#include "ui/document/preset_memory.h"

namespace dermis {

bool PresetMemory::holds(const std::string& path, const Material& content) {
  if (path.empty()) return false;
  m_moves.erase(path);
  std::shared_ptr<const Material>& known = m_contents[path];
  if (known && *known == content) return false;
  const bool other = known != nullptr;
  known = std::make_shared<const Material>(content);
  return other;
}

void PresetMemory::moved(const std::string& from, const std::string& to, const std::string& oldName,
                         const std::string& newName) {
  m_moves.erase(to);  // nothing leads in a circle: the newest path leads nowhere
  if (const auto known = m_contents.find(from); known != m_contents.end()) {
    Material content = *known->second;
    content.name = newName;
    m_contents.erase(known);
    m_contents[to] = std::make_shared<const Material>(std::move(content));
  }
  m_moves[from] = {to, oldName, newName};
}

void PresetMemory::clear() {
  m_contents.clear();
  m_moves.clear();
}

bool PresetMemory::refresh(MaterialBinding& binding) const {
  const MaterialBinding before = binding;
  for (auto move = m_moves.find(binding.presetPath); move != m_moves.end(); move = m_moves.find(binding.presetPath)) {
    if (binding.material.name == move->second.oldName) binding.material.name = move->second.newName;
    if (move->second.to == binding.presetPath) break;  // only the name in the file is another
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
  if (const auto known = m_contents.find(look.binding->presetPath); known != m_contents.end())
    look.preset = known->second;
  return changed;
}

}  // namespace dermis
