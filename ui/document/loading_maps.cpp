// Materials and maps that come from elsewhere: pasted, dropped, read again, found again.
#include <QDir>
#include <QFileInfo>
#include <set>

#include "core/base/file_reference.h"
#include "core/material/texture_match.h"
#include "ui/document/loading_run.h"
#include "ui/document/maps_read.h"
#include "ui/document/material_images.h"
#include "ui/text.h"

namespace dermis {

void Loading::pasteMaterial(const QStringList& slots_, const Material& material) {
  run(
      QStringLiteral("paste"), tr("Pasting"),
      [material, model = m_document.model()](const ResolveOptions& options, Warnings& warnings) {
        return decodeMaps(material, model, options, warnings);
      },
      [this, slots_](ResolvedMaterial&& resolved) {
        m_document.pasteMaterial(slots_, resolved);
        Q_EMIT finished();
      });
}

void Loading::assignTexture(const QStringList& slots_, TextureSlot texture, const std::filesystem::path& path) {
  std::vector<TextureEdit> edits;
  for (const QString& slot : slots_) {
    const SlotLook* look = m_document.slotLook(slot);
    if (look == nullptr) continue;
    TextureBinding binding = look->worn.material.texture(texture);
    binding.path = std::filesystem::absolute(path).string();
    edits.push_back({slot, texture, binding, nullptr});
  }
  bindMaps(
      std::move(edits),
      tr("Assign %1 map to %2").arg(text(textureSlotRow(texture).label).toLower(), slots_.join(QStringLiteral(", "))));
}

void Loading::bindMaps(std::vector<TextureEdit> edits, const QString& text) {
  if (edits.empty()) return;
  QString lane = QStringLiteral("maps");
  for (const TextureEdit& edit : edits)
    lane += QStringLiteral("/%1/%2").arg(edit.slot, dermis::text(textureSlotRow(edit.texture).id));
  run(
      lane, tr("Loading maps"),
      [edits = std::move(edits)](const ResolveOptions& options,
                                 Warnings& warnings) -> Result<std::vector<TextureEdit>> {
        std::vector<TextureEdit> read;
        std::optional<Error> first;
        for (TextureEdit edit : edits) {
          if (options.stop.stop_requested()) return cancelledError();
          Result<std::shared_ptr<const Image>> image = resolveTexture(edit.binding.path, options, warnings);
          if (image) {
            edit.image = std::move(*image);
            read.push_back(std::move(edit));
            continue;
          }
          if (edits.size() > 1) warnings.push_back("left out " + image.error().message);
          if (!first) first = image.error();
        }
        if (read.empty()) return tl::unexpected(*first);
        return read;
      },
      [this, text](std::vector<TextureEdit>&& read) {
        m_document.setTextures(read, text);
        Q_EMIT finished();
      });
}

void Loading::assignByName(const QStringList& slots_, const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> all;
  for (const QString& name : m_document.slotNames()) all.push_back(name.toStdString());
  std::vector<TextureEdit> edits;
  std::set<std::filesystem::path> used;
  QStringList lines;
  for (const QString& slot : slots_) {
    const SlotLook* look = m_document.slotLook(slot);
    if (look == nullptr) continue;
    const TextureMatches matches = matchTextures(files, slot.toStdString(), all);
    for (const TextureMatch& match : matches.maps) {
      if (!readsMap(look->worn.material.model, match.texture)) continue;
      TextureBinding binding = look->worn.material.texture(match.texture);
      binding.path = std::filesystem::absolute(match.path).string();
      binding.flipGreen = match.flipGreen;
      binding.invert = match.invert;
      edits.push_back({slot, match.texture, binding, nullptr});
      used.insert(match.path);
      const QString line = tr("%1: %2").arg(text(textureSlotRow(match.texture).label), pathText(match.path.filename()));
      lines << (slots_.size() > 1 ? slot + QStringLiteral(" › ") + line : line);
    }
  }
  QStringList left;
  for (const std::filesystem::path& file : files)
    if (!used.contains(file)) left << pathText(file.filename());
  if (!left.isEmpty()) lines << tr("Not used: %1").arg(left.join(QStringLiteral(", ")));
  if (edits.empty()) {
    Q_EMIT message(MessageKind::Warning,
                   tr("No file there has a map's name, such as head_albedo.png or head_normal.png."));
    return;
  }
  Q_EMIT mapsMatched(lines.join(QLatin1Char('\n')));
  Q_EMIT message(
      MessageKind::Info,
      tr("%n map(s) matched by name", nullptr, static_cast<int>(used.size())) +
          (left.isEmpty() ? QString() : tr(", %n file(s) not used", nullptr, static_cast<int>(left.size()))));
  bindMaps(std::move(edits),
           tr("Assign %n map(s) to %1", nullptr, static_cast<int>(used.size())).arg(slots_.join(QStringLiteral(", "))));
}

void Loading::assignFolder(const QStringList& slots_, const QString& folder) {
  std::vector<std::filesystem::path> files;
  const QStringList patterns = namePatterns(FileKind::Image).split(QLatin1Char(' '));
  for (const QFileInfo& file : QDir(folder).entryInfoList(patterns, QDir::Files, QDir::Name))
    files.push_back(toPath(file.absoluteFilePath()));
  assignByName(slots_, files);
}

void Loading::rereadMap(const std::string& path, bool tellWhy) {
  const QString shown = QString::fromStdString(path);
  m_tasks.run(
      QStringLiteral("reread/") + shown, tr("Reading %1 again").arg(QFileInfo(shown).fileName()),
      [path, cache = m_cache](std::stop_token stop) {
        ResolveOptions options;
        options.stop = stop;
        options.cache = cache;
        Warnings warnings;
        Result<std::shared_ptr<const Image>> image = resolveTexture(path, options, warnings);
        return Outcome<std::shared_ptr<const Image>>{std::move(image), std::move(warnings)};
      },
      [this, path, shown, tellWhy](Outcome<std::shared_ptr<const Image>> outcome) {
        if (outcome.result) {
          tellWarnings(outcome.warnings);
          m_document.replaceImage(path, *outcome.result);
        } else if (tellWhy) {
          Q_EMIT message(MessageKind::Warning,
                         tr("%1; its last good picture stays").arg(text(outcome.result.error().message)));
        }
        Q_EMIT mapReread(shown, outcome.result.has_value());
      });
}

void Loading::locateMap(const std::string& missing, const std::filesystem::path& file) {
  const std::filesystem::path before = std::filesystem::path(missing).parent_path();
  const std::filesystem::path now = std::filesystem::absolute(file).parent_path();
  std::vector<TextureEdit> edits;
  for (const QString& slot : m_document.slotNames()) {
    const SlotLook& look = *m_document.slotLook(slot);
    for (const TextureSlotRow& row : textureSlots()) {
      TextureBinding binding = look.worn.material.texture(row.slot);
      const bool wanted = binding.path == missing;
      if (!binding.present() || namesNoFile(binding.path)) continue;
      if (!wanted && QFileInfo::exists(QString::fromStdString(binding.path))) continue;
      // A sibling has kept its place relative to the one that was found, or lies right beside it.
      const std::filesystem::path old(binding.path);
      std::error_code error;
      std::filesystem::path found = now / old.lexically_relative(before);
      if (!std::filesystem::is_regular_file(found, error)) found = now / old.filename();
      if (wanted) found = std::filesystem::absolute(file);
      if (!std::filesystem::is_regular_file(found, error)) continue;
      binding.path = found.lexically_normal().string();
      edits.push_back({slot, row.slot, binding, nullptr});
    }
  }
  bindMaps(std::move(edits), tr("Locate %n map(s)", nullptr, static_cast<int>(edits.size())));
}

}  // namespace dermis
