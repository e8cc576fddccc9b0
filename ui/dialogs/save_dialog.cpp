#include "ui/dialogs/save_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

namespace dermis {
namespace {
struct SaveDialog {
  Q_DECLARE_TR_FUNCTIONS(dermis::SaveDialog)
};
}  // namespace

QString withEnding(const QString& path, const QStringList& endings) {
  return endings.contains(QFileInfo(path).suffix(), Qt::CaseInsensitive) ? path
                                                                         : path + QLatin1Char('.') + endings.first();
}

bool mayWriteOver(const QString& path, QWidget* parent) {
  if (!QFileInfo::exists(path)) return true;
  QMessageBox question(QMessageBox::Warning, SaveDialog::tr("File exists"),
                       SaveDialog::tr("“%1” is there already.").arg(QFileInfo(path).fileName()), QMessageBox::Cancel,
                       parent);
  question.setObjectName(QStringLiteral("writeOver"));
  question.setInformativeText(SaveDialog::tr("Replacing it loses what is in it now."));
  QPushButton* replace = question.addButton(SaveDialog::tr("Replace"), QMessageBox::DestructiveRole);
  replace->setObjectName(QStringLiteral("writeOver.replace"));
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  return question.clickedButton() == replace;
}

QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter,
                       const QStringList& endings) {
  QString proposed = start;
  while (true) {
    const QString chosen = QFileDialog::getSaveFileName(parent, title, proposed, filter);
    if (chosen.isEmpty()) return {};
    proposed = withEnding(chosen, endings);
    // The dialog has asked about the name that was typed, not about the one that it has become.
    if (proposed == chosen || mayWriteOver(proposed, parent)) return proposed;
  }
}

QString fileNameOf(const QString& name) {
  static const QRegularExpression kNotInNames(QStringLiteral("[/\\\\:*?\"<>|\\x00-\\x1f]"));
  QString stem = QString(name).replace(kNotInNames, QStringLiteral("_")).trimmed();
  if (stem.isEmpty() || stem.startsWith(QLatin1Char('.'))) stem.prepend(QStringLiteral("preset"));
  return stem;
}

}  // namespace dermis
