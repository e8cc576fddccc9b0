// Materials and maps that come from elsewhere: pasted, dropped, read again, found again.
#include <QDir>
#include <QFileInfo>
#include <map>

#include "core/base/file_reference.h"
#include "core/io/udim.h"
#include "core/material/texture_match.h"
#include "ui/document/loading_run.h"
#include "ui/document/maps_read.h"
#include "ui/document/match_report.h"
#include "ui/document/material_images.h"
#include "ui/text.h"
#include "ui/translation.h"

namespace dermis {
namespace {

/// What a chosen file is bound as: one tile stands for its UDIM set.
std::filesystem::path setOrFile(const std::filesystem::path& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  return udimSetOf(file).value_or(file);
}

/// `now` with those fields that an edit of `before` has changed: the others may have been edited since.
TextureBinding onlyWhatChanged(const TextureBinding& before, const TextureBinding& edited, TextureBinding now) {
  const auto take = [&](auto TextureBinding::*field) {
    if (!(edited.*field == before.*field)) now.*field = edited.*field;
  };
  take(&TextureBinding::path);
  take(&TextureBinding::colorSpace);
  take(&TextureBinding::channel);
  take(&TextureBinding::invert);
  take(&TextureBinding::flipGreen);
  take(&TextureBinding::scale);
  take(&TextureBinding::uvScale);
  return now;
}

/// Whether a map could be read from there: a file, or a set with a tile.
bool isThere(const std::filesystem::path& path) { return !AssetCache::mapKey(path).empty(); }

}  // namespace

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
    binding.path = setOrFile(path).string();
    edits.push_back({slot, texture, binding, nullptr});
  }
  bindMaps(std::move(edits),
           tr("Assign %1 map to %2")
               .arg(tableText(textureSlotRow(texture).label).toLower(), slots_.join(QStringLiteral(", "))));
}

void Loading::bindMaps(std::vector<TextureEdit> edits, const QString& text) {
  if (edits.empty()) return;
  QString lane = QStringLiteral("maps");
  for (const TextureEdit& edit : edits)
    lane += QStringLiteral("/%1/%2").arg(edit.slot, dermis::text(textureSlotRow(edit.texture).id));
  const auto boundNow = [this](const TextureEdit& edit) {
    const SlotLook* look = m_document.slotLook(edit.slot);
    return look == nullptr ? TextureBinding{} : look->worn.material.texture(edit.texture);
  };
  std::map<std::pair<QString, TextureSlot>, TextureBinding> before;
  for (const TextureEdit& edit : edits) before[{edit.slot, edit.texture}] = boundNow(edit);
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
      [this, text, boundNow, before = std::move(before)](std::vector<TextureEdit>&& read) {
        for (TextureEdit& edit : read)
          edit.binding = onlyWhatChanged(before.at({edit.slot, edit.texture}), edit.binding, boundNow(edit));
        m_document.setTextures(read, text);
        Q_EMIT finished();
      });
}

void Loading::assignByName(const QStringList& slots_, const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> all;
  for (const QString& name : m_document.slotNames()) all.push_back(name.toStdString());
  std::vector<TextureEdit> edits;
  MatchReport report(slots_.size() > 1);
  for (const QString& slot : slots_) {
    const SlotLook* look = m_document.slotLook(slot);
    if (look == nullptr) continue;
    const ShadingModel model = look->worn.material.model;
    const TextureMatches matches = matchTextures(files, slot.toStdString(), all);
    report.leftOver(matches.leftOver, model);
    for (const TextureMatch& match : matches.maps) {
      if (!readsMap(model, match.texture)) {
        report.notRead(match, model);
        continue;
      }
      TextureBinding binding = look->worn.material.texture(match.texture);
      binding.path = setOrFile(match.path).string();
      binding.flipGreen = match.flipGreen;
      binding.invert = match.invert;
      binding.channel = match.channel;
      edits.push_back({slot, match.texture, binding, nullptr});
      report.used(slot, match);
    }
  }
  if (edits.empty()) {
    const QString why = report.whyNot();
    Q_EMIT message(MessageKind::Warning,
                   tr("No file there has a map's name, such as head_albedo.png or head_normal.png.") +
                       (why.isEmpty() ? QString() : QLatin1Char(' ') + why));
    return;
  }
  Q_EMIT mapsMatched(report.text());
  const int used = report.filesUsed(), left = report.filesLeft();
  Q_EMIT message(MessageKind::Info, tr("%n map(s) matched by name", nullptr, used) +
                                        (left == 0 ? QString() : tr(", %n file(s) not used", nullptr, left)));
  bindMaps(std::move(edits), tr("Assign %n map(s) to %1", nullptr, used).arg(slots_.join(QStringLiteral(", "))));
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
      if (!wanted && isThere(binding.path)) continue;
      // A sibling has kept its place relative to the one that was found, or lies right beside it.
      const std::filesystem::path old(binding.path);
      std::filesystem::path found = now / old.lexically_relative(before);
      if (!isThere(found)) found = now / old.filename();
      if (wanted) found = setOrFile(file);
      if (!isThere(found)) continue;
      binding.path = found.lexically_normal().string();
      edits.push_back({slot, row.slot, binding, nullptr});
    }
  }
  bindMaps(std::move(edits), tr("Locate %n map(s)", nullptr, static_cast<int>(edits.size())));
}

}  // namespace dermis
