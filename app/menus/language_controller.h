#pragma once

#include <QObject>

class QWidget;

namespace angiopose::ui {
class AngiogramView;
class TreeView;
class WindowActions;
enum class ColorScheme;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Language menu: stores the choice and switches the window to it at once.
class LanguageController : public QObject {
    Q_OBJECT
public:
    LanguageController(ui::WindowActions& actions, QWidget& window, QObject* parent = nullptr);

private:
    void choose(const QString& code);

    QWidget& window_;
};

/// Applies the color scheme for vessels and residuals that the user chose; for images rendered without a window.
void applyChosenColors();

/// Menu of color schemes for vessels and residuals, all readable with any type of color vision.
class ColorController : public QObject {
    Q_OBJECT
public:
    ColorController(ui::WindowActions& actions, ui::AngiogramView& view, ui::TreeView& treeView, QWidget& window,
                    QObject* parent = nullptr);

private:
    void apply(ui::ColorScheme scheme);

    ui::AngiogramView& view_;
    ui::TreeView& treeView_;
    QWidget& window_;
};

}   // namespace angiopose::app
