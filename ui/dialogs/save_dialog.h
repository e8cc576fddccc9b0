// Where a file is to be saved: nothing is written over unasked, and the name's ending is one that opens again.
#pragma once

#include <QStringList>

class QWidget;

namespace dermis {

/// `path` with the first of `endings` ("dermis", "json") added, unless it has one of them.
[[nodiscard]] QString withEnding(const QString& path, const QStringList& endings);
/// True where there is no such file, or the person lets it be replaced.
[[nodiscard]] bool mayWriteOver(const QString& path, QWidget* parent);
/// Empty: nothing is to be saved.
[[nodiscard]] QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter,
                                     const QStringList& endings);
/// `name` without what can't stand in a file's name; never empty.
[[nodiscard]] QString fileNameOf(const QString& name);

}  // namespace dermis
