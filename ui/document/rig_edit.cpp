#include "ui/document/rig_edit.h"

#include "core/base/lower_case.h"
#include "core/builtin/environments.h"
#include "core/light_rig/rig_io.h"
#include "ui/document/document.h"
#include "ui/jobs/task_runner.h"

namespace dermis {
namespace {

/// Texels around while a hand drags: a frame is not to wait for more.
constexpr int kCoarseWidth = 256;
constexpr int kPatienceMs = 400;

/// What gives the light, without what turns, dims and shows it.
EnvironmentSource lightOf(EnvironmentSource source) {
  source.rotationDegrees = 0.0F;
  source.exposureStops = 0.0F;
  source.background = {};
  return source;
}

std::optional<LightRig> rigOf(const EnvironmentSource& source) {
  if (source.rig) return *source.rig;
  if (source.constant || source.hasFaces()) return std::nullopt;
  Warnings ignored;  // said when it was loaded
  Result<LightRig> rig = inputError("no rig");
  if (source.path.empty())
    rig = builtinRig(source.builtin);
  else if (lowerCase(std::filesystem::path(source.path).extension().string()) == ".json")
    rig = loadRig(source.path, ignored);
  if (!rig) return std::nullopt;
  return std::move(*rig);
}

/// What a scene's own rig was made of: the built-in one of its name, else itself as it was opened.
LightRig originOf(const LightRig& own) {
  for (const BuiltinEnvironmentRow& row : builtinEnvironments())
    if (auto rig = builtinRig(row.id); rig && rig->name == own.name) return std::move(*rig);
  return own;
}

}  // namespace

RigEdit::RigEdit(Document& document, TaskRunner& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(kPatienceMs);
  connect(&m_soon, &QTimer::timeout, this, [this] { setPictureBusy(false); });
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Environment) follow();
  });
  // Whoever cancels what is going on cancels this too; the light has to follow the rig all the same.
  connect(&m_tasks, &TaskRunner::activityChanged, this, [this] {
    if (m_baking && !m_tasks.busy(QStringLiteral("rig")) && !m_soon.isActive()) m_soon.start();
  });
  follow();
}

bool RigEdit::isOwn() const { return static_cast<bool>(m_document.scene().environment.rig); }
const RigElement* RigEdit::original(std::size_t index) const {
  if (!m_rig || !m_original || index >= m_rig->elements.size() || index >= m_original->elements.size()) return nullptr;
  const RigElement& before = m_original->elements[index];
  return before.type == m_rig->elements[index].type ? &before : nullptr;
}

float RigEdit::rotationDegrees() const { return m_document.scene().environment.rotationDegrees; }

void RigEdit::follow() {
  if (!m_document.isReady()) return;
  const EnvironmentSource now = lightOf(m_document.scene().environment);
  // What came with its light is the light of what it came with.
  std::erase_if(m_known, [](const auto& entry) { return entry.first.expired(); });
  m_known.try_emplace(m_document.environmentImages(), now);
  if (!(m_of == now) || !m_rig) {
    m_of = now;
    m_rig = rigOf(now);
    if (m_rig && !now.rig)
      m_original = m_rig;
    else if (m_rig && (!m_original || m_original->name != m_rig->name))
      m_original = originOf(*m_rig);
    if (m_selected >= 0 && (!m_rig || m_selected >= static_cast<int>(m_rig->elements.size()))) select(-1);
    Q_EMIT changed();
  }
  bake();
}

bool RigEdit::lightIsCurrent() const {
  const auto& images = m_document.environmentImages();
  const auto known = m_known.find(images);
  if (known == m_known.end()) return true;
  return known->second == lightOf(m_document.scene().environment) && (m_dragging || !images->preview);
}

void RigEdit::bake() {
  if (!isOwn() || lightIsCurrent()) return;
  EnvironmentSource source = lightOf(m_document.scene().environment);
  // A coarse one comes to its end, or a hand that never rests would never see any; a whole one is for the last value.
  const bool running = m_baking && m_tasks.busy(QStringLiteral("rig"));
  if (m_dragging && (running || m_pictureBusy)) return;
  if (!m_dragging && running && !m_bakingCoarse && m_bakingFor == source) return;
  m_baking = true;
  m_bakingCoarse = m_dragging;
  m_bakingFor = source;
  m_tasks.run(
      QStringLiteral("rig"), m_dragging ? QString() : tr("Lighting"),
      [rig = source.rig, coarse = m_dragging](const std::stop_token& stop) {
        auto made = environmentOfRig(*rig, rig->name, coarse ? kCoarseWidth : 0, stop);
        if (!made || !coarse) return made;
        auto preview = std::make_shared<EnvironmentImages>(**made);
        preview->preview = true;
        return Result<std::shared_ptr<const EnvironmentImages>>(std::move(preview));
      },
      [this, source](Result<std::shared_ptr<const EnvironmentImages>> made) {
        m_baking = false;
        if (!made) return;
        m_known[*made] = source;
        if (!isOwn()) return;
        m_pictureBusy = true;
        m_soon.start();
        m_document.setRigImages(*made);
      });
}

void RigEdit::setElement(std::size_t index, const RigElement& element, const QString& text, Gesture gesture) {
  if (!m_rig || index >= m_rig->elements.size() || m_rig->elements[index] == element) return;
  if (gesture == 0 || gesture != m_gesture) {
    m_gesture = gesture;
    m_startRig = *m_rig;
    m_start = {m_document.scene().environment, m_document.environmentImages()};
  }
  LightRig next = *m_rig;
  next.elements[index] = element;
  if (next == m_startRig) {
    m_document.setEnvironmentLook(m_start, text, gesture);
    return;
  }
  EnvironmentSource source = m_document.scene().environment;
  source.path.clear();
  source.builtin.clear();
  source.faces = {};
  source.constant.reset();
  source.rig = InlineRig(std::move(next));
  m_document.setEnvironmentLook({std::move(source), m_document.environmentImages()}, text, gesture);
}

void RigEdit::setDragging(bool dragging) {
  if (m_dragging == dragging) return;
  m_dragging = dragging;
  if (!dragging) bake();
}

void RigEdit::setPictureBusy(bool busy) {
  m_pictureBusy = busy;
  if (busy) {
    // Other work than this light's may last as long as the hand holds on: the light doesn't wait for it.
    if (!m_soon.isActive()) m_soon.start();
    return;
  }
  m_soon.stop();
  bake();
}

void RigEdit::select(int element) {
  if (element == m_selected) return;
  m_selected = element;
  Q_EMIT selectionChanged(element);
}

}  // namespace dermis
