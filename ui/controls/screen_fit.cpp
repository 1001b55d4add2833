#include "ui/controls/screen_fit.h"

#include <QScreen>

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr QSize windowFrame(8, 40);

}   // namespace

void fitToScreen(const QRect& available, QWidget& window)
{
    if (window.isMaximized() || window.isFullScreen() || available.contains(window.geometry())) {
        return;
    }
    QRect rect(window.pos(), window.size().boundedTo(available.size()));
    rect.moveRight(std::min(rect.right(), available.right()));
    rect.moveBottom(std::min(rect.bottom(), available.bottom()));
    rect.moveLeft(std::max(rect.left(), available.left()));
    rect.moveTop(std::max(rect.top(), available.top()));
    window.setGeometry(rect);
}

void resizeWithinScreen(QWidget& window, const QSize& requestedSize)
{
    window.resize(requestedSize.boundedTo(window.screen()->availableSize() - windowFrame));
}

}   // namespace angiopose::ui
