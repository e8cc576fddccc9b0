#include "ui/theme/style_sheet.h"

namespace dermis {

QString styleSheet() {
  return QStringLiteral(R"css(
QMainWindow { background: #2a2a2a; }
QMainWindow::separator { background: #2a2a2a; width: 5px; height: 5px; }
QMainWindow::separator:hover { background: #4d4d4d; }

QMenuBar { background: #333333; color: #d0d0d0; padding: 2px 4px; border-bottom: 1px solid #262626; }
QMenuBar::item { padding: 5px 10px; border-radius: 3px; background: transparent; }
QMenuBar::item:selected { background: #4a4a4a; }
QMenu { background: #343434; border: 1px solid #1f1f1f; padding: 5px 0; }
QMenu::item { padding: 5px 30px 5px 26px; }
QMenu::item:selected { background: #4c5866; color: #ffffff; }
QMenu::item:disabled { color: #7a7a7a; }
QMenu::separator { height: 1px; background: #464646; margin: 5px 8px; }
QMenu::icon { left: 7px; }
QMenu::indicator { width: 14px; height: 14px; left: 6px; }

QStatusBar { background: #333333; color: #a8a8a8; border-top: 1px solid #262626; min-height: 24px; }
QStatusBar::item { border: none; }

QDockWidget { color: #bdbdbd; font-weight: 500; titlebar-close-icon: url(:/dermis/close.svg); titlebar-normal-icon: url(:/dermis/float.svg); }
QDockWidget::title { background: #333333; padding: 7px 10px; text-align: left; }
QDockWidget::close-button, QDockWidget::float-button { border: none; background: transparent; padding: 1px; icon-size: 12px; }
QDockWidget::close-button:hover, QDockWidget::float-button:hover { background: #505050; border-radius: 2px; }
QDockWidget > QWidget { background: #3a3a3a; }

QTabBar { background: #2f2f2f; qproperty-drawBase: 0; }
QTabBar::tab { background: #2f2f2f; color: #9c9c9c; padding: 7px 13px; border: none; border-top: 2px solid transparent; }
QTabBar::tab:selected { background: #3a3a3a; color: #e6e6e6; border-top: 2px solid #8c8c8c; }
QTabBar::tab:hover:!selected { color: #d0d0d0; background: #353535; }
QTabBar::tab:focus { border-top: 2px solid #5a8fc8; }

QScrollArea { background: #3a3a3a; border: none; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar::handle:vertical { background: #565656; min-height: 32px; border-radius: 3px; margin: 1px 2px; }
QScrollBar::handle:vertical:hover { background: #6a6a6a; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle:horizontal { background: #565656; min-width: 32px; border-radius: 3px; margin: 2px 1px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QLabel { background: transparent; }
QLabel[quiet="true"] { color: #989898; }
QLabel[heading="true"] { color: #e6e6e6; font-weight: 500; }
QLabel[dot="true"] { color: #f0f0f0; font-size: 15px; padding: 0; }

QAbstractSpinBox, QLineEdit, QPlainTextEdit, QTextEdit {
  background: #2c2c2c; color: #e2e2e2; border: 1px solid #262626; border-radius: 3px; padding: 1px 5px; min-height: 20px;
  selection-background-color: #4f7fb4; selection-color: #ffffff; }
QAbstractSpinBox:hover, QLineEdit:hover { border-color: #5c5c5c; }
QAbstractSpinBox:focus, QLineEdit:focus { border-color: #5a8fc8; }
QAbstractSpinBox:disabled, QLineEdit:disabled { color: #7a7a7a; background: #343434; }

QComboBox { background: #484848; border: 1px solid #2a2a2a; border-radius: 3px; padding: 1px 8px; min-height: 20px; color: #dcdcdc; }
QComboBox:hover { background: #505050; }
QComboBox:focus { border-color: #5a8fc8; }
QComboBox:disabled { color: #7a7a7a; background: #3e3e3e; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/dermis/arrow-down.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView { background: #343434; border: 1px solid #1f1f1f; outline: none; padding: 3px;
  selection-background-color: #4c5866; selection-color: #ffffff; }
QComboBox QAbstractItemView::item { min-height: 24px; padding: 0 6px; }

QPushButton, QToolButton { background: #484848; border: 1px solid #2a2a2a; border-radius: 3px; padding: 3px 10px; min-height: 18px; color: #dcdcdc; }
QPushButton:hover, QToolButton:hover { background: #545454; }
QPushButton:pressed, QToolButton:pressed, QToolButton:checked { background: #2e2e2e; }
QPushButton:focus, QToolButton:focus { border-color: #5a8fc8; }
QPushButton:disabled, QToolButton:disabled { color: #777777; background: #404040; }
QPushButton:default { border-color: #6f6f6f; }
QToolButton { padding: 3px 5px; }
QToolButton[autoRaise="true"] { background: transparent; border: 1px solid transparent; }
QToolButton[autoRaise="true"]:hover { background: #505050; }
QToolButton[autoRaise="true"]:focus { border-color: #5a8fc8; }
QToolButton::menu-indicator { image: none; }
QToolButton[groupHead="true"] { background: #434343; border: none; border-top: 1px solid #4d4d4d; border-bottom: 1px solid #2f2f2f; border-radius: 0; padding: 5px 8px;
  text-align: left; color: #e0e0e0; font-weight: 500; }
QToolButton[groupHead="true"]:hover { background: #4a4a4a; }
QToolButton[groupHead="true"]:focus { border-bottom: 1px solid #5a8fc8; }

QCheckBox { spacing: 7px; min-height: 22px; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid #262626; border-radius: 3px; background: #2c2c2c; }
QCheckBox::indicator:hover { border-color: #6a6a6a; }
QCheckBox::indicator:focus { border-color: #5a8fc8; }
QCheckBox::indicator:checked { background: #b9b9b9; border-color: #b9b9b9; image: url(:/dermis/check.svg); }
QCheckBox:focus { color: #ffffff; }

QAbstractItemView { background: #323232; alternate-background-color: #353535; border: none; outline: none; color: #d8d8d8; }
QListView::item { padding: 4px 6px; border-radius: 3px; }
QListView::item:hover { background: #3f3f3f; }
QListView::item:selected { background: #4c5866; color: #ffffff; }
QHeaderView::section { background: #3a3a3a; border: none; padding: 4px 6px; }

QProgressBar { background: #2a2a2a; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; text-align: center; }
QProgressBar::chunk { background: #a0a0a0; border-radius: 3px; }

QToolTip { background: #1f1f1f; color: #e0e0e0; border: 1px solid #505050; padding: 5px 7px; }
QFrame[popup="true"] { background: #383838; border: 1px solid #1d1d1d; border-radius: 4px; }
QFrame[messageBar="true"] { background: #454545; border: none; border-bottom: 1px solid #262626; }
QFrame[toolStrip="true"] { background: #383838; border-bottom: 1px solid #2a2a2a; }
QFrame[dropZone="true"] { background: #333333; border: 1px dashed #5a5a5a; border-radius: 4px; }
QFrame[dropZone="true"][dropActive="true"] { border: 1px dashed #5a8fc8; background: #384048; }
QFrame[card="true"] { background: #353535; border: 1px solid #2c2c2c; border-radius: 4px; }
QDialog { background: #3a3a3a; }
)css");
}

}  // namespace dermis
