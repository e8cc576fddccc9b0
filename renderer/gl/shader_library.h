// Programs from shader files: #include, defines, a cache, and reloading that keeps the last good program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/result.h"
#include "gl/gl_objects.h"

namespace dermis::gl {

/// What a program is made of; two equal ones are one program. Paths are below resources/shaders/.
struct ProgramSources {
  std::string vertex, fragment;  ///< both, or
  std::string compute;           ///< this one
  /// "NAME" or "NAME VALUE", put in front of every stage. A value in quotes is a path that `#include NAME` takes.
  std::vector<std::string> defines;
  /// Text that exists in no file, by the path under which it is included: "generated/display_transform.glsl".
  std::map<std::string, std::string> generated;
  /// Between vertex and fragment: both or neither.
  std::string tessControl = {}, tessEvaluation = {};
  // clang-tidy 14 takes the 0 that <=> is compared with for a pointer. NOLINTNEXTLINE(modernize-use-nullptr)
  auto operator<=>(const ProgramSources&) const = default;
};

/// A linked program. The object stays where it is when a reload replaces what it holds.
class Program {
 public:
  void use() const { glUseProgram(m_handle.id()); }
  [[nodiscard]] GLuint id() const { return m_handle.id(); }
  /// Location of a uniform outside blocks; −1 where the linker removed it. Looked up once.
  [[nodiscard]] GLint uniform(std::string_view name) const;

 private:
  friend class ShaderLibrary;
  ProgramHandle m_handle;
  std::string m_error;  ///< of a first build that failed; compiled again only when a file changes
  ProgramSources m_sources;
  std::set<std::string> m_files;  ///< all that were read, includes too
  mutable std::map<std::string, GLint, std::less<>> m_uniforms;
};

/// All programs of one context. `#include "path/below/shaders.glsl"` is resolved recursively, each file once a stage;
/// `#version 450 core` and the defines are put in front. Files come from the binary, or from the folder named by the
/// environment variable DERMIS_SHADER_DIR. `generated/material_block.glsl` is the parameter table's block.
class ShaderLibrary {
 public:
  ShaderLibrary();
  /// For tests: reads from `folder` first, the binary after.
  explicit ShaderLibrary(std::filesystem::path folder);

  /// The program, compiled at the first call. Errors: Runtime, "surface.frag:12: …" as the compiler said; the same
  /// again at later calls without another try, until reloadChanged() finds an edit.
  [[nodiscard]] Result<const Program*> program(const ProgramSources& sources);
  /// Whether program() would return at once.
  [[nodiscard]] bool has(const ProgramSources& sources) const { return m_programs.contains(sources); }

  /// Recompiles the programs whose files changed on disk; a broken edit keeps the last good program and is reported as
  /// file:line in `messages`. True where a program changed. Does nothing without a folder.
  bool reloadChanged(Warnings& messages);
  /// Drops a program that is not needed any more (one generated for a view that is no longer shown).
  void forget(const ProgramSources& sources) { m_programs.erase(sources); }

  /// Programs compiled since the start, failed ones included.
  [[nodiscard]] std::uint64_t compileCount() const { return m_compileCount; }

  /// Where a line of the text given to the compiler comes from.
  struct Origin {
    std::size_t file = 0;  ///< index in Expanded::files
    int line = 0;          ///< 0: a line of ours
  };
  /// One stage's whole text, what the compiler gets, and where each line of it comes from. There are no #line
  /// directives: Mesa's compiler reports the file number of an expression in an included file wrongly.
  struct Expanded {
    std::string text;
    std::vector<std::string> files;
    std::vector<Origin> lines;  ///< of line i + 1
  };
  [[nodiscard]] Result<Expanded> expand(const std::string& path, const ProgramSources& sources) const;

 private:
  [[nodiscard]] std::string read(const std::string& path, const ProgramSources& sources, bool& found) const;
  [[nodiscard]] Result<void> build(Program& program);

  std::filesystem::path m_folder;
  std::map<ProgramSources, std::unique_ptr<Program>> m_programs;
  std::map<std::string, std::filesystem::file_time_type> m_seen;  ///< write times of files read from the folder
  std::uint64_t m_compileCount = 0;
};

/// Rewrites a compiler's "0:12(5): error: …" and "0(12) : error …" to "surface.frag:7: error: …". For tests and the
/// library.
[[nodiscard]] std::string nameFilesInLog(std::string_view log, const ShaderLibrary::Expanded& source);

}  // namespace dermis::gl
