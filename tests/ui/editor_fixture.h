// The real window on the embedded look, with hands: drags, types, waits.
#pragma once

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "ui/docks/panel.h"
#include "ui/main_window/file_actions.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/message_bar.h"
#include "ui/rows/number_field.h"
#include "ui/rows/property_row.h"
#include "ui/rows/value_slider.h"
#include "ui/viewport/viewport.h"

namespace dermis {

#ifdef __SANITIZE_ADDRESS__
constexpr int kPatienceMs = 900000;  // the head and its maps are made first, at a tenth of the speed
#else
constexpr int kPatienceMs = 60000;  // software OpenGL on a busy machine
#endif

class Editor : public testing::Test {
 protected:
  /// One window for all tests, each of which starts from the embedded look: GL programs are compiled once.
  void SetUp() override;
  /// Before QApplication goes.
  friend void closeEditor();

  Document& document() { return window->document(); }
  QUndoStack& undo() { return document().undoStack(); }
  template <class T = QWidget>
  T* find(const QString& name) {
    return window->findChild<T*>(name);
  }

  /// The viewport's picture once it has come to rest.
  QImage picture() {
    EXPECT_TRUE(QTest::qWaitFor([this] { return window->viewport()->isSettled(); }, kPatienceMs));
    return window->viewport()->grabFrame();
  }

  bool waitIdle() {
    return QTest::qWaitFor([this] { return !window->tasks().busy(); }, kPatienceMs);
  }

  /// Drags a slider's handle by `pixels` in small steps, as a hand does.
  static void drag(QWidget* widget, QPoint from, int pixels, Qt::KeyboardModifiers keys = {},
                   Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(widget, button, keys, from);
    for (int i = 1; i <= 8; ++i) {
      const QPoint at = from + QPoint(pixels * i / 8, 0);
      QMouseEvent move(QEvent::MouseMove, QPointF(at), widget->mapToGlobal(QPointF(at)), Qt::NoButton, button, keys);
      QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, button, keys, from + QPoint(pixels, 0));
  }

  /// Makes a row's control visible by opening the dock it lies in and scrolling there.
  void reveal(QWidget* control);

  static float meanDifference(const QImage& a, const QImage& b);
  /// From its own mean colour, 0 to 255: of one colour alone there is none.
  static float contrast(const QImage& image);
  static std::string write(const QTemporaryDir& folder, const char* name, const std::string& bytes) {
    std::string path = folder.filePath(QString::fromUtf8(name)).toStdString();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  static inline std::unique_ptr<MainWindow> window;
};

/// The same with the keyboard on the picture.
class PictureEditor : public Editor {
 protected:
  void SetUp() override;
  static Viewport* viewport() { return window->viewport(); }
  static void send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
                   Qt::KeyboardModifiers keys = {});
  static void wake() { moveTo(viewport()->rect().center() + QPointF(3.0, 3.0)); }
  static void moveTo(QPointF at) { send(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton); }
  static void press(QPointF at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
    send(QEvent::MouseButtonPress, at, button, button, keys);
  }
  static void pull(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton) {
    for (int i = 1; i <= 8; ++i) send(QEvent::MouseMove, from + (to - from) * (i / 8.0), Qt::NoButton, button);
  }
  static void letGo(QPointF at, Qt::MouseButton button = Qt::LeftButton) {
    send(QEvent::MouseButtonRelease, at, button, Qt::NoButton);
  }
};

void closeEditor();

/// A triangle with one material, `slot`, `size` scene units wide, as OBJ with its MTL beside it.
std::string triangleObj(const std::string& slot, float size);
/// A lat-long Radiance HDR, 4 × 2, of one colour.
std::string flatHdr(unsigned char r, unsigned char g, unsigned char b);

}  // namespace dermis
