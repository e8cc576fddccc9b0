#include "ui/editor_fixture.h"

#include <QApplication>
#include <QDockWidget>
#include <QScrollArea>
#include <cstdlib>

#include "ui/docks/presets_panel.h"
#include "ui/viewport/model_picker.h"

namespace dermis {

void Editor::SetUp() {
  if (!window) {
    window = std::make_unique<MainWindow>();
    window->resize(1100, 700);
    // Whoever tests thumbnails draws one; nobody else wants the machine busy with them.
    window->findChild<PresetsPanel*>()->thumbnails().setEnabled(false);
  }
  window->viewport()->setTargetSamples(1);  // each time: another test may have applied preferences
  window->messageBar()->hide();
  window->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), kPatienceMs));
  QSignalSpy opened(&window->loading(), &Loading::finished);
  window->open({});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !opened.isEmpty(); }, kPatienceMs));
  ASSERT_TRUE(document().isReady());
  ASSERT_EQ(undo().count(), 0);
  ASSERT_TRUE(QTest::qWaitFor([] { return window->viewport()->picker().isReady(); }, kPatienceMs));
}

void closeEditor() { Editor::window.reset(); }

void Editor::reveal(QWidget* control) {
  for (QWidget* w = control; w != nullptr; w = w->parentWidget()) {
    if (auto* dock = qobject_cast<QDockWidget*>(w)) {
      dock->show();
      dock->raise();
    }
  }
  QApplication::processEvents();
  for (QWidget* w = control; w != nullptr; w = w->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(w)) area->ensureWidgetVisible(control);
  QApplication::processEvents();
}

void PictureEditor::SetUp() {
  Editor::SetUp();
  if (HasFatalFailure()) return;
  window->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), kPatienceMs));
  viewport()->setFocus();
}

void PictureEditor::send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
                         Qt::KeyboardModifiers keys) {
  QMouseEvent event(type, at, viewport()->mapToGlobal(at), button, held, keys);
  QApplication::sendEvent(viewport(), &event);
}

float Editor::meanDifference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return 255.0F;
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
    }
  return static_cast<float>(sum / (3.0 * a.width() * a.height()));
}

float Editor::contrast(const QImage& image) {
  const QImage mean = image.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  return meanDifference(image, mean.scaled(image.size()));
}

std::string triangleObj(const std::string& slot, float size) {
  const std::string s = std::to_string(size);
  return "usemtl " + slot + "\nv 0 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
}

std::string flatHdr(unsigned char r, unsigned char g, unsigned char b) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
  for (int i = 0; i < 8; ++i) {
    for (const unsigned char c : {r, g, b}) bytes.push_back(static_cast<char>(c));
    bytes.push_back(static_cast<char>(128 + 1));  // mantissa / 256 · 2
  }
  return bytes;
}

}  // namespace dermis
