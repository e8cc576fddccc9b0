#include "ui/dialogs/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/dialogs/folder_list.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {
constexpr std::array<double, 6> kScales{0.75, 1.0, 1.25, 1.5, 1.75, 2.0};
}

PreferencesDialog::PreferencesDialog(Preferences& preferences, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("preferences"));
  setWindowTitle(tr("Preferences"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(22, 20, 22, 16);
  column->setSpacing(metrics::kMargin + 4);
  m_form = new QFormLayout();
  m_form->setHorizontalSpacing(20);
  m_form->setVerticalSpacing(9);
  m_form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
  buildForm(m_form);
  column->addLayout(m_form);
  auto* buttons =
      new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
  buttons->setObjectName(QStringLiteral("preferences.buttons"));
  column->addWidget(buttons);
  show(preferences.values());
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this, &preferences] {
    preferences.set(values());
    accept();
  });
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
          [this] { show(PreferenceValues{}); });
}

QComboBox* PreferencesDialog::choice(const QString& name, const QString& label, const QString& help,
                                     const QStringList& words) {
  auto* box = new QComboBox(this);
  box->setObjectName(QStringLiteral("preferences.") + name);
  box->setAccessibleName(label);
  box->setToolTip(help);
  box->addItems(words);
  m_form->addRow(label, box);
  return box;
}

QSpinBox* PreferencesDialog::number(const QString& name, const QString& label, const QString& help, int lowest,
                                    int highest, const QString& unit) {
  auto* box = new QSpinBox(this);
  box->setObjectName(QStringLiteral("preferences.") + name);
  box->setAccessibleName(label);
  box->setToolTip(help);
  box->setRange(lowest, highest);
  box->setSuffix(unit);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  m_form->addRow(label, box);
  return box;
}

void PreferencesDialog::buildForm(QFormLayout* form) {
  m_theme = choice(QStringLiteral("theme"), tr("Theme"),
                   tr("Greys without a hue, because colour is judged beside them. The system's is read from its "
                      "colours when the program starts"),
                   {tr("Dark"), tr("Light"), tr("As the system")});
  QStringList scales;
  for (const double scale : kScales) scales << tr("%1 %").arg(std::lround(scale * 100.0));
  m_scale = choice(QStringLiteral("scale"), tr("Interface size"),
                   tr("On top of the screen's own scale; from the next start on"), scales);
  m_unit = choice(QStringLiteral("unit"), tr("Lengths"),
                  tr("In which the height of a model is shown; materials always count in millimetres"),
                  {tr("Millimetres, metres"), tr("Millimetres"), tr("Centimetres"), tr("Inches")});
  m_samples = number(QStringLiteral("samples"), tr("Samples while still"),
                     tr("How many pictures are averaged while nothing moves"), 1, 4096, {});
  m_statistics = new QCheckBox(tr("Show time and samples over the picture"), this);
  m_statistics->setObjectName(QStringLiteral("preferences.statistics"));
  m_statistics->setToolTip(tr("The line in the lower right corner of the viewport"));
  form->addRow(QString(), m_statistics);
  m_autosave = number(QStringLiteral("autosave"), tr("Keep unsaved work"),
                      tr("At most this long after an edit it is on the disk, and is offered again after a crash"), 1,
                      600, tr(" s after an edit"));
  m_cache = number(QStringLiteral("cache"), tr("Cache"),
                   tr("What baked environments, models and thumbnails may take on the disk; what was used longest ago "
                      "goes first"),
                   64, 1 << 20, tr(" MB"));
  m_presets = new FolderList(tr("Preset folders"), QStringLiteral("preferences.presetFolders"), this);
  form->addRow(tr("Preset folders"), m_presets);
  m_environments = new FolderList(tr("Environment folders"), QStringLiteral("preferences.environmentFolders"), this);
  form->addRow(tr("Environment folders"), m_environments);
}

void PreferencesDialog::show(const PreferenceValues& values) {
  m_theme->setCurrentIndex(static_cast<int>(values.theme));
  const auto nearest =
      std::ranges::min_element(kScales, {}, [&](double scale) { return std::abs(scale - values.interfaceScale); });
  m_scale->setCurrentIndex(static_cast<int>(nearest - kScales.begin()));
  m_unit->setCurrentIndex(static_cast<int>(values.unit));
  m_autosave->setValue(values.autosaveSeconds);
  m_cache->setValue(values.cacheMegabytes);
  m_samples->setValue(values.stillSamples);
  m_statistics->setChecked(values.statistics);
  m_presets->setFolders(values.presetFolders);
  m_environments->setFolders(values.environmentFolders);
}

PreferenceValues PreferencesDialog::values() const {
  PreferenceValues v;
  v.theme = static_cast<ThemeChoice>(m_theme->currentIndex());
  v.interfaceScale = kScales[static_cast<std::size_t>(m_scale->currentIndex())];
  v.unit = static_cast<LengthUnit>(m_unit->currentIndex());
  v.autosaveSeconds = m_autosave->value();
  v.cacheMegabytes = m_cache->value();
  v.stillSamples = m_samples->value();
  v.statistics = m_statistics->isChecked();
  v.presetFolders = m_presets->folders();
  v.environmentFolders = m_environments->folders();
  return v;
}

}  // namespace dermis
