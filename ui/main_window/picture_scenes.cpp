#include "ui/main_window/picture_scenes.h"

#include <QMessageBox>
#include <QPushButton>

#include "core/base/json_text.h"
#include "core/io/importer.h"
#include "ui/document/loading.h"
#include "ui/jobs/task_runner.h"
#include "ui/text.h"

namespace dermis {

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

PictureScenes::PictureScenes(Loading& loading, TaskRunner& tasks, QWidget& window)
    : QObject(&window), m_loading(loading), m_tasks(tasks), m_window(window) {}

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
        if (question.clickedButton() == open && mayDiscard()) m_loading.openPictureScene(path, scene);
        if (question.clickedButton() == use) otherwise();
      });
}

}  // namespace dermis
