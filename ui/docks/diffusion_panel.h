// The Diffusion profile dock: how far light spreads under the surface of the slot that is being edited.
#pragma once

#include <QWidget>

#include "ui/docks/diffusion_plot.h"

class QComboBox;
class QLabel;

namespace dermis {

class Document;

class DiffusionPanel : public QWidget {
  Q_OBJECT
 public:
  DiffusionPanel(Document& document, QWidget* parent = nullptr);
  /// Height of the picture in the viewport, in device pixels: with the camera it says how wide a pixel is at the focus.
  void setPictureHeight(int pixels);
  [[nodiscard]] const DiffusionCurves& curves() const { return m_curves; }
  /// A dock behind another's tab is visible to Qt. What nobody sees follows nothing.
  void setSeen(bool seen);

 private:
  void refresh();
  void refreshLengths();
  void showReadout(double r);

  Document& m_document;
  DiffusionPlot* m_plot = nullptr;
  QComboBox* m_what = nullptr;
  QComboBox* m_scale = nullptr;
  QLabel* m_readout = nullptr;
  QLabel* m_lengths = nullptr;
  QLabel* m_none = nullptr;
  DiffusionCurves m_curves;
  glm::vec3 m_albedo{0.0F};
  int m_pictureHeight = 720;
  bool m_seen = false;
};

}  // namespace dermis
