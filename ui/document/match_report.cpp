#include "ui/document/match_report.h"

#include <QCoreApplication>
#include <array>

#include "core/io/udim.h"
#include "ui/text.h"
#include "ui/translation.h"

namespace dermis {
namespace {

QString words(const char* text) { return QCoreApplication::translate("dermis::MatchReport", text); }

std::filesystem::path setOrFile(const std::filesystem::path& file) { return udimSetOf(file).value_or(file); }

QString modelName(ShadingModel model) { return tableText(shadingModelRow(model).label); }

}  // namespace

void MatchReport::used(const QString& slot, const TextureMatch& match) {
  const std::filesystem::path file = setOrFile(match.path);
  m_used.insert(file);
  static constexpr std::array kChannels = {"R", "G", "B", "A", ""};
  QString line = words(QT_TRANSLATE_NOOP("dermis::MatchReport", "%1: %2"))
                     .arg(tableText(textureSlotRow(match.texture).label), pathText(file.filename()));
  if (match.channel != TextureChannel::R)
    line = words(QT_TRANSLATE_NOOP("dermis::MatchReport", "%1, channel %2"))
               .arg(line, QLatin1String(kChannels.at(static_cast<std::size_t>(match.channel))));
  if (match.invert) line = words(QT_TRANSLATE_NOOP("dermis::MatchReport", "%1, inverted")).arg(line);
  if (match.flipGreen) line = words(QT_TRANSLATE_NOOP("dermis::MatchReport", "%1, green flipped")).arg(line);
  m_lines << (m_namesSlots ? slot + QStringLiteral(" › ") + line : line);
}

void MatchReport::notRead(const TextureMatch& match, ShadingModel model) {
  m_left.try_emplace(setOrFile(match.path),
                     Reason{words(QT_TRANSLATE_NOOP("dermis::MatchReport", "the model %1 has no %2 map"))
                                .arg(modelName(model), tableText(textureSlotRow(match.texture).label).toLower()),
                            true});
}

void MatchReport::leftOver(const std::vector<TextureLeftOver>& files, ShadingModel model) {
  for (const TextureLeftOver& left : files) {
    Reason reason;
    reason.isKnown = left.why != TextureLeftOver::Why::NoMapsName;
    switch (left.why) {
      case TextureLeftOver::Why::NoMapsName:
        reason.words = words(QT_TRANSLATE_NOOP("dermis::MatchReport", "no map's name"));
        break;
      case TextureLeftOver::Why::OtherSlot:
        reason.words = words(QT_TRANSLATE_NOOP("dermis::MatchReport", "names another slot"));
        break;
      case TextureLeftOver::Why::Poorer:
        reason.words = words(QT_TRANSLATE_NOOP("dermis::MatchReport", "another file is better for it"));
        break;
      case TextureLeftOver::Why::Opacity:
        reason.words =
            model == ShadingModel::MetallicRoughness
                ? words(QT_TRANSLATE_NOOP("dermis::MatchReport",
                                          "no opacity map of its own; put it in the alpha of the albedo map"))
                : words(QT_TRANSLATE_NOOP("dermis::MatchReport", "the model %1 has no opacity")).arg(modelName(model));
        break;
    }
    m_left.try_emplace(setOrFile(left.path), std::move(reason));
  }
}

std::map<std::filesystem::path, MatchReport::Reason> MatchReport::unused() const {
  std::map<std::filesystem::path, Reason> left;
  for (const auto& [file, reason] : m_left)
    if (!m_used.contains(file)) left.emplace(file, reason);
  return left;
}

QString MatchReport::text() const {
  QStringList lines = m_lines;
  for (const auto& [file, reason] : unused())
    lines << words(QT_TRANSLATE_NOOP("dermis::MatchReport", "Not used: %1 (%2)"))
                 .arg(pathText(file.filename()), reason.words);
  return lines.join(QLatin1Char('\n'));
}

QString MatchReport::whyNot() const {
  QStringList parts;
  for (const auto& [file, reason] : unused())
    if (reason.isKnown) parts << pathText(file.filename()) + QStringLiteral(": ") + reason.words;
  return parts.isEmpty() ? QString() : parts.join(QStringLiteral("; ")) + QLatin1Char('.');
}

}  // namespace dermis
