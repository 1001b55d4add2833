#pragma once

#include <QObject>

class QWidget;

namespace angiopose::ui {
class WindowActions;
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

}   // namespace angiopose::app