#include "ui/theme/theme.h"

#include <utility>
#include <vector>

namespace angiopose::ui {
namespace {

/// `@name@` is replaced by a palette color. Lengths are device-independent px: Qt scales them with the screen.
constexpr const char* styleSheetPattern = R"(
* { outline: none; }
QWidget { color: @text@; }
QMainWindow, QDialog { background: @window@; }
QFrame[frameShape="4"], QFrame[frameShape="5"] { color: @line@; }

QPushButton, QToolButton { background: @button@; border: 1px solid @line@; border-radius: 4px; padding: 5px 12px;
  color: @text@; }
QToolButton { padding: 4px 8px; }
QPushButton:hover, QToolButton:hover { background: @buttonHover@; color: @textStrong@; }
QPushButton:pressed, QToolButton:pressed { background: @field@; }
QPushButton:checked, QToolButton:checked { background: @accentBack@; border-color: @accent@; color: @textStrong@; }
QPushButton:focus, QToolButton:focus { border: 1px solid @accent@; }
QPushButton:disabled, QToolButton:disabled { color: @disabled@; background: transparent; }
QPushButton:default { border-color: @accent@; }
QToolButton::menu-indicator { image: none; }

QLineEdit, QAbstractSpinBox, QComboBox, QPlainTextEdit, QTextEdit { background: @field@; border: 1px solid @line@;
  border-radius: 3px; padding: 3px 8px; color: @textStrong@; selection-background-color: @accent@;
  selection-color: @onAccent@; }
QLineEdit:hover, QAbstractSpinBox:hover, QComboBox:hover { border-color: @hint@; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus, QPlainTextEdit:focus, QTextEdit:focus {
  border: 1px solid @accent@; }
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled { color: @disabled@; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { width: 0px; border: none; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { width: 0px; height: 0px; border-left: 4px solid @field@; border-right: 4px solid @field@;
  border-top: 5px solid @label@; margin-right: 8px; }
QComboBox QAbstractItemView { background: @panel@; border: 1px solid @line@; padding: 3px;
  selection-background-color: @row@; selection-color: @textStrong@; }

QCheckBox, QRadioButton { spacing: 7px; background: transparent; }
QCheckBox:focus, QRadioButton:focus { color: @textStrong@; }
QCheckBox::indicator, QRadioButton::indicator { width: 14px; height: 14px; border: 1px solid @hint@;
  background: @field@; }
QCheckBox::indicator { border-radius: 3px; }
QRadioButton::indicator { border-radius: 8px; }
QCheckBox::indicator:hover, QRadioButton::indicator:hover, QCheckBox::indicator:focus, QRadioButton::indicator:focus {
  border-color: @accent@; }
QCheckBox::indicator:checked { border-color: @accent@; background: @accent@; image: url(:/icons/tick.svg); }
QCheckBox::indicator:checked:focus { border-color: @textStrong@; }
QCheckBox::indicator:disabled { border-color: @line@; }
QRadioButton::indicator:checked { border: 4px solid @field@; background: @accent@; }
QRadioButton::indicator:checked:focus { border-color: @accentBack@; }
QCheckBox:disabled, QRadioButton:disabled { color: @disabled@; }

QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @line@; }
QSlider::sub-page:horizontal { border-radius: 2px; background: @accent@; }
QSlider::handle:horizontal { width: 12px; height: 12px; margin: -4px 0; border-radius: 6px; background: @text@; }
QSlider::handle:horizontal:hover { background: @textStrong@; }
QSlider::handle:horizontal:focus { background: @accent@; }

QAbstractItemView { background: @panel@; border: none; alternate-background-color: @window@; color: @text@; }
QAbstractItemView[role="well"] { border: 1px solid @line@; border-radius: 4px; }
QAbstractItemView::item { padding: 3px 6px; border: none; }
QAbstractItemView::item:hover { background: @rowHover@; }
QAbstractItemView::item:selected { background: @row@; color: @textStrong@; }
QAbstractItemView::indicator { width: 14px; height: 14px; border: 1px solid @hint@; border-radius: 3px;
  background: @field@; }
QAbstractItemView::indicator:hover { border-color: @accent@; }
QAbstractItemView::indicator:checked { border-color: @accent@; background: @accent@; image: url(:/icons/tick.svg); }
QHeaderView::section { background: @panel@; color: @label@; border: none; padding: 4px 6px; }

QScrollBar { background: transparent; margin: 0; }
QScrollBar:vertical { width: 9px; }
QScrollBar:horizontal { height: 9px; }
QScrollBar::handle { background: @scroll@; border-radius: 3px; margin: 1px 2px; }
QScrollBar::handle:vertical { min-height: 28px; }
QScrollBar::handle:horizontal { min-width: 28px; margin: 2px 1px; }
QScrollBar::handle:hover { background: @hint@; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QScrollArea { border: none; background: transparent; }

QTabBar::tab { background: transparent; color: @label@; padding: 6px 12px; border-bottom: 2px solid transparent; }
QTabBar::tab:hover { color: @textStrong@; }
QTabBar::tab:selected { color: @textStrong@; border-bottom-color: @accent@; }
QTabBar::tab:focus { color: @accent@; }
QTabWidget::pane { border: none; }

QMenuBar { background: @title@; color: @text@; }
QMenuBar::item { padding: 5px 9px; background: transparent; }
QFileDialog QToolButton { padding: 1px; }
QMenuBar QToolButton { padding: 0px; border: none; background: transparent; }
QMenuBar::item:selected { background: @row@; color: @textStrong@; }
QMenu { background: @panel@; border: 1px solid @line@; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 24px; border-radius: 3px; }
QMenu::item:selected { background: @row@; color: @textStrong@; }
QMenu::item:disabled { color: @disabled@; }
QMenu::separator { height: 1px; background: @line@; margin: 4px 6px; }
QToolTip { background: @title@; color: @text@; border: 1px solid @line@; padding: 4px 7px; }
QProgressBar { background: @field@; border: none; border-radius: 3px; color: @text@; text-align: center; }
QProgressBar::chunk { background: @accent@; border-radius: 3px; }
QSplitter::handle { background: @line@; }
QStatusBar { background: @window@; color: @label@; }
QStatusBar::item { border: none; }
QGroupBox { border: none; margin-top: 18px; color: @label@; }
QGroupBox::title { subcontrol-origin: margin; left: 0; color: @label@; }
)";

std::vector<std::pair<std::string, Color>> colors(const Palette& p)
{
    return {{"title", p.title},
            {"window", p.window},
            {"panel", p.panel},
            {"field", p.field},
            {"line", p.line},
            {"textStrong", p.textStrong},
            {"text", p.text},
            {"label", p.label},
            {"hint", p.hint},
            {"accent", p.accent},
            {"button", mixed(p.panel, p.textStrong, 0.04)},
            {"buttonHover", mixed(p.panel, p.textStrong, 0.10)},
            {"disabled", mixed(p.panel, p.hint, 0.65)},
            {"onAccent", mixed(p.field, p.title, 0.5)},
            {"accentBack", mixed(p.panel, p.accent, 0.18)},
            {"row", mixed(p.panel, p.accent, 0.12)},
            {"rowHover", mixed(p.panel, p.textStrong, 0.05)},
            {"scroll", mixed(p.panel, p.hint, 0.45)}};
}

}   // namespace

std::string styleSheet(const Palette& palette)
{
    std::string sheet;
    const std::string source = styleSheetPattern;
    const auto named = colors(palette);
    std::size_t at = 0;
    while (at < source.size()) {
        const std::size_t open = source.find('@', at);
        sheet += source.substr(at, open - at);
        if (open == std::string::npos) {
            break;
        }
        const std::size_t close = source.find('@', open + 1);
        const std::string name = source.substr(open + 1, close - open - 1);
        for (const auto& [toneName, color] : named) {
            if (toneName == name) {
                sheet += color.hex();
            }
        }
        at = close + 1;
    }
    return sheet;
}

}   // namespace angiopose::ui
