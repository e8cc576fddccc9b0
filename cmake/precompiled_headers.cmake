# What nearly every file of a target includes, parsed once: reading headers is most of what compiling our files costs (eight of ten
# seconds for a file of the window). A file still includes what it uses; clang-tidy reads it without this (packaging/lint.sh).
set(DERMIS_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <cstring> <filesystem> <functional> <map> <memory> <optional> <span>
  <string> <string_view> <unordered_map> <vector> <fmt/format.h> <glm/glm.hpp> <nlohmann/json.hpp> <tl/expected.hpp>)
set(DERMIS_WIDGET_HEADERS <QAction> <QApplication> <QBoxLayout> <QComboBox> <QDockWidget> <QDoubleSpinBox> <QFileDialog> <QFileInfo>
  <QFormLayout> <QImage> <QKeyEvent> <QLabel> <QLineEdit> <QListWidget> <QMainWindow> <QMenu> <QMouseEvent> <QPainter> <QPushButton>
  <QSettings> <QStandardPaths> <QTimer> <QToolButton> <QUndoStack>)
set(DERMIS_TEST_HEADERS <gmock/gmock.h> <gtest/gtest.h>)
