#include "ui/theme/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>

#include "ui/theme/style_sheet.h"

// A static library's resources have to be asked for, and from outside any namespace.
static void loadChromeResources() { Q_INIT_RESOURCE(chrome); }

namespace dermis {
namespace {

/// Fusion with a few measures of our own: menus of small icons, tool tips at once beside a panel, no focus rectangles
/// where the style sheet draws its own.
class ChromeStyle : public QProxyStyle {
 public:
  ChromeStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    switch (metric) {
      case PM_SmallIconSize:
        return 16;
      case PM_DockWidgetSeparatorExtent:
        return 5;
      case PM_ToolBarIconSize:
        return 16;
      default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
  }
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element == PE_FrameTabBarBase) return;
    QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_ComboBox_Popup) return 0;
    if (hint == SH_ToolTip_WakeUpDelay) return 500;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
};

QPalette darkPalette() {
  QPalette p;
  const auto all = [&](QPalette::ColorRole role, const char* colour) {
    p.setColor(role, QColor(QLatin1String(colour)));
  };
  all(QPalette::Window, "#3a3a3a");
  all(QPalette::WindowText, "#d4d4d4");
  all(QPalette::Base, "#2c2c2c");
  all(QPalette::AlternateBase, "#313131");
  all(QPalette::Text, "#e2e2e2");
  all(QPalette::Button, "#484848");
  all(QPalette::ButtonText, "#d8d8d8");
  all(QPalette::BrightText, "#ffffff");
  all(QPalette::PlaceholderText, "#8c8c8c");
  all(QPalette::ToolTipBase, "#1f1f1f");
  all(QPalette::ToolTipText, "#e0e0e0");
  all(QPalette::Light, "#8e8e8e");
  all(QPalette::Midlight, "#545454");
  all(QPalette::Mid, "#4a4a4a");
  all(QPalette::Dark, "#262626");
  all(QPalette::Shadow, "#1b1b1b");
  all(QPalette::Highlight, "#5a8fc8");
  all(QPalette::HighlightedText, "#ffffff");
  all(QPalette::Link, "#8ab4e0");
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor(0x7a, 0x7a, 0x7a));
  p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(0x55, 0x55, 0x55));
  return p;
}

/// A face whose digits have one width, so that numbers below each other line up.
QFont chromeFont() {
  QFont font = QApplication::font();
  const QStringList families = QFontDatabase::families();
  for (const char* name : {"Roboto", "Noto Sans", "Open Sans", "DejaVu Sans"}) {
    if (!families.contains(QLatin1String(name))) continue;
    font.setFamily(QLatin1String(name));
    break;
  }
  font.setPixelSize(font.family() == QLatin1String("DejaVu Sans") ? 11 : 13);
  font.setHintingPreference(QFont::PreferVerticalHinting);
  return font;
}

}  // namespace

void applyTheme(QApplication& application) {
  loadChromeResources();
  QApplication::setStyle(new ChromeStyle);
  QApplication::setPalette(darkPalette());
  QApplication::setFont(chromeFont());
  application.setStyleSheet(styleSheet());
}

}  // namespace dermis
