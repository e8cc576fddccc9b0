#include "app/commands/support.h"
#include "core/base/lower_case.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace dermis::cli {

namespace fs = std::filesystem;

namespace {

constexpr int kLargestSide = 32768;

std::string inOneLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

tl::unexpected<Failure> failure(const Error& error) {
  return tl::unexpected(Failure{error.kind == Error::Kind::Input ? kUnusableInput : kFailed, error.message});
}

tl::unexpected<Failure> wrongUsage(std::string sentence) {
  return tl::unexpected(Failure{kWrongUsage, std::move(sentence)});
}

void printWarnings(Warnings& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", inOneLine(warning));
  warnings.clear();
}

int report(const Failure& failure) {
  fmt::print(stderr, "dermis: {}\n", inOneLine(failure.sentence));
  return failure.exitCode;
}

Outcome<void> checkOutputFile(const fs::path& path, std::span<const std::string_view> extensions) {
  const std::string extension = extensionOf(path);
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) {
    std::string known;
    for (const std::string_view e : extensions) known += (known.empty() ? "" : ", ") + std::string(e);
    return wrongUsage(fmt::format("{} cannot be written: its name must end in one of {}", path.string(), known));
  }
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    return failure(Error{Error::Kind::Runtime, fmt::format("{} cannot be written: there is no folder {}; make it first",
                                                           path.string(), folder.string())});
  if (fs::is_directory(path, error))
    return failure(Error{Error::Kind::Runtime, fmt::format("{} cannot be written: it is a folder", path.string())});
  if (access(folder.c_str(), W_OK) != 0)
    return failure(Error{Error::Kind::Runtime, fmt::format("{} cannot be written: the folder {} is read-only for you",
                                                           path.string(), folder.string())});
  return {};
}

std::string extensionOf(const fs::path& path) { return lowerCase(path.extension().string()); }

Outcome<glm::ivec2> parseSize(std::string_view text) {
  const auto wrong = [&] {
    return wrongUsage(fmt::format("the size \"{}\" is not WIDTHxHEIGHT in pixels, such as 1280x720, each from 1 to {}",
                                  text, kLargestSide));
  };
  const std::size_t cross = text.find_first_of("xX");
  if (cross == std::string_view::npos) return wrong();
  glm::ivec2 size(0);
  const auto read = [](std::string_view part, int& into) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), into);
    return error == std::errc() && end == part.data() + part.size() && into >= 1 && into <= kLargestSide;
  };
  if (!read(text.substr(0, cross), size.x) || !read(text.substr(cross + 1), size.y)) return wrong();
  return size;
}

ProgressLine::ProgressLine(bool wanted) : m_active(wanted && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(std::string_view what, double fraction) {
  if (!m_active) return;
  constexpr int kCells = 30;
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kCells);
  fmt::print(stderr, "\r\x1b[K[{:#<{}}{:.<{}}] {:3.0f} %  {}", "", filled, "", kCells - filled, 100.0 * fraction, what);
  std::fflush(stderr);
  m_shown = true;
}

void ProgressLine::clear() {
  if (m_shown) fmt::print(stderr, "\r\x1b[K");
  m_shown = false;
}

double cpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace dermis::cli
