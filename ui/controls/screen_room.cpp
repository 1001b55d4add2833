#include "ui/controls/screen_room.h"

#include <QScreen>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr QSize windowFrame(8, 40);

}   // namespace

void fitInto(const QRect& room, QWidget& window)
{
    if (window.isMaximized() || window.isFullScreen() || room.contains(window.geometry())) {
        return;
    }
    QRect place(window.pos(), window.size().boundedTo(room.size()));
    place.moveRight(std::min(place.right(), room.right()));
    place.moveBottom(std::min(place.bottom(), room.bottom()));
    place.moveLeft(std::max(place.left(), room.left()));
    place.moveTop(std::max(place.top(), room.top()));
    window.setGeometry(place);
}

void resizeOnScreen(QWidget& window, const QSize& wanted)
{
    window.resize(wanted.boundedTo(window.screen()->availableSize() - windowFrame));
}

}   // namespace angiopose::ui
