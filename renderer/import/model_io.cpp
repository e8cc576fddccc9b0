#include "import/model_io.h"

#include <array>
#include <cstring>
#include <stdexcept>

#include "core/base/file_io.h"
#include "core/base/lower_case.h"
#include "import/text.h"

namespace dermis::import {
namespace {

namespace fs = std::filesystem;

class MemoryStream final : public Assimp::IOStream {
 public:
  MemoryStream(std::shared_ptr<const std::string> bytes, std::stop_token stop)
      : m_bytes(std::move(bytes)), m_stop(std::move(stop)) {}

  size_t Read(void* buffer, size_t size, size_t count) override {
    if (m_stop.stop_requested()) throw std::runtime_error("cancelled");
    if (size == 0 || count == 0) return 0;
    const size_t whole = std::min(count, (m_bytes->size() - m_at) / size);
    std::memcpy(buffer, m_bytes->data() + m_at, whole * size);
    m_at += whole * size;
    return whole;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    // The offset may be a negative number in disguise; the sum wraps back into range.
    const size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? m_at : m_bytes->size();
    const size_t target = base + offset;
    if (target > m_bytes->size()) return aiReturn_FAILURE;
    m_at = target;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return m_at; }
  size_t FileSize() const override { return m_bytes->size(); }
  void Flush() override {}

 private:
  std::shared_ptr<const std::string> m_bytes;
  std::stop_token m_stop;
  size_t m_at = 0;
};

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percentDecoded(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0) {
      out += static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2]));
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

/// The path below `folder` whose parts equal those of `relative` but for case. A folder of more than 10,000 entries
/// isn't searched.
fs::path ignoringCase(const fs::path& folder, const fs::path& relative) {
  fs::path at = folder;
  std::error_code error;
  for (const fs::path& part : relative) {
    if (part.empty() || part == ".") continue;
    if (part == ".." || fs::exists(at / part, error)) {
      at /= part;
      continue;
    }
    const std::string wanted = lowerCase(part.string());
    fs::path found;
    int entries = 0;
    for (fs::directory_iterator it(at, error), end; !error && it != end && entries < 10000;
         it.increment(error), ++entries)
      if (lowerCase(it->path().filename().string()) == wanted) found = it->path();
    if (found.empty()) return {};
    at = found;
  }
  return at;
}

bool isFile(const fs::path& path) {
  std::error_code error;
  return !path.empty() && fs::is_regular_file(path, error);
}

}  // namespace

fs::path findReferenced(const fs::path& folder, const std::string& reference) {
  if (reference.empty() || reference.size() > 4096 || reference.find('\0') != std::string::npos) return {};
  std::string slashed = reference;
  for (char& c : slashed)
    if (c == '\\') c = '/';
  if (slashed.starts_with("file://")) slashed.erase(0, 7);
  for (const std::string& text : {slashed, percentDecoded(slashed)}) {
    const fs::path path = text;
    if (path.is_absolute() && isFile(path)) return path.lexically_normal();
    if (path.is_relative()) {
      if (isFile(folder / path)) return (folder / path).lexically_normal();
      if (const fs::path found = ignoringCase(folder, path); isFile(found)) return found.lexically_normal();
    }
    // Paths of the author's machine: the file is often beside the model all the same.
    const fs::path bare = path.filename();
    for (const char* beside : {".", "textures", "maps", "tex", "../textures"})
      if (const fs::path found = ignoringCase(folder, std::filesystem::path(beside) / bare); isFile(found))
        return found.lexically_normal();
  }
  return {};
}

ModelFolder::ModelFolder(const fs::path& model) {
  std::error_code error;
  m_folder = fs::weakly_canonical(model.parent_path().empty() ? fs::path(".") : model.parent_path(), error);
}

fs::path ModelFolder::find(const std::string& reference) const {
  const fs::path found = findReferenced(m_folder, reference);
  if (found.empty()) return {};
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(found, error);
  if (error) return {};
  const fs::path below = canonical.lexically_relative(m_folder);
  return below.empty() || *below.begin() == ".." ? fs::path() : canonical;
}

ModelFiles::ModelFiles(fs::path name, std::shared_ptr<const std::string> bytes, std::stop_token stop)
    : m_model(std::move(name)),
      m_folder(m_model),
      m_bytes(std::move(bytes)),
      m_stop(std::move(stop)),
      m_total(m_bytes->size()) {}

bool ModelFiles::Exists(const char* file) const { return m_model == file || !m_folder.find(file).empty(); }

Assimp::IOStream* ModelFiles::Open(const char* file, const char* mode) {
  if (mode != nullptr && std::strpbrk(mode, "wa+") != nullptr) return nullptr;
  if (m_model == file) return new MemoryStream(m_bytes, m_stop);
  const fs::path path = m_folder.find(file);
  if (path.empty()) return nullptr;
  auto bytes = readFile(path, kLargestModelBytes - m_total);
  if (!bytes) return nullptr;
  m_total += bytes->size();
  return new MemoryStream(std::make_shared<const std::string>(std::move(*bytes)), m_stop);
}

void ModelFiles::Close(Assimp::IOStream* stream) { delete stream; }

bool StopWatcher::Update(float) {
  if (m_stop.stop_requested()) throw std::runtime_error("cancelled");
  return true;
}

}  // namespace dermis::import
