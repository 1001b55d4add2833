#pragma once

#include <QObject>

namespace ui {
class MainWindow;
}

namespace app {

/// The language menu. A choice is remembered and reported: whoever owns the window makes it speak otherwise.
class LanguageController : public QObject {
    Q_OBJECT
public:
    explicit LanguageController(ui::MainWindow& window, QObject* parent = nullptr);

signals:
    void chosen();

private:
    void choose(const QString& code);

    ui::MainWindow& window_;
};

}   // namespace app
