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

/// Provides the language menu; stores the choice and switches the window at once.
class LanguageController : public QObject {
    Q_OBJECT
public:
    LanguageController(ui::WindowActions& actions, QWidget& window, QObject* parent = nullptr);

private:
    void choose(const QString& code);

    QWidget& window_;
};

/// Applies the user's color scheme for vessels and residuals, for images rendered without a window.
void applyColorSetting();

/// Provides the menu of color schemes for vessels and residuals, all distinguishable with any type of color vision.
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
