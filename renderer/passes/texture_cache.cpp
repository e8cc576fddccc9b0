#include "passes/texture_cache.h"

#include <algorithm>
#include <chrono>

#include "colour/display_transform.h"
#include "core/base/background.h"

namespace dermis {

namespace {

/// What is larger doesn't fit into a frame: 1 MiB takes about 5 ms with its mips on software GL.
constexpr std::size_t kImmediateBytes = 1U << 20;
constexpr std::size_t kSliceBytes = 2U << 20;

bool isNormal(TextureSlot slot) { return slot == TextureSlot::Normal || slot == TextureSlot::DetailNormal; }

/// The channel that is read of an image with colours, where it is one alone.
std::optional<int> onlyChannelOf(const Image& image, const TextureBinding& binding, TextureSlot slot) {
  if (!textureSlotRow(slot).isScalar || image.channels < 3 || binding.channel == TextureChannel::Luminance)
    return std::nullopt;
  const int channel = static_cast<int>(binding.channel);
  return channel < image.channels ? std::optional(channel) : std::nullopt;
}

}  // namespace

TextureCache::TextureCache(int maximumSize, float anisotropy) : m_maximumSize(maximumSize), m_anisotropy(anisotropy) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  m_maximumSize = maximumSize > 0 ? std::min(maximumSize, most) : most;
}

TextureCache::Key TextureCache::keyOf(const Image& image, const TextureBinding& binding, TextureSlot slot) {
  return {&image, binding.colorSpace.value_or(""), textureSlotRow(slot).isColour, isNormal(slot),
          onlyChannelOf(image, binding, slot)};
}

bool TextureCache::has(const std::shared_ptr<const Image>& image, const TextureBinding& binding,
                       TextureSlot slot) const {
  return m_entries.contains(keyOf(*image, binding, slot));
}

TextureRecipe TextureCache::recipeFor(const Image& image, const TextureBinding& binding, TextureSlot slot,
                                      Warnings& messages) const {
  TextureRecipe recipe;
  Warnings warnings;
  if (auto found = textureColour(binding.colorSpace.value_or(""), textureSlotRow(slot).isColour,
                                 image.isFloatingPoint(), warnings))
    recipe.colour = *found;
  else
    messages.push_back(found.error().message);
  for (const std::string& warning : warnings) messages.push_back(image.name + ": " + warning);
  recipe.isNormal = isNormal(slot);
  recipe.channel = onlyChannelOf(image, binding, slot);
  recipe.maximumSize = m_maximumSize;
  return recipe;
}

bool TextureCache::request(const std::shared_ptr<const Image>& image, const TextureBinding& binding, TextureSlot slot,
                           Warnings& messages) {
  const Key key = keyOf(*image, binding, slot);
  if (m_entries.contains(key) || image->pixels.size() <= kImmediateBytes) return false;
  const auto same = [&](const Pending& pending) { return pending.key == key; };
  if (std::any_of(m_pending.begin(), m_pending.end(), same)) return true;
  Pending pending;
  pending.key = key;
  pending.image = image;
  pending.recipe = recipeFor(*image, binding, slot, messages);
  if (m_pending.empty()) m_asked = 0;
  ++m_asked;
  m_pending.push_back(std::move(pending));
  return true;
}

bool TextureCache::step(Warnings& messages) {
  if (m_pending.empty()) return true;
  // One is made ready while the one before is sent: two at most are in memory.
  for (std::size_t i = 0; i < std::min<std::size_t>(m_pending.size(), 2); ++i) {
    Pending& next = m_pending[i];
    if (next.prepared.valid() || next.upload) continue;
    next.prepared = std::async(std::launch::async, [image = next.image, recipe = next.recipe] {
      giveWay();
      return prepareTexture(image, recipe);
    });
  }
  Pending& first = m_pending.front();
  if (!first.upload) {
    // A short wait, so that running the job to its end doesn't spin.
    if (first.prepared.wait_for(std::chrono::milliseconds(2)) != std::future_status::ready) return false;
    PreparedTexture prepared = first.prepared.get();
    messages.insert(messages.end(), prepared.messages.begin(), prepared.messages.end());
    first.upload.emplace(std::move(prepared), m_anisotropy, first.image->name);
    return false;
  }
  if (!first.upload->step(kSliceBytes)) return false;
  first.image->pixels.giveBack();
  m_entries.emplace(first.key, Entry{first.image, std::make_shared<gl::Texture>(first.upload->take()), nullptr});
  ++m_uploaded;
  m_pending.pop_front();
  return m_pending.empty();
}

double TextureCache::fraction() const {
  return m_asked == 0 ? 1.0 : 1.0 - static_cast<double>(m_pending.size()) / static_cast<double>(m_asked);
}

void TextureCache::forgetPending() { m_pending.clear(); }

std::shared_ptr<const gl::Texture> TextureCache::get(const std::shared_ptr<const Image>& image,
                                                     const TextureBinding& binding, TextureSlot slot,
                                                     Warnings& messages, bool asArray) {
  const Key key = keyOf(*image, binding, slot);
  if (const auto it = m_entries.find(key); it != m_entries.end()) return shown(it->second, asArray);
  const auto same = [&](const Pending& pending) { return pending.key == key; };
  if (std::any_of(m_pending.begin(), m_pending.end(), same)) return nullptr;

  const TextureRecipe recipe = recipeFor(*image, binding, slot, messages);
  PreparedTexture prepared = prepareTexture(image, recipe);
  messages.insert(messages.end(), prepared.messages.begin(), prepared.messages.end());
  TextureUpload upload(std::move(prepared), m_anisotropy, image->name);
  while (!upload.step(kSliceBytes)) {
  }
  Entry entry{image, std::make_shared<gl::Texture>(upload.take()), nullptr};
  ++m_uploaded;
  return shown(m_entries.emplace(key, std::move(entry)).first->second, asArray);
}

std::shared_ptr<const gl::Texture> TextureCache::shown(Entry& entry, bool asArray) {
  if (!asArray || !entry.image->tiles.empty()) return entry.texture;
  if (!entry.array) entry.array = std::make_shared<gl::Texture>(entry.texture->asArray());
  return entry.array;
}

void TextureCache::releaseUnused() {
  m_released += std::erase_if(m_entries, [](const auto& entry) {
    const Entry& held = entry.second;
    return held.texture.use_count() == 1 && (!held.array || held.array.use_count() == 1);
  });
}

}  // namespace dermis
