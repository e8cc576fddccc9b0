#include "ui/docks/material_clipboard.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>

#include "core/material/preset_io.h"
#include "core/material/values_text.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/text.h"
#include "ui/translation.h"

namespace dermis {

MaterialClipboard::MaterialClipboard(Document& document, Loading& loading, QObject* parent)
    : QObject(parent), m_document(document), m_loading(loading) {
  m_copyMaterial = new QAction(tr("&Copy material"), this);
  m_copyMaterial->setObjectName(QStringLiteral("material.copy"));
  m_copyMaterial->setToolTip(tr("Puts the whole material on the clipboard, as a preset's text"));
  m_paste = new QAction(tr("&Paste group or material"), this);
  m_paste->setObjectName(QStringLiteral("material.paste"));
  m_paste->setToolTip(tr("Puts what was copied on the edited slots"));
  connect(m_copyMaterial, &QAction::triggered, this, &MaterialClipboard::copyMaterial);
  connect(m_paste, &QAction::triggered, this, &MaterialClipboard::paste);
}

QAction* MaterialClipboard::copyGroupAction(const QString& group, QObject* owner) {
  auto* action = new QAction(tr("Copy group “%1”").arg(tableText(group.toStdString())), owner);
  action->setObjectName(QStringLiteral("material.copyGroup"));
  connect(action, &QAction::triggered, this, [this, group] { copyGroup(group); });
  return action;
}

void MaterialClipboard::copyGroup(const QString& group) {
  const SlotLook* look = m_document.currentLook();
  if (look == nullptr) return;
  std::vector<NamedValue> values;
  for (const ParameterRow& row : parameterTable())
    if (text(row.group) == group && row.usedBy(look->worn.material.model))
      values.push_back({&row, row.get(look->worn.material.parameters)});
  QApplication::clipboard()->setText(text(writeValues(values)));
}

void MaterialClipboard::copyMaterial() {
  if (const SlotLook* look = m_document.currentLook())
    QApplication::clipboard()->setText(text(writePreset(look->worn.material, {})));
}

void MaterialClipboard::paste() {
  const std::string clipboard = QApplication::clipboard()->text().toStdString();
  Warnings warnings;
  if (const Result<Material> material = readPreset(clipboard, tr("the clipboard").toStdString(), {}, warnings)) {
    m_loading.pasteMaterial(m_document.editedSlots(), *material);
    return;
  }
  const Result<std::vector<NamedValue>> values = readValues(clipboard);
  if (!values) {
    Q_EMIT m_loading.message(MessageKind::Error, tr("Nothing was pasted: %1.").arg(text(values.error().message)));
    return;
  }
  std::vector<ParameterEdit> edits;
  for (const QString& slot : m_document.editedSlots())
    for (const NamedValue& named : *values)
      if (named.row->usedBy(m_document.slotLook(slot)->worn.material.model))
        edits.push_back({slot, named.row, named.value});
  if (edits.empty()) {
    Q_EMIT m_loading.message(MessageKind::Error,
                             tr("Nothing was pasted: this shading model has none of the parameters on the clipboard."));
    return;
  }
  m_document.setParameters(edits, tr("Paste values on %1").arg(m_document.editedSlots().join(QStringLiteral(", "))),
                           QStringLiteral("paste"), 0);
}

}  // namespace dermis
