// The Diffusion dock: the right curves, a readout, and a pixel's width that follows the camera.
#include <QComboBox>
#include <QLabel>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "ui/docks/diffusion_panel.h"
#include "ui/editor_fixture.h"
#include "ui/viewport/navigation.h"

namespace dermis {
namespace {

class DiffusionDock : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    panel = window->findChild<DiffusionPanel*>();
    plot = find<DiffusionPlot>(QStringLiteral("diffusion.plot"));
    reveal(plot);
    document().setCurrentSlot(document().slotNames().front());
    ASSERT_TRUE(plot->isVisible());
  }
  void set(std::string_view id, const ParameterValue& value) {
    document().setParameter(document().currentSlot(), id, value, newGesture());
  }
  DiffusionPanel* panel = nullptr;
  DiffusionPlot* plot = nullptr;
};

TEST_F(DiffusionDock, ACurveByRadiusHoldsAllTheLight) {
  const DiffusionProfile& profile = panel->curves().chosen;
  const double end = profile.extent().x;
  glm::dvec3 sum(0.0);
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) sum += plot->plotted(profile, (i + 0.5) * end / kSteps) * (end / kSteps);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1.0, 2e-3) << c;
  plot->setRadial(false);
  EXPECT_NEAR(plot->plotted(profile, 0.3).y, profile.value(0.3).y, 1e-12);
  plot->setRadial(true);
}

TEST_F(DiffusionDock, FollowsTheSliderAndDrawsBothFamilies) {
  const glm::dvec3 before = panel->curves().chosen.lengths();
  ASSERT_TRUE(panel->curves().other);
  EXPECT_EQ(panel->curves().chosen.family(), DiffusionFamily::Burley);
  EXPECT_EQ(panel->curves().other->family(), DiffusionFamily::Gaussians);
  set("subsurface.scale", ParameterValue(2.0F));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(panel->curves().chosen.lengths()[c], 2.0 * before[c], 1e-6);
  undo().undo();
  EXPECT_EQ(panel->curves().chosen.lengths(), before);
  const QString lengths = find<QLabel>(QStringLiteral("diffusion.lengths"))->accessibleName();
  EXPECT_TRUE(lengths.contains(QStringLiteral("Mean free path"))) << lengths.toStdString();
  EXPECT_TRUE(lengths.contains(QStringLiteral("63 %"))) << lengths.toStdString();
}

TEST_F(DiffusionDock, APixelIsAsWideAsTheCameraMakesIt) {
  const double near = panel->curves().pixelMm;
  const double height = window->viewport()->height() * window->viewport()->devicePixelRatioF();
  const Camera& camera = document().camera();
  const double distance = static_cast<double>(glm::length(camera.position - camera.target));
  const double expected = 2.0 * distance *
                          std::tan(glm::radians(0.5 * static_cast<double>(camera.verticalFovDegrees))) / height *
                          static_cast<double>(document().millimetresPerUnit());
  EXPECT_NEAR(near, expected, 1e-3 * expected);
  document().setCamera(navigation::zoom(camera, 5.0F));
  EXPECT_NEAR(panel->curves().pixelMm / near, std::pow(0.88, 5.0), 1e-3);
}

TEST_F(DiffusionDock, ThePointerReadsTheCurve) {
  auto* readout = find<QLabel>(QStringLiteral("diffusion.readout"));
  EXPECT_TRUE(readout->text().contains(QStringLiteral("dashed")));
  const double r = 0.25 * plot->longestRadius();
  EXPECT_NEAR(plot->radiusAt(plot->xOf(r)), r, 1e-9);
  QMouseEvent move(QEvent::MouseMove, QPointF(plot->xOf(r), 0.5 * plot->height()),
                   plot->mapToGlobal(QPointF(plot->xOf(r), 0.5 * plot->height())), Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(plot, &move);
  const double within = 100.0 * panel->curves().chosen.radialCdf(r).x;
  EXPECT_TRUE(readout->text().contains(QString::number(within, 'f', 1))) << readout->text().toStdString();
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(plot, &leave);
  EXPECT_FALSE(readout->text().contains(QStringLiteral("leaves within")));
}

TEST_F(DiffusionDock, SaysSoWhereNothingDiffuses) {
  document().setShadingModel({document().currentSlot()}, ShadingModel::MetallicRoughness);
  EXPECT_FALSE(plot->isVisible());
  undo().undo();
  EXPECT_TRUE(plot->isVisible());
  EXPECT_TRUE(plot->accessibleDescription().contains(QStringLiteral("Burley")));
}

/// WCAG 2.1 relative luminance.
double luminance(const QColor& colour) {
  const auto linear = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

TEST(DiffusionPlotColours, StandOutOnDarkAndOnLightGround) {
  for (const QColor& ground : {QColor(0x2c, 0x2c, 0x2c), QColor(0xff, 0xff, 0xff)}) {
    QPalette palette;
    palette.setColor(QPalette::Base, ground);
    for (const QColor& colour : channelColours(palette)) {
      const double a = luminance(colour), b = luminance(ground);
      EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), 4.5) << colour.name().toStdString();
    }
  }
}

TEST(DiffusionPlotPicture, IsAsFineAsTheScreenAndDrawsEachChannel) {
  DiffusionPlot plot;
  plot.resize(360, 240);
  DiffusionCurves curves;
  curves.chosen = DiffusionProfile::burley({0.8, 0.4, 0.2});
  curves.pixelMm = 0.1;
  plot.showCurves(curves);
  for (const bool logarithmic : {false, true}) {
    plot.setLogarithmic(logarithmic);
    for (const double ratio : {1.0, 2.0}) {
      QImage image(QSize(360, 240) * ratio, QImage::Format_RGB32);
      image.setDevicePixelRatio(ratio);
      plot.render(&image);
      const std::array<QColor, 3> colours = channelColours(plot.palette());
      for (const QColor& colour : colours) {
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y)
          for (int x = 0; x < image.width(); ++x) pixels += image.pixelColor(x, y) == colour ? 1 : 0;
        EXPECT_GT(pixels, 60 * ratio) << colour.name().toStdString() << " at " << ratio;
      }
    }
  }
}

}  // namespace
}  // namespace dermis
