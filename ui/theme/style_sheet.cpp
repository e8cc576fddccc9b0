#include "ui/theme/style_sheet.h"

#include <algorithm>
#include <array>
#include <vector>

namespace dermis {
namespace {

/// What the style sheet's @names stand for.
struct Shade {
  const char* name;
  const char* dark;
  const char* light;
};
constexpr std::array<Shade, 29> kShades{{
    {"shade", "#1f1f1f", "#a6a6a6"},         {"edge", "#262626", "#b8b8b8"},
    {"gap", "#2a2a2a", "#c6c6c6"},           {"field", "#2c2c2c", "#fbfbfb"},
    {"well", "#2f2f2f", "#d2d2d2"},          {"list", "#323232", "#f4f4f4"},
    {"bar", "#333333", "#dcdcdc"},           {"popup", "#353535", "#f0f0f0"},
    {"panel", "#3a3a3a", "#e8e8e8"},         {"hover", "#3f3f3f", "#e0e0e0"},
    {"head", "#444444", "#dadada"},          {"button", "#484848", "#f6f6f6"},
    {"raised", "#505050", "#d0d0d0"},        {"line", "#5a5a5a", "#a4a4a4"},
    {"lineHover", "#6a6a6a", "#828282"},     {"faint", "#7a7a7a", "#9c9c9c"},
    {"quiet", "#989898", "#666666"},         {"soft", "#a4a4a4", "#5a5a5a"},
    {"mark", "#b9b9b9", "#4a4a4a"},          {"text", "#d4d4d4", "#2c2c2c"},
    {"strong", "#e4e4e4", "#161616"},        {"onSelection", "#ffffff", "#0c0c0c"},
    {"accent", "#5a8fc8", "#2f6fb4"},        {"selection", "#4c5866", "#bccfe4"},
    {"textSelection", "#4f7fb4", "#a4c6ec"}, {"drop", "#384048", "#dce6f2"},
    {"tip", "#1f1f1f", "#fafafa"},           {"theme", "dark", "light"},
    {"warning", "#e0b060", "#8a5a00"},
}};

const QString& sheet() {
  static const QString kSheet = QStringLiteral(R"css(
QMainWindow { background: @gap; }
QMainWindow::separator { background: @gap; width: 5px; height: 5px; }
QMainWindow::separator:hover { background: @raised; }

QMenuBar { background: @bar; color: @text; padding: 2px 4px; border-bottom: 1px solid @edge; }
QMenuBar::item { padding: 5px 10px; border-radius: 3px; background: transparent; }
QMenuBar::item:selected { background: @button; }
QMenu { background: @popup; border: 1px solid @shade; padding: 5px 0; }
QMenu::item { padding: 5px 30px 5px 26px; }
QMenu::item:selected { background: @selection; color: @onSelection; }
QMenu::item:disabled { color: @faint; }
QMenu::separator { height: 1px; background: @head; margin: 5px 8px; }
QMenu::icon { left: 7px; }
QMenu::indicator { width: 14px; height: 14px; left: 6px; }

QStatusBar { background: @bar; color: @soft; border-top: 1px solid @edge; min-height: 24px; }
QStatusBar::item { border: none; }

QDockWidget { color: @text; font-weight: 500; titlebar-close-icon: url(:/dermis/@theme/close.svg); titlebar-normal-icon: url(:/dermis/@theme/float.svg); }
QDockWidget::title { background: @bar; padding: 7px 10px; text-align: left; }
QDockWidget::close-button, QDockWidget::float-button { border: none; background: transparent; padding: 1px; icon-size: 12px; }
QDockWidget::close-button:hover, QDockWidget::float-button:hover { background: @raised; border-radius: 2px; }
QDockWidget > QWidget { background: @panel; }

QTabBar { background: @well; qproperty-drawBase: 0; }
QTabBar::tab { background: @well; color: @quiet; padding: 7px 13px; border: none; border-top: 2px solid transparent; }
QTabBar::tab:selected { background: @panel; color: @strong; border-top: 2px solid @quiet; }
QTabBar::tab:hover:!selected { color: @text; background: @popup; }
QTabBar::tab:focus { border-top: 2px solid @accent; }

QScrollArea { background: @panel; border: none; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar::handle:vertical { background: @line; min-height: 32px; border-radius: 3px; margin: 1px 2px; }
QScrollBar::handle:vertical:hover { background: @lineHover; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle:horizontal { background: @line; min-width: 32px; border-radius: 3px; margin: 2px 1px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QLabel { background: transparent; }
QLabel[quiet="true"] { color: @quiet; }
QLabel[warning="true"] { color: @warning; }
QLabel[heading="true"] { color: @strong; font-weight: 500; }
QLabel[dot="true"] { color: @strong; font-size: 15px; padding: 0; }

QAbstractSpinBox, QLineEdit, QPlainTextEdit, QTextEdit {
  background: @field; color: @strong; border: 1px solid @edge; border-radius: 3px; padding: 1px 5px; min-height: 20px;
  selection-background-color: @textSelection; selection-color: @onSelection; }
QAbstractSpinBox:hover, QLineEdit:hover { border-color: @line; }
QAbstractSpinBox:focus, QLineEdit:focus { border-color: @accent; }
QAbstractSpinBox:disabled, QLineEdit:disabled { color: @faint; background: @popup; }

QComboBox { background: @button; border: 1px solid @gap; border-radius: 3px; padding: 1px 8px; min-height: 20px; color: @text; }
QComboBox:hover { background: @raised; }
QComboBox:focus { border-color: @accent; }
QComboBox:disabled { color: @faint; background: @hover; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/dermis/@theme/arrow-down.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView { background: @popup; border: 1px solid @shade; outline: none; padding: 3px;
  selection-background-color: @selection; selection-color: @onSelection; }
QComboBox QAbstractItemView::item { min-height: 24px; padding: 0 6px; }

QPushButton, QToolButton { background: @button; border: 1px solid @gap; border-radius: 3px; padding: 3px 10px; min-height: 18px; color: @text; }
QPushButton:hover, QToolButton:hover { background: @raised; }
QPushButton:pressed, QToolButton:pressed, QToolButton:checked { background: @field; }
QPushButton:focus, QToolButton:focus { border-color: @accent; }
QPushButton:disabled, QToolButton:disabled { color: @faint; background: @hover; }
QPushButton:default { border-color: @lineHover; }
QToolButton { padding: 3px 5px; }
QToolButton[autoRaise="true"] { background: transparent; border: 1px solid transparent; }
QToolButton[autoRaise="true"]:hover { background: @raised; }
QToolButton[autoRaise="true"]:focus { border-color: @accent; }
QToolButton::menu-indicator { image: none; }
QLineEdit QToolButton { padding: 0; border: none; min-height: 0; background: transparent; }
QToolButton[groupHead="true"] { background: @head; border: none; border-top: 1px solid @raised; border-bottom: 1px solid @well; border-radius: 0; padding: 5px 8px;
  text-align: left; color: @strong; font-weight: 500; }
QToolButton[groupHead="true"]:hover { background: @button; }
QToolButton[groupHead="true"]:focus { border-bottom: 1px solid @accent; }

QCheckBox { spacing: 7px; min-height: 22px; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid @edge; border-radius: 3px; background: @field; }
QCheckBox::indicator:hover { border-color: @lineHover; }
QCheckBox::indicator:focus { border-color: @accent; }
QCheckBox::indicator:checked { background: @mark; border-color: @mark; image: url(:/dermis/@theme/check.svg); }
QCheckBox:focus { color: @strong; }

QAbstractItemView { background: @list; alternate-background-color: @popup; border: none; outline: none; color: @text; }
QListView::item { padding: 4px 6px; border-radius: 3px; }
QListView::item:hover { background: @hover; }
QListView::item:selected { background: @selection; color: @onSelection; }
QHeaderView::section { background: @panel; border: none; padding: 4px 6px; }

QProgressBar { background: @gap; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; text-align: center; }
QProgressBar::chunk { background: @soft; border-radius: 3px; }

QToolTip { background: @tip; color: @strong; border: 1px solid @line; padding: 5px 7px; }
QFrame[popup="true"] { background: @popup; border: 1px solid @shade; border-radius: 4px; }
QFrame[messageBar="true"] { background: @head; border: none; border-bottom: 1px solid @edge; }
QFrame[toolStrip="true"] { background: @popup; border-bottom: 1px solid @gap; }
QFrame[dropZone="true"] { background: @bar; border: 1px dashed @line; border-radius: 4px; }
QFrame[dropZone="true"][dropActive="true"] { border: 1px dashed @accent; background: @drop; }
QFrame[card="true"] { background: @popup; border: 1px solid @field; border-radius: 4px; }
QLabel[thumbnailWell="true"] { background: @gap; border-radius: 3px; }
QDialog { background: @panel; }
)css");
  return kSheet;
}

}  // namespace

QString styleSheet(bool dark) {
  QString text = sheet();
  std::vector<Shade> shades(kShades.begin(), kShades.end());
  // The longest names first: "lineHover" begins with "line".
  std::ranges::sort(shades, std::ranges::greater(), [](const Shade& s) { return qstrlen(s.name); });
  for (const Shade& shade : shades)
    text.replace(QLatin1Char('@') + QLatin1String(shade.name), QLatin1String(dark ? shade.dark : shade.light));
  return text;
}

}  // namespace dermis
