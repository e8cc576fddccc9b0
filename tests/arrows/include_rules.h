// Which headers a layer may not include, and the search for those that do.
#pragma once

#include <filesystem>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace dermis::arrows {

/// An #include line: the text between its quotes or brackets, and the line it stands on (from 1).
struct Include {
  std::string header;
  int line = 0;
};

/// Families of headers. Each pattern is matched against the whole text between the brackets.
inline const std::regex kGl(
    R"((epoxy|GL|EGL|GLES[23]?|KHR)/.*|.*\bgl_objects\.h|(.*/)?gl/.*|QOpenGL.*|Qt\w*OpenGL\w*(/.*)?)");
inline const std::regex kQt(R"(Q[A-Z]\w*|Qt\w*/.*|q[a-z0-9]+\.h)");
inline const std::regex kAssimp(R"(assimp/.*)");
inline const std::regex kOpenImageIo(R"((OpenImageIO|OpenEXR|Imath)/.*)");
inline const std::regex kOpenColorIo(R"(OpenColorIO/.*)");
inline const std::regex kJson(R"(nlohmann/.*)");
inline const std::regex kCommandLine(R"(CLI/.*)");
inline const std::regex kUi(R"((\.\./)*ui/.*)");
inline const std::regex kApp(R"((\.\./)*app/.*)");
inline const std::regex kImport(R"((.*/)?import/.*)");

/// The includes of a source text. Those inside // comments don't count.
[[nodiscard]] std::vector<Include> includesOf(std::string_view text);

/// "FILE:LINE includes HEADER" for each include in the sources below `folder` that one of the patterns matches. Files
/// below a folder named in `except` (relative to `folder`, e.g. "core") are another layer's.
[[nodiscard]] std::vector<std::string> violations(const std::filesystem::path& folder,
                                                  const std::vector<std::regex>& never,
                                                  const std::vector<std::string>& except = {});

}  // namespace dermis::arrows
