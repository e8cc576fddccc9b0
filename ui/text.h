// Between the core's UTF-8 and Qt's text.
#pragma once

#include <QString>
#include <filesystem>
#include <string>
#include <string_view>

namespace dermis {

[[nodiscard]] inline QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}
[[nodiscard]] inline QString pathText(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}
[[nodiscard]] inline std::filesystem::path toPath(const QString& text) {
  return std::filesystem::path(text.toStdString());
}

}  // namespace dermis
