#include "gl/shader_library.h"

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <sstream>

#include "core/base/resources.h"
#include "core/material/parameter_table.h"

namespace dermis::gl {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// The value of a define, without its name; empty where it has none or isn't there.
std::string_view defineValue(const ProgramSources& sources, std::string_view name) {
  for (const std::string& define : sources.defines) {
    const std::string_view text = define;
    if (text.starts_with(name) && text.size() > name.size() && text[name.size()] == ' ')
      return trimmed(text.substr(name.size()));
  }
  return {};
}

std::string stageLog(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

std::string programLog(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

/// The log's first error, or all of it where none is marked.
std::string firstError(const std::string& log) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.find("error") != std::string::npos) return line;
  return std::string(trimmed(log));
}

std::string nameOf(const ProgramSources& sources) {
  return sources.compute.empty() ? sources.fragment : sources.compute;
}

}  // namespace

std::string nameFilesInLog(std::string_view log, const ShaderLibrary::Expanded& source) {
  // Mesa: "0:12(5): error: …"; NVIDIA: "0(12) : error C1008: …"; others: "ERROR: 0:12: …".
  static const std::regex kMesa(R"(^(?:ERROR: |WARNING: )?(\d+):(\d+)(?:\(\d+\))?:\s*)");
  static const std::regex kNvidia(R"(^(\d+)\((\d+)\)\s*:\s*)");
  std::string result;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if ((std::regex_search(line, match, kMesa) || std::regex_search(line, match, kNvidia)) && match[1].length() < 6) {
      const std::size_t number = match[2].length() < 9 ? std::stoul(match[2].str()) : 0;
      if (number >= 1 && number <= source.lines.size() && source.lines[number - 1].line > 0) {
        const ShaderLibrary::Origin& origin = source.lines[number - 1];
        const std::string rest = match.suffix().str();
        line = source.files[origin.file] + ":" + std::to_string(origin.line) + ": " + rest;
      }
    }
    result += line + '\n';
  }
  return result;
}

GLint Program::uniform(std::string_view name) const {
  const auto known = m_uniforms.find(name);
  if (known != m_uniforms.end()) return known->second;
  const std::string text(name);
  return m_uniforms.emplace(text, glGetUniformLocation(id(), text.c_str())).first->second;
}

ShaderLibrary::ShaderLibrary() {
  if (const char* folder = std::getenv("DERMIS_SHADER_DIR"); folder != nullptr) m_folder = folder;
}

ShaderLibrary::ShaderLibrary(std::filesystem::path folder) : m_folder(std::move(folder)) {}

