#include "ui/docks/material_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <algorithm>

#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/colour_editor.h"
#include "ui/rows/group_box.h"
#include "ui/rows/property_row.h"
#include "ui/text.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {

/// What the tool tip of a row says: meaning, unit, range, source.
QString helpFor(const ParameterRow& row) {
  QString help = text(row.sentence);
  const auto number = [](float v) { return QString::number(static_cast<double>(v), 'g', 6); };
  if (row.type == ParameterType::Enum || row.type == ParameterType::Bool)
    help += QStringLiteral("<br>");
  else
    help += QObject::tr("<br><br>Range %1 to %2 %3").arg(number(row.hardMin), number(row.hardMax), text(row.unit));
  if (row.map) help += QObject::tr("<br>Multiplies the %1 map").arg(text(textureSlotRow(*row.map).label).toLower());
  if (!row.source.empty()) help += QObject::tr("<br>Source: %1").arg(text(row.source));
  return QStringLiteral("<qt>%1<br><span style='color:#909090'>%2</span></qt>").arg(help, text(row.id));
}

}  // namespace

MaterialPanel::MaterialPanel(Document& document, Loading& loading, QWidget* parent)
    : Panel(parent), m_document(document), m_loading(loading) {
  buildStrip();
  buildRows();
  finish();
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what == Change::Everything) refreshSlots();
    if (what == Change::Everything || what == Change::Material) refresh();
  });
  connect(&m_document, &Document::currentSlotChanged, this, [this] {
    refreshSlots();
    refresh();
  });
  refreshSlots();
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
  m_slot = new QuietComboBox(this);
  m_slot->setObjectName(QStringLiteral("material.slot"));
  m_slot->setAccessibleName(tr("Material slot"));
  grid->addWidget(m_slot, 0, 1, 1, 2);
  label(tr("Model"), 1);
  m_model = new QuietComboBox(this);
  m_model->setObjectName(QStringLiteral("material.model"));
  m_model->setAccessibleName(tr("Shading model"));
  for (const ShadingModelRow& row : shadingModels()) {
    m_model->addItem(text(row.label));
    m_model->setItemData(m_model->count() - 1, text(row.sentence), Qt::ToolTipRole);
  }
  grid->addWidget(m_model, 1, 1, 1, 2);
  label(tr("Preset"), 2);
  m_preset = new QLabel(this);
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
  m_search = new QLineEdit(this);
  m_search->setObjectName(QStringLiteral("material.search"));
  m_search->setAccessibleName(tr("Search parameters"));
  m_search->setPlaceholderText(tr("Search parameters"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themeIcon("search"), QLineEdit::LeadingPosition);
  strip()->addWidget(m_search);

  connect(m_slot, &QComboBox::textActivated, &m_document, &Document::setCurrentSlot);
  connect(m_model, &QComboBox::activated, this, [this](int index) {
    m_document.setShadingModel(m_document.currentSlot(), shadingModels()[static_cast<std::size_t>(index)].model);
  });
  connect(m_search, &QLineEdit::textChanged, this, &MaterialPanel::refreshVisibility);
  connect(save, &QToolButton::clicked, this, &MaterialPanel::savePresetRequested);
  connect(m_revert, &QToolButton::clicked, this, [this] { m_loading.revertToPreset(m_document.currentSlot()); });
}

void MaterialPanel::buildRows() {
  std::map<std::string_view, GroupBox*> groups;
  for (const ParameterRow& parameter : parameterTable()) {
    GroupBox*& group = groups[parameter.group];
    if (group == nullptr) {
      group = addGroup(text(parameter.group), QStringLiteral("material/") + text(parameter.group));
      m_groups.push_back(group);
    }
    auto* row =
        new PropertyRow(text(parameter.group), text(parameter.label), text(parameter.id), makeEditor(parameter), group);
    row->setDefault(parameter.defaultValue());
    row->setHelp(helpFor(parameter));
    group->addRow(row);
    connect(row, &PropertyRow::edited, this, [this, id = parameter.id](const ParameterValue& value, Gesture gesture) {
      m_document.setParameter(m_document.currentSlot(), id, value, gesture);
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

void MaterialPanel::refreshSlots() {
  const QSignalBlocker blocker(m_slot);
  const QStringList names = m_document.slotNames();
  QStringList shown;
  for (int i = 0; i < m_slot->count(); ++i) shown << m_slot->itemText(i);
  if (shown != names) {
    m_slot->clear();
    m_slot->addItems(names);
  }
  m_slot->setCurrentIndex(static_cast<int>(names.indexOf(m_document.currentSlot())));
}

void MaterialPanel::refresh() {
  const SlotLook* look = m_document.currentLook();
  setEnabled(look != nullptr);
  if (look == nullptr) return;
  const Material& material = look->worn.material;
  {
    const QSignalBlocker blocker(m_model);
    m_model->setCurrentIndex(static_cast<int>(material.model));
  }
  const bool edited = look->binding && look->binding->edited;
  const QString name = material.name.empty() ? tr("no preset") : text(material.name);
  m_preset->setText(edited ? name + QStringLiteral(" *") : name);
  m_preset->setToolTip(edited ? tr("Changed since the preset was applied") : QString());
  m_revert->setEnabled(edited && look->preset);

  // Fresnel F0 shows what it follows while it has no value of its own.
  const float n = material.parameters.specularIor;
  const float root = (n - 1.0F) / (n + 1.0F);
  for (const Entry& entry : m_entries) {
    if (entry.parameter->type == ParameterType::OptionalColour)
      if (auto* colour = qobject_cast<ColourEditor*>(entry.row->editor())) colour->setAutomatic(glm::vec3(root * root));
    entry.row->showValue(entry.parameter->get(material.parameters));
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
  m_search->setFocus();
  m_search->selectAll();
}

}  // namespace dermis
