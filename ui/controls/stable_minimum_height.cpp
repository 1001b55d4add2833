#include "ui/controls/stable_minimum_height.h"

#include <QTimer>
#include <QWidget>

namespace angiopose::ui {

StableMinimumHeight::StableMinimumHeight(QWidget& widget, int minPx)
    : QObject(&widget), widget_(widget), shrinkTimer_(new QTimer(this)), requestedPx_(minPx)
{
    widget.setMinimumHeight(minPx);
    shrinkTimer_->setSingleShot(true);
    shrinkTimer_->setInterval(shrinkDelayMs);
    connect(shrinkTimer_, &QTimer::timeout, this, [this] { widget_.setMinimumHeight(requestedPx_); });
}

void StableMinimumHeight::requestHeight(int heightPx)
{
    requestedPx_ = heightPx;
    if (heightPx < widget_.minimumHeight()) {
        shrinkTimer_->start();
        return;
    }
    shrinkTimer_->stop();
    widget_.setMinimumHeight(heightPx);
}

}   // namespace angiopose::ui
