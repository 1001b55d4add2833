#pragma once

#include <QObject>

class QPixmap;

class QWidget;

namespace angiopose::ui {
class BottomStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Pictures of the whole window, as it is: to the clipboard, or into a file.
class PictureController : public QObject {
    Q_OBJECT
public:
    PictureController(ui::WindowActions& actions, ui::BottomStrip& strip, QWidget& window, QObject* parent = nullptr);

private:
    void copy();
    void askFile();
    void askFileFor(const QPixmap& picture);   ///< in an event of its own: either takes most of what one may take

    ui::BottomStrip& strip_;
    QWidget& window_;
};

}   // namespace angiopose::app