std::string ShaderLibrary::read(const std::string& path, const ProgramSources& sources, bool& found) const {
  found = true;
  if (path == "generated/material_block.glsl") return materialBlockGlsl();
  if (const auto it = sources.generated.find(path); it != sources.generated.end()) return it->second;
  if (!m_folder.empty()) {
    if (std::ifstream file(m_folder / path, std::ios::binary); file)
      return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  const std::string_view embedded = resource("shaders/" + path);
  found = embedded.data() != nullptr;
  return std::string(embedded);
}

Result<ShaderLibrary::Expanded> ShaderLibrary::expand(const std::string& path, const ProgramSources& sources) const {
  Expanded out;
  const auto add = [&out](const std::string& line, Origin origin) {
    out.text += line + '\n';
    out.lines.push_back(origin);
  };
  add("#version 450 core", {});
  for (const std::string& define : sources.defines) {
    // A quoted value names a file to include; it is for us, the compiler would choke on the quotes.
    if (define.find('"') == std::string::npos) add("#define " + define, {});
  }
  static const std::regex kInclude(R"(^\s*#\s*include\s+(?:"([^"]+)\"|(\w+))\s*(?://.*)?$)");
  const std::function<Result<void>(const std::string&, const std::string&)> append =
      [&](const std::string& file, const std::string& from) -> Result<void> {
    if (std::find(out.files.begin(), out.files.end(), file) != out.files.end()) return {};  // once a stage
    bool found = false;
    const std::string text = read(file, sources, found);
    if (!found) return runtimeError(from + ": no shader file \"" + file + "\".");
    const std::size_t number = out.files.size();
    out.files.push_back(file);
    std::istringstream lines(text);
    int lineNumber = 0;
    for (std::string line; std::getline(lines, line);) {
      ++lineNumber;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      std::smatch match;
      if (trimmed(line).starts_with("#version")) line.clear();  // ours stands in front already
      if (line.find('#') != std::string::npos && std::regex_match(line, match, kInclude)) {
        std::string target = match[1].str();
        if (target.empty()) {
          const std::string_view value = defineValue(sources, match[2].str());
          if (value.size() > 2 && value.front() == '"') target = value.substr(1, value.size() - 2);
        }
        const std::string place = file + ":" + std::to_string(lineNumber);
        if (target.empty()) return runtimeError(place + ": #include " + match[2].str() + " names no file.");
        if (auto done = append(target, place); !done) return done;
        continue;
      }
      add(line, {number, lineNumber});
    }
    return {};
  };
  if (auto done = append(path, "shader library"); !done) return tl::unexpected(done.error());
  return out;
}

Result<void> ShaderLibrary::build(Program& program) {
  const ProgramSources& sources = program.m_sources;
  ++m_compileCount;
  program.m_files.clear();
  struct Stage {
    GLenum type;
    const std::string* path;
  };
  std::vector<Stage> stages;
  if (!sources.compute.empty()) {
    stages = {{GL_COMPUTE_SHADER, &sources.compute}};
  } else {
    stages = {{GL_VERTEX_SHADER, &sources.vertex}, {GL_FRAGMENT_SHADER, &sources.fragment}};
    if (!sources.tessControl.empty()) {
      stages.push_back({GL_TESS_CONTROL_SHADER, &sources.tessControl});
      stages.push_back({GL_TESS_EVALUATION_SHADER, &sources.tessEvaluation});
    }
  }
  ProgramHandle linked(glCreateProgram());
  for (const Stage& stage : stages) {
    auto expanded = expand(*stage.path, sources);
    if (!expanded) {
      program.m_files.insert(*stage.path);
      return tl::unexpected(expanded.error());
    }
    program.m_files.insert(expanded->files.begin(), expanded->files.end());
    const GLuint shader = glCreateShader(stage.type);
    const char* text = expanded->text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    const std::string log = ok != 0 ? std::string() : nameFilesInLog(stageLog(shader), *expanded);
    if (ok != 0) glAttachShader(linked.id(), shader);
    glDeleteShader(shader);  // lives on with the program it is attached to
    if (ok == 0) return runtimeError(firstError(log));
  }
  glLinkProgram(linked.id());
  GLint ok = 0;
  glGetProgramiv(linked.id(), GL_LINK_STATUS, &ok);
  if (ok == 0) return runtimeError(nameOf(sources) + ": does not link: " + firstError(programLog(linked.id())));
  label(GL_PROGRAM, linked.id(), nameOf(sources));
  program.m_handle = std::move(linked);
  program.m_uniforms.clear();
  return {};
}

Result<const Program*> ShaderLibrary::program(const ProgramSources& sources) {
  if (const auto it = m_programs.find(sources); it != m_programs.end()) {
    if (!it->second->m_handle) return runtimeError(it->second->m_error);
    return it->second.get();
  }
  auto program = std::make_unique<Program>();
  program->m_sources = sources;
  auto built = build(*program);
  if (!m_folder.empty()) {
    for (const std::string& file : program->m_files) {
      std::error_code missing;
      const auto time = std::filesystem::last_write_time(m_folder / file, missing);
      if (!missing) m_seen[file] = time;
    }
  }
  if (!built) program->m_error = built.error().message;
  const Program* result = m_programs.emplace(sources, std::move(program)).first->second.get();
  if (!built) return tl::unexpected(built.error());
  return result;
}

bool ShaderLibrary::reloadChanged(Warnings& messages) {
  if (m_folder.empty()) return false;
  std::set<std::string> changed;
  std::set<std::string> files;
  for (const auto& [sources, program] : m_programs) files.insert(program->m_files.begin(), program->m_files.end());
  for (const std::string& file : files) {
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(m_folder / file, missing);
    if (missing) continue;
    auto [seen, isNew] = m_seen.try_emplace(file, time);
    if (isNew || seen->second != time) changed.insert(file);
    seen->second = time;
  }
  if (changed.empty()) return false;
  bool replaced = false;
  std::set<std::string> said;  // one broken include breaks many programs: say it once
  for (const auto& [sources, program] : m_programs) {
    const bool touched = std::any_of(program->m_files.begin(), program->m_files.end(),
                                     [&](const std::string& file) { return changed.contains(file); });
    if (!touched) continue;
    const std::set<std::string> before = program->m_files;
    if (auto built = build(*program); built) {
      replaced = true;
    } else {
      program->m_files.insert(before.begin(), before.end());
      const bool hasGood = static_cast<bool>(program->m_handle);
      if (!hasGood) program->m_error = built.error().message;
      if (said.insert(built.error().message).second)
        messages.push_back(built.error().message + (hasGood ? " (the last good program stays)" : ""));
    }
  }
  return replaced;
}

}  // namespace dermis::gl
