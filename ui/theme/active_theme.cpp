#include "ui/theme/active_theme.h"

#include "ui/theme/theme.h"

#include <QFont>
#include <QFontDatabase>
#include <QPalette>
#include <QStyleFactory>

#include <array>
#include <string>
#include <utility>

namespace angiopose::ui {
namespace {

/// Style sheet pattern in which each `@name@` stands for a palette color or a mixture of two.
constexpr const char* panelStylePattern = R"(
QLabel[role="heading"] { color: @text@; font-weight: 600; }
QLabel[role="title"] { color: @textStrong@; font-weight: 600; }
QLabel[role="welcome"] { color: @textStrong@; font-size: 20px; font-weight: 600; }
QLabel[role="strong"] { color: @textStrong@; }
QLabel[role="body"] { color: @text@; }
QLabel[role="label"] { color: @label@; }
QLabel[role="hint"] { color: @hint@; font-size: 12px; }
QLabel[role="attention"] { color: @attention@; }
QLabel[role="bigNumber"] { color: @textStrong@; font-size: 24px; font-weight: 600; }
QLabel[role="bigNumberDoubtful"] { color: @attention@; font-size: 24px; font-weight: 600; }
QLabel[role="fineBox"], QLabel[role="attentionBox"], QLabel[role="errorBox"] { border-radius: 4px; padding: 8px 10px; }
QLabel[role="fineBox"] { background: @fineBack@; border: 1px solid @fineLine@; color: @fineText@; }
QLabel[role="attentionBox"] { background: @attentionBack@; border: 1px solid @attentionLine@; color: @attentionText@; }
QLabel[role="errorBox"] { background: @errorBack@; border: 1px solid @errorLine@; color: @errorText@; font-weight: 600; }
QListView { background: transparent; border: none; }
QProgressBar, QProgressBar::chunk { border-radius: 2px; }
QSplitter::handle:horizontal { width: 1px; }
QSplitter::handle:vertical { height: 1px; }
QSplitter[role="columns"]::handle { background: @panel@; }
QDialog { background: @panel@; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QWidget[role="header"] { background: @title@; }
QWidget[role="stepBar"], QWidget[role="column"], QWidget[role="strip"] { background: @panel@; }
QWidget[role="canvas"] { background: @canvas@; }
QFrame[role="imageBar"] { background: @panel@; border: 1px solid @line@; border-radius: 6px; }
QFrame[role="imageBar"] QToolButton, QFrame[role="imageBar"] QPushButton { padding: 3px 8px; }
QFrame[role="imageBar"] QLabel { background: transparent; border: none; }
QWidget[role="welcome"] { background: @field@; }
QScrollArea[role="column"], QScrollArea[role="column"] > QWidget > QWidget { border: none; background: @panel@; }
QLineEdit[role="number"] { background: @field@; border: 1px solid @line@; border-radius: 3px; padding: 3px 8px;
  color: @textStrong@; selection-background-color: @accent@; }
QLineEdit[role="number"][asking="true"] { background: @attentionBack@; border-color: @attention@; }
QLineEdit[role="number"]:focus { border-color: @accent@; }
QLineEdit[role="number"]:disabled, QLineEdit[role="number"]:read-only { color: @hint@; }
QPushButton[role="primary"] { background: @accent@; border-color: @accent@; color: @onAccent@; font-weight: 600; }
QPushButton[role="primary"]:hover { background: @accentHover@; }
QPushButton[role="primary"]:focus { border-color: @textStrong@; }
QPushButton[role="primary"]:disabled { background: @line@; border-color: @line@; color: @hint@; }
QPushButton[role="quiet"] { border-color: transparent; color: @label@; padding: 3px 8px; }
QPushButton[role="quiet"]:hover, QPushButton[role="quiet"]:focus { border-color: @line@; color: @textStrong@; }
QPushButton[role="recent"] { border-color: transparent; background: transparent; color: @accent@; padding: 3px 10px 3px 4px; text-align: left; }
QPushButton[role="recent"]:hover, QPushButton[role="recent"]:focus { border-color: @line@; background: @field@; }
QPushButton[role="recent"]:disabled { color: @hint@; }
QPushButton[role="link"] { border: none; background: transparent; color: @accent@; padding: 2px 6px; }
QPushButton[role="link"]:hover { text-decoration: underline; }
QPushButton[role="link"]:disabled { color: @hint@; }
QToolButton[role="tab"] { border: none; background: transparent; color: @label@; padding: 3px 1px; border-radius: 3px; }
QToolButton[role="tabTool"] { border: none; background: transparent; color: @label@; padding: 3px 0px; border-radius: 3px; }
QToolButton[role="tabTool"]:hover, QToolButton[role="tabTool"]:focus,
QToolButton[role="tab"]:hover, QToolButton[role="tab"]:focus { color: @textStrong@; background: @field@; }
QToolButton[role="tab"]:checked { color: @textStrong@; background: @field@; font-weight: 600; }
QToolButton[role="fold"] { border: none; background: transparent; padding: 0px; width: 12px; height: 12px; }
QToolButton[role="fold"]:focus { border: 1px solid @accent@; border-radius: 3px; width: 10px; height: 10px; }
)";

void replaceAll(std::string& text, const std::string& name, const Color& color)
{
    const std::string token = "@" + name + "@";
    const std::string value = color.hex();
    for (auto at = text.find(token); at != std::string::npos; at = text.find(token, at + value.size())) {
        text.replace(at, token.size(), value);
    }
}

/// Returns the style sheet of the panels, which sets colors by the `role` property of labels, buttons and fields.
std::string panelStyleSheet(const Palette& colors)
{
    const std::array<std::pair<const char*, Color>, 24> named{{
        {"title", colors.title},
        {"window", colors.window},
        {"panel", colors.panel},
        {"field", colors.field},
        {"line", colors.line},
        {"textStrong", colors.textStrong},
        {"text", colors.text},
        {"label", colors.label},
        {"hint", colors.hint},
        {"accent", colors.accent},
        {"accentHover", mixed(colors.accent, colors.textStrong, 0.2)},
        {"onAccent", mixed(colors.window, colors.title, 0.5)},
        {"attention", colors.attention},
        {"canvas", colors.canvas},
        {"fineBack", mixed(colors.panel, colors.fine, 0.10)},
        {"fineLine", mixed(colors.panel, colors.fine, 0.30)},
        {"fineText", mixed(colors.text, colors.fine, 0.55)},
        {"attentionBack", mixed(colors.panel, colors.attention, 0.10)},
        {"attentionLine", mixed(colors.panel, colors.attention, 0.35)},
        {"attentionText", mixed(colors.text, colors.attention, 0.60)},
        {"fine", colors.fine},
        {"errorBack", mixed(colors.panel, colors.error, 0.10)},
        {"errorLine", mixed(colors.panel, colors.error, 0.35)},
        {"errorText", mixed(colors.text, colors.error, 0.60)},
    }};
    std::string sheet = panelStylePattern;
    for (const auto& [name, color] : named) {
        replaceAll(sheet, name, color);
    }
    return sheet;
}

ThemeMode current = ThemeMode::Dark;

QPalette qtPalette(const Palette& colors)
{
    QPalette result;
    result.setColor(QPalette::Window, toQColor(colors.window));
    result.setColor(QPalette::Base, toQColor(colors.field));
    result.setColor(QPalette::AlternateBase, toQColor(colors.panel));
    result.setColor(QPalette::Button, toQColor(colors.panel));
    result.setColor(QPalette::ToolTipBase, toQColor(colors.title));
    result.setColor(QPalette::Highlight, toQColor(colors.accent));
    result.setColor(QPalette::HighlightedText, toQColor(colors.window));
    result.setColor(QPalette::Link, toQColor(colors.accent));
    result.setColor(QPalette::PlaceholderText, toQColor(colors.hint));
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText}) {
        result.setColor(role, toQColor(colors.text));
        result.setColor(QPalette::Disabled, role, toQColor(colors.hint));
    }
    return result;
}

