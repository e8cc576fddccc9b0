#include "ui/docks/material_panel.h"

#include <QComboBox>
#include <QDockWidget>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "core/material/value_json.h"
#include "ui/docks/material_clipboard.h"
#include "ui/docks/slot_chooser.h"
#include "ui/docks/slot_drag.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/colour_editor.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/rows/search_field.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"
#include "ui/translation.h"

namespace dermis {
namespace {

/// What the tool tip of a row says: meaning, unit, range, default, source.
QString helpFor(const ParameterRow& row) {
  QString help = tableText(row.sentence).toHtmlEscaped();
  const auto number = [](float v) { return QString::number(static_cast<double>(v), 'g', 6); };
  if (row.type == ParameterType::Enum || row.type == ParameterType::Bool)
    help += QStringLiteral("<br>");
  else
    help += QObject::tr("<br><br>Range %1 to %2 %3").arg(number(row.hardMin), number(row.hardMax), text(row.unit));
  if (row.type != ParameterType::Gaussians)
    help += QObject::tr("<br>Default %1").arg(text(parameterToText(row, row.defaultValue())));
  if (row.map)
    help += QObject::tr("<br>Multiplies the %1 map").arg(tableText(textureSlotRow(*row.map).label).toLower());
  if (!row.source.empty()) help += QObject::tr("<br>Source: %1").arg(text(row.source).toHtmlEscaped());
  return QStringLiteral("<qt>%1<br><span style='color:#909090'>%2</span></qt>").arg(help, text(row.id));
}

/// `mine` with one component of `edited`; all of it where no component is named.
ParameterValue onlyComponent(std::optional<int> component, const ParameterValue& edited, const ParameterValue& mine) {
  if (!component) return edited;
  const auto merged = [&](auto from, auto own) {
    own[*component] = from[*component];
    return ParameterValue(own);
  };
  if (const auto* v = std::get_if<glm::vec2>(&edited)) return merged(*v, std::get<glm::vec2>(mine));
  if (const auto* v = std::get_if<glm::vec3>(&edited)) return merged(*v, std::get<glm::vec3>(mine));
  return edited;
}

}  // namespace

MaterialPanel::MaterialPanel(Document& document, Loading& loading, QWidget* parent)
    : Panel(parent),
      m_document(document),
      m_loading(loading),
      m_clipboard(new MaterialClipboard(document, loading, this)) {
  buildStrip();
  buildRows();
  finish();
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything || what == Change::Material) refresh();
  });
  connect(&m_document, &Document::currentSlotChanged, this, &MaterialPanel::refresh);
  refresh();
}

void MaterialPanel::buildStrip() {
  auto* grid = new QGridLayout();
  grid->setHorizontalSpacing(metrics::kGap);
  grid->setVerticalSpacing(metrics::kGap);
  const auto label = [&](const QString& words, int row) {
    auto* l = new QLabel(words, this);
    l->setProperty("quiet", true);
    grid->addWidget(l, row, 0);
  };
  label(tr("Slot"), 0);
  m_slots = new SlotChooser(m_document, this);
  grid->addWidget(m_slots, 0, 1, 1, 2);
  label(tr("Model"), 1);
  m_model = new QuietComboBox(this);
  m_model->setObjectName(QStringLiteral("material.model"));
  m_model->setAccessibleName(tr("Shading model"));
  for (const ShadingModelRow& row : shadingModels()) {
    m_model->addItem(tableText(row.label));
    m_model->setItemData(m_model->count() - 1, tableText(row.sentence), Qt::ToolTipRole);
  }
  grid->addWidget(m_model, 1, 1, 1, 2);
  label(tr("Preset"), 2);
  m_preset = new SlotHandle(m_document, this);
  m_preset->setObjectName(QStringLiteral("material.preset"));
  m_preset->setTextFormat(Qt::PlainText);
  m_preset->setFixedHeight(metrics::kControlHeight);
  grid->addWidget(m_preset, 2, 1);
  auto* buttons = new QHBoxLayout();
  buttons->setSpacing(2);
  m_revert = iconButton("reset", tr("Revert to the preset"), this);
  m_revert->setObjectName(QStringLiteral("material.revert"));
  auto* save = iconButton("save", tr("Save preset…"), this);
  buttons->addWidget(m_revert);
  buttons->addWidget(save);
  grid->addLayout(buttons, 2, 2);
  grid->setColumnMinimumWidth(0, 48);
  grid->setColumnStretch(1, 1);
  strip()->addLayout(grid);
  m_search = new SearchField(tr("Search parameters"), QStringLiteral("material.search"), this);
  strip()->addWidget(m_search);

  connect(m_slots, &SlotChooser::presetDropped, this, [this](const QString& preset, const QStringList& slots_) {
    m_loading.applyPreset(preset.toStdString(), slots_);
  });
  connect(m_model, &QComboBox::activated, this, [this](int index) {
    m_document.setShadingModel(m_document.editedSlots(), shadingModels()[static_cast<std::size_t>(index)].model);
  });
  connect(m_search, &QLineEdit::textChanged, this, &MaterialPanel::refreshVisibility);
  connect(save, &QToolButton::clicked, this, &MaterialPanel::savePresetRequested);
  connect(m_revert, &QToolButton::clicked, this, [this] { m_loading.revertToPreset(m_document.editedSlots()); });
}

