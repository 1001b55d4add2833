#pragma once

#include <QObject>

namespace ui {
class MainWindow;
}

namespace app {

/// The language menu. A choice holds from the next start: the window that is open keeps its words.
class LanguageController : public QObject {
    Q_OBJECT
public:
    explicit LanguageController(ui::MainWindow& window, QObject* parent = nullptr);

private:
    void choose(const QString& code);

    ui::MainWindow& window_;
};

}   // namespace app
