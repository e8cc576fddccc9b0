#include "ui/main_window/picture_scenes.h"

#include <QMessageBox>
#include <QPushButton>

#include "core/base/json_text.h"
#include "core/io/asset_loader.h"
#include "core/io/importer.h"
#include "core/scene/scene_io.h"
#include "ui/document/document.h"
#include "ui/jobs/task_runner.h"
#include "ui/text.h"

namespace dermis {
namespace {

struct Opened {
  Result<ResolvedScene> scene;
  Warnings warnings;
};

}  // namespace

std::string sceneTextOfPicture(const std::filesystem::path& path) {
  const Result<const Importer*> module = importer();
  if (!module) return {};
  const Result<ImageInfo> info = (*module)->inspectImage(path);
  if (!info) return {};
  const auto found = info->metadata.find("dermis");
  if (found == info->metadata.end()) return {};
  const auto json = parseJson(found->second, path.string());
  if (!json || !json->is_object() || !json->contains("scene")) return {};
  return json->at("scene").dump();
}

PictureScenes::PictureScenes(Document& document, TaskRunner& tasks, QWidget& window)
    : QObject(&window), m_document(document), m_tasks(tasks), m_window(window) {}

void PictureScenes::offer(const std::filesystem::path& path, std::function<bool()> mayDiscard,
                          std::function<void()> otherwise) {
  m_tasks.run(
      QStringLiteral("picture scene"), tr("Reading %1").arg(pathText(path.filename())),
      [path](std::stop_token) { return sceneTextOfPicture(path); },
      [this, path, mayDiscard = std::move(mayDiscard), otherwise = std::move(otherwise)](const std::string& scene) {
        if (scene.empty()) return otherwise();
        QMessageBox question(QMessageBox::Question, tr("A picture of a scene"),
                             tr("“%1” remembers the scene that it was made of.").arg(pathText(path.filename())),
                             QMessageBox::Cancel, &m_window);
        question.setObjectName(QStringLiteral("pictureScene"));
        question.setInformativeText(tr("Open that scene, or use the picture as an environment?"));
        QPushButton* open = question.addButton(tr("Open the scene"), QMessageBox::AcceptRole);
        open->setObjectName(QStringLiteral("pictureScene.open"));
        QPushButton* use = question.addButton(tr("Use as environment"), QMessageBox::ActionRole);
        question.setDefaultButton(open);
        question.exec();
        if (question.clickedButton() == open && mayDiscard()) this->open(path, scene);
        if (question.clickedButton() == use) otherwise();
      });
}

void PictureScenes::open(const std::filesystem::path& path, const std::string& scene) {
  m_tasks.run(
      QStringLiteral("scene"), tr("Opening the scene of %1").arg(pathText(path.filename())),
      [path, scene](std::stop_token stop) {
        // What the picture names lies beside it, if it is still there.
        const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
        Warnings warnings;
        const Result<Scene> read = readScene(scene, path.string(), folder, warnings);
        if (!read) return Opened{tl::unexpected(read.error()), warnings};
        ResolveOptions options;
        options.stop = stop;
        Result<ResolvedScene> resolved = resolveScene(*read, folder, options, warnings);
        return Opened{std::move(resolved), warnings};
      },
      [this](const Opened& opened) {
        for (const std::string& warning : opened.warnings) Q_EMIT message(MessageKind::Warning, text(warning));
        if (!opened.scene) {
          if (opened.scene.error().kind != Error::Kind::Cancelled)
            Q_EMIT message(MessageKind::Error, text(opened.scene.error().message));
          return;
        }
        m_document.replace(*opened.scene, {});
        Q_EMIT finished();
      });
}

}  // namespace dermis
