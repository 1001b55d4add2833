#pragma once

#include <QObject>

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// The language menu: a choice is remembered, and the window speaks it from then on.
class LanguageController : public QObject {
    Q_OBJECT
public:
    explicit LanguageController(ui::MainWindow& window, QObject* parent = nullptr);

private:
    void choose(const QString& code);

    ui::MainWindow& window_;
};

}   // namespace angiopose::app