QFont interfaceFont(QFont font)
{
    QStringList families;
    // Inter has no Chinese glyphs. The fallback font is fixed, since a font that the system selects might show Japanese
    // glyph variants.
    for (const QString& preferredFont : {QStringLiteral("Inter"), QStringLiteral("Noto Sans CJK SC")}) {
        if (QFontDatabase::families().contains(preferredFont)) {
            families << preferredFont;
        }
    }
    font.setFamilies(families << font.family());
    font.setPixelSize(13);
    return font;
}

}   // namespace

ThemeMode activeTheme()
{
    return current;
}

const Palette& activePalette()
{
    return palette(current);
}

void applyTheme(QApplication& application, ThemeMode mode)
{
    current = mode;
    const Palette& colors = palette(mode);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(qtPalette(colors));
    QApplication::setFont(interfaceFont(QApplication::font()));
    application.setStyleSheet(QString::fromStdString(styleSheet(colors) + panelStyleSheet(colors)));
}

ThemeMode systemTheme(const QApplication& application)
{
    return application.palette().color(QPalette::Window).lightness() > 127 ? ThemeMode::Light : ThemeMode::Dark;
}

QColor toQColor(const Color& color)
{
    return {color.red, color.green, color.blue};
}

QColor toQColor(const Color& color, double opacity)
{
    QColor result = toQColor(color);
    result.setAlphaF(static_cast<float>(opacity));
    return result;
}

}   // namespace angiopose::ui
