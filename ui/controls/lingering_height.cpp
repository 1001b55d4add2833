#include "ui/controls/lingering_height.h"

#include <QTimer>
#include <QWidget>

namespace angiopose::ui {

LingeringHeight::LingeringHeight(QWidget& widget, int minPx)
    : QObject(&widget), widget_(widget), rest_(new QTimer(this)), wantedPx_(minPx)
{
    widget.setMinimumHeight(minPx);
    rest_->setSingleShot(true);
    rest_->setInterval(restBeforeShrinkingMs);
    connect(rest_, &QTimer::timeout, this, [this] { widget_.setMinimumHeight(wantedPx_); });
}

void LingeringHeight::ask(int heightPx)
{
    wantedPx_ = heightPx;
    if (heightPx < widget_.minimumHeight()) {
        rest_->start();
        return;
    }
    rest_->stop();
    widget_.setMinimumHeight(heightPx);
}

}   // namespace angiopose::ui
