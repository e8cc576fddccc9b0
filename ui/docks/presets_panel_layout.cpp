// What stands above and below the list of presets.
#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/panel.h"
#include "ui/docks/presets_panel.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"
#include "ui/theme/strips.h"

namespace dermis {

void PresetsPanel::buildHead() {
  QFrame* head = toolStrip(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  row->setSpacing(metrics::kGap);
  m_search = new QLineEdit(head);
  m_search->setObjectName(QStringLiteral("presets.search"));
  m_search->setPlaceholderText(tr("Search presets"));
  m_search->setAccessibleName(tr("Search presets"));
  m_search->setToolTip(tr("Words of a preset's name or tags"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themeIcon("search"), QLineEdit::LeadingPosition);
  m_tag = new QComboBox(head);
  m_tag->setObjectName(QStringLiteral("presets.tag"));
  m_tag->setAccessibleName(tr("Tag"));
  m_tag->setToolTip(tr("Shows presets with one tag: a shading model, whose it is, or a tag of your own"));
  m_tag->setMinimumWidth(86);
  row->addWidget(m_search, 1);
  row->addWidget(m_tag);
  layout()->addWidget(head);
}

void PresetsPanel::buildFoot() {
  auto* column = qobject_cast<QVBoxLayout*>(layout());
  auto* busy = new QHBoxLayout();
  busy->setContentsMargins(metrics::kMargin, 0, metrics::kMargin, 0);
  m_progress = new QLabel(this);
  m_progress->setObjectName(QStringLiteral("presets.progress"));
  m_progress->setProperty("quiet", true);
  m_cancel = iconButton("close", tr("Stop drawing thumbnails"), this);
  m_cancel->setObjectName(QStringLiteral("presets.cancel"));
  busy->addWidget(m_progress, 1);
  busy->addWidget(m_cancel);
  column->addLayout(busy);
  connect(m_cancel, &QToolButton::clicked, &m_thumbnails, &ThumbnailMaker::cancel);
  showProgress(0, 0);

  auto* worn = new QHBoxLayout();
  worn->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, 0);
  worn->setSpacing(2);
  m_worn = new QLabel(this);
  m_worn->setObjectName(QStringLiteral("presets.worn"));
  m_worn->setTextFormat(Qt::PlainText);
  m_worn->setMinimumWidth(40);
  m_update = iconButton("save", tr("Update the preset with the slot's values"), this);
  m_update->setObjectName(QStringLiteral("presets.save"));
  m_revert = iconButton("reset", tr("Revert the slot to its preset"), this);
  m_revert->setObjectName(QStringLiteral("presets.revert"));
  worn->addWidget(m_worn, 1);
  worn->addWidget(m_update);
  worn->addWidget(m_revert);
  column->addLayout(worn);

  auto* foot = new QHBoxLayout();
  foot->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, metrics::kMargin);
  foot->setSpacing(metrics::kGap);
  m_apply = new QPushButton(tr("Apply"), this);
  m_apply->setObjectName(QStringLiteral("presets.apply"));
  m_apply->setToolTip(tr("Put the selected preset on the current slot"));
  auto* saveAs = iconButton("add", tr("Save the slot's material as a new preset…"), this);
  saveAs->setObjectName(QStringLiteral("presets.saveAs"));
  m_more = iconButton("chevron-down", tr("More for the selected preset"), this);
  m_more->setObjectName(QStringLiteral("presets.more"));
  m_more->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_more);
  m_more->setMenu(menu);
  foot->addWidget(m_apply, 1);
  foot->addWidget(saveAs);
  foot->addWidget(m_more);
  column->addLayout(foot);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    fillMenu(menu);
  });
  connect(m_apply, &QPushButton::clicked, this, &PresetsPanel::applySelected);
  connect(m_update, &QToolButton::clicked, this, &PresetsPanel::saveRequested);
  connect(m_revert, &QToolButton::clicked, this, &PresetsPanel::revert);
  connect(saveAs, &QToolButton::clicked, this, &PresetsPanel::saveAsRequested);
}

}  // namespace dermis
