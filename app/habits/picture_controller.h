#pragma once

#include <QObject>

class QPixmap;

namespace angiopose::ui {
class MainWindow;
}

namespace angiopose::app {

/// Pictures of the whole window, as it is: to the clipboard, or into a file.
class PictureController : public QObject {
    Q_OBJECT
public:
    explicit PictureController(ui::MainWindow& window, QObject* parent = nullptr);

private:
    void copy();
    void askFile();
    void askFileFor(const QPixmap& picture);   ///< in an event of its own: either takes most of what one may take

    ui::MainWindow& window_;
};

}   // namespace angiopose::app