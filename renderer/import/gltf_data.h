// glTF's buffers, views and accessors: read with every bound checked, and written again as one plain buffer of floats
// and 32-bit indices (quantised, normalised, strided and sparse accessors alike).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dermis::import {

/// A phrase that says what is wrong and where.
struct GltfError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class GltfData {
 public:
  /// Reads the buffers: the GLB's binary chunk, data URIs, files in the model's folder tree. Throws GltfError.
  GltfData(const nlohmann::json& document, std::string_view glbBinary, const std::filesystem::path& path);

  [[nodiscard]] std::size_t accessorCount(std::size_t accessor) const;

  // Each takes over what is asked for, once, and returns its index in the new document.
  std::size_t keepAttribute(std::size_t accessor, const std::string& name);
  /// All indices are below `vertices` afterwards.
  std::size_t keepIndices(std::size_t accessor, std::size_t vertices, const std::string& at);
  std::size_t keepMatrices(std::size_t accessor);
  std::size_t keepView(std::size_t view);
  /// A view with these bytes (an image that came as a data URI).
  std::size_t addView(std::string_view bytes);

  /// Throws where the kept accessor of joints holds one that the skin hasn't.
  void checkJoints(std::size_t kept, std::size_t joints, const std::string& at) const;

  /// /buffers, /bufferViews and /accessors of the new document.
  void writeTo(nlohmann::json& document) const;
  [[nodiscard]] const std::string& binary() const { return m_out; }

 private:
  struct Accessor {
    std::size_t count = 0;
    int componentType = 0;
    std::size_t components = 0;
    bool normalized = false;
  };
  void readBuffers(std::string_view glbBinary, const std::filesystem::path& path);
  [[nodiscard]] Accessor describe(std::size_t accessor) const;
  /// Bytes of a view, checked.
  [[nodiscard]] std::string_view view(std::size_t index) const;
  [[nodiscard]] std::vector<double> values(std::size_t accessor) const;
  void applySparse(const nlohmann::json& sparse, const Accessor& accessor, std::vector<double>& values,
                   const std::string& at) const;
  template <class T>
  std::size_t addAccessor(const std::vector<T>& values, int componentType, const char* type, std::size_t components);

  const nlohmann::json& m_in;
  std::vector<std::string> m_owned;
  std::vector<std::string_view> m_buffers;

  std::string m_out;
  nlohmann::json m_views = nlohmann::json::array();
  nlohmann::json m_accessors = nlohmann::json::array();
  std::map<std::string, std::size_t> m_kept;            ///< by use and accessor
  std::map<std::size_t, std::uint32_t> m_largestIndex;  ///< by kept accessor
};

/// The bytes of a `data:` URI. Throws GltfError where it isn't base64.
[[nodiscard]] std::string decodeDataUri(std::string_view uri);

}  // namespace dermis::import
