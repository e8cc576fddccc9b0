// What Assimp may touch while it parses: files in the model's own folder tree, read whole and bounded; nothing is
// written.
#pragma once

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/ProgressHandler.hpp>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>

namespace dermis::import {

/// Bytes that one model with its side files may hold.
inline constexpr std::size_t kLargestModelBytes = std::size_t{4} << 30U;

/// The folder tree of a model, outside of which none of its data files is opened.
class ModelFolder {
 public:
  explicit ModelFolder(const std::filesystem::path& model);
  /// The file meant by a reference (backslashes, percent codes, any case); empty if it lies outside or is missing.
  [[nodiscard]] std::filesystem::path find(const std::string& reference) const;

 private:
  std::filesystem::path m_folder;
};

/// Gives out read-only streams over memory. The model itself was read by us; `name` is what Assimp
/// is told it is called.
class ModelFiles final : public Assimp::IOSystem {
 public:
  ModelFiles(std::filesystem::path name, std::shared_ptr<const std::string> bytes, std::stop_token stop);

  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  std::filesystem::path m_model;
  ModelFolder m_folder;
  std::shared_ptr<const std::string> m_bytes;
  std::stop_token m_stop;
  std::size_t m_total = 0;
};

/// Ends Assimp's work by an exception, which Assimp turns into a failed import.
class StopWatcher final : public Assimp::ProgressHandler {
 public:
  explicit StopWatcher(std::stop_token stop) : m_stop(std::move(stop)) {}
  bool Update(float percentage) override;

 private:
  std::stop_token m_stop;
};

/// `reference` as written in a file, looked up from `folder`: as it is, percent-decoded, ignoring case, and by its bare
/// name beside the model or in the usual folders. Empty if there is no such file.
[[nodiscard]] std::filesystem::path findReferenced(const std::filesystem::path& folder, const std::string& reference);

}  // namespace dermis::import
