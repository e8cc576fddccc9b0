#include "ui/theme/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QIcon>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QTimer>
#include <array>
#include <utility>

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
  /// A selected picture keeps its colours: people judge them. Its frame tells that it is selected.
  QPixmap generatedIconPixmap(QIcon::Mode mode, const QPixmap& pixmap, const QStyleOption* option) const override {
    return mode == QIcon::Selected ? pixmap : QProxyStyle::generatedIconPixmap(mode, pixmap, option);
  }
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_ComboBox_Popup) return 0;
    if (hint == SH_ToolTip_WakeUpDelay) return 500;
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
};

struct PaletteShade {
  QPalette::ColorRole role;
  const char* dark;
  const char* light;
};
constexpr std::array<PaletteShade, 19> kPalette{{
    {QPalette::Window, "#3a3a3a", "#e8e8e8"},
    {QPalette::WindowText, "#d4d4d4", "#2c2c2c"},
    {QPalette::Base, "#2c2c2c", "#fbfbfb"},
    {QPalette::AlternateBase, "#313131", "#f0f0f0"},
    {QPalette::Text, "#e2e2e2", "#1c1c1c"},
    {QPalette::Button, "#484848", "#f6f6f6"},
    {QPalette::ButtonText, "#d8d8d8", "#2c2c2c"},
    {QPalette::BrightText, "#ffffff", "#000000"},
    {QPalette::PlaceholderText, "#8c8c8c", "#7c7c7c"},
    {QPalette::ToolTipBase, "#1f1f1f", "#fafafa"},
    {QPalette::ToolTipText, "#e0e0e0", "#1c1c1c"},
    {QPalette::Light, "#8e8e8e", "#ffffff"},
    {QPalette::Midlight, "#545454", "#dedede"},
    {QPalette::Mid, "#4a4a4a", "#c2c2c2"},
    {QPalette::Dark, "#262626", "#9c9c9c"},
    {QPalette::Shadow, "#1b1b1b", "#7a7a7a"},
    {QPalette::Highlight, "#5a8fc8", "#2f6fb4"},
    {QPalette::HighlightedText, "#ffffff", "#ffffff"},
    {QPalette::Link, "#8ab4e0", "#1f5c9e"},
}};

QPalette chromePalette(bool dark) {
  QPalette p;
  for (const PaletteShade& shade : kPalette) p.setColor(shade.role, QLatin1String(dark ? shade.dark : shade.light));
  const QColor faint(QLatin1String(dark ? "#7a7a7a" : "#9c9c9c"));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, faint);
  p.setColor(QPalette::Disabled, QPalette::Highlight, QLatin1String(dark ? "#555555" : "#b8b8b8"));
  return p;
}

std::function<bool()>& probe() {
  static std::function<bool()> s_probe;
  return s_probe;
}

/// Qt 6.4 doesn't tell whether the system is dark: its colours do, once our own are out of the way.
bool systemIsDark() {
  if (probe()) return probe()();
  QApplication::setPalette(QPalette());
  return QApplication::palette().color(QPalette::Window).lightness() < 128;
}

/// Windows are told when the desktop's theme changes.
class ThemeFollower : public QObject {
 public:
  explicit ThemeFollower(QApplication& application) : QObject(&application), m_application(application) {
    application.installEventFilter(this);
  }
  void setChoice(ThemeChoice choice) { m_choice = choice; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ThemeChange && m_choice == ThemeChoice::System && watched->isWindowType() &&
        !m_queued) {
      m_queued = true;
      QTimer::singleShot(0, this, [this] {
        applyTheme(m_application, m_choice);
        m_queued = false;
      });
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  QApplication& m_application;
  ThemeChoice m_choice = ThemeChoice::Dark;
  bool m_queued = false;
};

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

void setSystemDarkProbe(std::function<bool()> asked) { probe() = std::move(asked); }

void applyTheme(QApplication& application, ThemeChoice choice) {
  static ThemeFollower* const s_follower = [&application] {
    loadChromeResources();
    QApplication::setStyle(new ChromeStyle);
    QApplication::setFont(chromeFont());
    return new ThemeFollower(application);
  }();
  s_follower->setChoice(choice);
  const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && systemIsDark());
  QApplication::setPalette(chromePalette(dark));
  const QString sheet = styleSheet(dark);
  if (application.styleSheet() != sheet) application.setStyleSheet(sheet);
}

}  // namespace dermis