void MaterialPanel::buildRows() {
  std::map<std::string_view, GroupBox*> groups;
  for (const ParameterRow& parameter : parameterTable()) {
    GroupBox*& group = groups[parameter.group];
    if (group == nullptr) {
      group = addGroup(tableText(parameter.group), QStringLiteral("material/") + text(parameter.group));
      m_groups.push_back(group);
      group->addHeadActions({m_clipboard->copyGroupAction(text(parameter.group), group),
                             m_clipboard->copyMaterialAction(), m_clipboard->pasteAction()});
    }
    auto* row = new PropertyRow(tableText(parameter.group), tableText(parameter.label), text(parameter.id),
                                makeEditor(parameter), group);
    row->setDefault(parameter.defaultValue());
    row->setHelp(helpFor(parameter));
    row->setParameter(parameter);
    row->addActions({m_clipboard->copyGroupAction(text(parameter.group), row), m_clipboard->copyMaterialAction(),
                     m_clipboard->pasteAction()});
    group->addRow(row);
    connect(row, &PropertyRow::edited, this, [this, &parameter, row](const ParameterValue& value, Gesture gesture) {
      edit(parameter, value, row->editor()->editedComponent(), gesture);
    });
    m_entries.push_back({&parameter, row, group});
  }
  m_nothing = new QLabel(this);
  m_nothing->setProperty("quiet", true);
  m_nothing->setAlignment(Qt::AlignCenter);
  m_nothing->setWordWrap(true);
  m_nothing->setMargin(2 * metrics::kMargin);
  addWidget(m_nothing);
}

void MaterialPanel::edit(const ParameterRow& parameter, const ParameterValue& value, std::optional<int> component,
                         Gesture gesture) {
  if (m_document.currentLook() == nullptr) return;
  std::vector<ParameterEdit> edits;
  QStringList names;
  for (const QString& slot : m_document.editedSlots()) {
    const Material& material = m_document.slotLook(slot)->worn.material;
    // A slot whose model lacks the parameter is left alone: nobody would see the change.
    if (!parameter.usedBy(material.model)) continue;
    edits.push_back({slot, &parameter, onlyComponent(component, value, parameter.get(material.parameters))});
    names << slot;
  }
  m_document.setParameters(
      edits,
      tr("%1 › %2 of %3").arg(tableText(parameter.group), tableText(parameter.label), names.join(QStringLiteral(", "))),
      text(parameter.id), gesture);
}

QString MaterialPanel::differencesOf(const ParameterRow& parameter) const {
  std::optional<ParameterValue> first;
  bool differ = false;
  QStringList lines;
  for (const QString& slot : m_document.editedSlots()) {
    const Material& material = m_document.slotLook(slot)->worn.material;
    if (!parameter.usedBy(material.model)) continue;
    const ParameterValue value = parameter.get(material.parameters);
    differ = differ || (first && !(*first == value));
    if (!first) first = value;
    lines << slot + QStringLiteral(": ") + text(parameterToText(parameter, value));
  }
  return differ ? lines.join(QLatin1Char('\n')) : QString();
}

void MaterialPanel::refresh() {
  m_slots->refresh();
  const SlotLook* look = m_document.currentLook();
  setEnabled(look != nullptr);
  if (look == nullptr) return;
  const Material& material = look->worn.material;
  {
    const QSignalBlocker blocker(m_model);
    m_model->setCurrentIndex(static_cast<int>(material.model));
  }
  const bool edited = look->binding && look->binding->edited;
  const bool missing = look->binding && look->binding->missing;
  const QString name = material.name.empty() ? tr("no preset") : text(material.name);
  m_preset->setText(edited ? name + QStringLiteral(" *") : name);
  const QString help = tr("Drag it onto a part in the picture, or onto the box of slots: that part wears the same");
  m_preset->setToolTip(edited ? tr("Changed since the preset was applied") + QLatin1Char('\n') + help : help);
  m_revert->setEnabled((edited || missing) && (look->preset || !look->binding->presetPath.empty()));

  // Fresnel F0 shows what it follows while it has no value of its own.
  const float n = material.parameters.specularIor;
  const float root = (n - 1.0F) / (n + 1.0F);
  for (const Entry& entry : m_entries) {
    if (entry.parameter->type == ParameterType::OptionalColour)
      if (auto* colour = qobject_cast<ColourEditor*>(entry.row->editor())) colour->setAutomatic(glm::vec3(root * root));
    entry.row->showValue(entry.parameter->get(material.parameters));
    entry.row->setPresetValue(look->preset && look->preset->model == material.model
                                  ? std::optional(entry.parameter->get(look->preset->parameters))
                                  : std::nullopt);
    entry.row->showDifferences(m_document.editedSlots().size() > 1 ? differencesOf(*entry.parameter) : QString());
  }
  refreshVisibility();
}

void MaterialPanel::refreshVisibility() {
  const SlotLook* look = m_document.currentLook();
  if (look == nullptr) return;
  const QString words = m_search->text();
  std::map<GroupBox*, int> shown;
  int total = 0;
  for (const Entry& entry : m_entries) {
    const bool visible = entry.parameter->usedBy(look->worn.material.model) && entry.row->matches(words);
    entry.row->setVisible(visible);
    shown[entry.group] += visible ? 1 : 0;
    total += visible ? 1 : 0;
  }
  for (GroupBox* group : m_groups) {
    group->setVisible(shown[group] > 0);
    group->setForcedOpen(!words.simplified().isEmpty());
  }
  m_nothing->setVisible(total == 0);
  m_nothing->setText(words.isEmpty() ? tr("This shading model has no parameters: it mirrors the environment.")
                                     : tr("No parameter of this model matches “%1”.").arg(words));
}

void MaterialPanel::focusSearch() {
  for (QWidget* parent = parentWidget(); parent != nullptr; parent = parent->parentWidget())
    if (auto* dock = qobject_cast<QDockWidget*>(parent)) {
      dock->show();
      dock->raise();
    }
  m_search->setFocus(Qt::ShortcutFocusReason);
  m_search->selectAll();
}

}  // namespace dermis
