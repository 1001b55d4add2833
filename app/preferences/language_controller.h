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

/// The language menu: a choice is remembered, and the window speaks it from then on.
class LanguageController : public QObject {
    Q_OBJECT
public:
    LanguageController(ui::WindowActions& actions, QWidget& window, QObject* parent = nullptr);

private:
    void choose(const QString& code);

    QWidget& window_;
};

/// Vessels and residuals take the colours that the user chose; for pictures that are drawn without a window.
void applyChosenColors();

/// The menu of colours for vessels and residuals, each readable with any colour vision.
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
