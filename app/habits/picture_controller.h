#pragma once

#include <QObject>

namespace ui {
class MainWindow;
}

namespace app {

/// Pictures of the whole window, as it is: to the clipboard, or into a file.
class PictureController : public QObject {
    Q_OBJECT
public:
    explicit PictureController(ui::MainWindow& window, QObject* parent = nullptr);

private:
    void copy();
    void askFile();

    ui::MainWindow& window_;
};

}   // namespace app
