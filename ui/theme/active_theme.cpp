#include "ui/theme/active_theme.h"

#include "ui/theme/panel_style.h"

#include <QFont>
#include <QFontDatabase>
#include <QPalette>
#include <QStyleFactory>

namespace angiopose::ui {
namespace {

ThemeMode current = ThemeMode::Dark;

QPalette qtPalette(const Palette& tones)
{
    QPalette result;
    result.setColor(QPalette::Window, toQColor(tones.window));
    result.setColor(QPalette::Base, toQColor(tones.field));
    result.setColor(QPalette::AlternateBase, toQColor(tones.panel));
    result.setColor(QPalette::Button, toQColor(tones.panel));
    result.setColor(QPalette::ToolTipBase, toQColor(tones.title));
    result.setColor(QPalette::Highlight, toQColor(tones.accent));
    result.setColor(QPalette::HighlightedText, toQColor(tones.window));
    result.setColor(QPalette::Link, toQColor(tones.accent));
    result.setColor(QPalette::PlaceholderText, toQColor(tones.hint));
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText}) {
        result.setColor(role, toQColor(tones.text));
        result.setColor(QPalette::Disabled, role, toQColor(tones.hint));
    }
    return result;
}

QFont interfaceFont(QFont font)
{
    QStringList families;
    // Inter has no Chinese glyphs; the fallback font is fixed because an arbitrary one might have Japanese glyph
    // variants.
    for (const QString& wanted : {QStringLiteral("Inter"), QStringLiteral("Noto Sans CJK SC")}) {
        if (QFontDatabase::families().contains(wanted)) {
            families << wanted;
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
    const Palette& tones = palette(mode);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(qtPalette(tones));
    QApplication::setFont(interfaceFont(QApplication::font()));
    application.setStyleSheet(QString::fromStdString(styleSheet(tones) + panelStyleSheet(tones)));
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