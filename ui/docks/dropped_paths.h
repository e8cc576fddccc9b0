// What a drag brings that is a file or a folder on this machine.
#pragma once

#include <QStringList>

class QMimeData;

namespace dermis {

[[nodiscard]] QStringList localPaths(const QMimeData* data);

}  // namespace dermis
