#include "ui/help/tour.h"

#include "ui/controls/section.h"
#include "ui/theme/active_theme.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr int bubbleWidth = 360;
constexpr int bubbleGap = 14;   ///< distance between bubble and target

/// Returns the position of a bubble of `size`: beside the target if there is space, otherwise at its lower edge.
QPoint placeBeside(const QRect& target, const QSize& size, const QRect& bounds)
{
    const int y = std::clamp(target.center().y() - size.height() / 2, bounds.top(), bounds.bottom() - size.height());
    const int x = std::clamp(target.center().x() - size.width() / 2, bounds.left(), bounds.right() - size.width());
    const std::array places{QPoint(target.right() + bubbleGap, y), QPoint(target.left() - bubbleGap - size.width(), y),
                            QPoint(x, target.bottom() + bubbleGap),
                            QPoint(x, target.top() - bubbleGap - size.height())};
    const auto* match =
        std::ranges::find_if(places, [&](const QPoint& place) { return bounds.contains(QRect(place, size)); });
    return match == places.end() ? QPoint(x, target.bottom() - bubbleGap - size.height()) : *match;
}

}   // namespace

/// Outline around the target, transparent for mouse events.
class Tour::Frame : public QWidget {
public:
    using QWidget::QWidget;

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(toQColor(activePalette().accent), 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
    }
};

Tour::Tour(std::vector<TourStop> stops, QWidget* window)
    : QWidget(window),
      stops_(std::move(stops)),
      heading_(roleLabel("heading")),
      text_(roleLabel("body")),
      count_(roleLabel("hint")),
      back_(new QPushButton(tr("Back"))),
      next_(new QPushButton),
      frame_(new Frame(window))
{
    setObjectName(QStringLiteral("tour"));
    setAttribute(Qt::WA_DeleteOnClose);
    setFocusPolicy(Qt::StrongFocus);
    frame_->setAttribute(Qt::WA_TransparentForMouseEvents);
    text_->setWordWrap(true);
    next_->setProperty("role", "primary");
    auto* skip = new QPushButton(tr("Skip"));
    for (QPushButton* button : {skip, back_}) {
        button->setProperty("role", "quiet");
    }
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(count_);
    buttons->addStretch(1);
    buttons->addWidget(skip);
    buttons->addWidget(back_);
    buttons->addWidget(next_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 12);
    layout->setSpacing(8);
    layout->addWidget(heading_);
    layout->addWidget(text_);
    layout->addLayout(buttons);
    setFixedWidth(bubbleWidth);
    connect(skip, &QPushButton::clicked, this, &Tour::end);
    connect(back_, &QPushButton::clicked, this, [this] { goTo(current_ - 1); });
    connect(next_, &QPushButton::clicked, this, &Tour::showNextStop);
    window->installEventFilter(this);
    goTo(0);
    show();
    next_->setFocus();
}

Tour::~Tour()
{
    delete frame_;   // null if already deleted with the window
}

void Tour::goTo(int stop)
{
    if (stop >= stopCount()) {
        end();
        return;
    }
    current_ = std::max(0, stop);
    const TourStop& currentStop = stops_[static_cast<std::size_t>(current_)];
    heading_->setText(currentStop.heading);
    text_->setText(currentStop.text);
    setAccessibleName(currentStop.heading);
    count_->setText(tr("%1 of %2").arg(current_ + 1).arg(stopCount()));
    back_->setEnabled(current_ > 0);
    next_->setText(current_ + 1 == stopCount()        ? tr("Done")
                   : currentStop.leaveLabel.isEmpty() ? tr("Next")
                                                      : currentStop.leaveLabel);
    place();
}

void Tour::showNextStop()
{
    if (const auto& leave = stops_[static_cast<std::size_t>(current_)].onLeave) {
        leave();
    }
    goTo(current_ + 1);
}

QRect Tour::targetRect() const
{
    const QWidget* target = stops_[static_cast<std::size_t>(current_)].target;
    if (!target || !target->isVisible()) {
        return parentWidget()->rect();
    }
    const QRect whole(target->mapTo(parentWidget(), QPoint(0, 0)), target->size());
    return whole.intersected(parentWidget()->rect());
}

void Tour::place()
{
    const QRect target = targetRect();
    const QRect bounds = parentWidget()->rect().adjusted(8, 8, -8, -8);
    layout()->activate();
    resize(bubbleWidth, layout()->heightForWidth(bubbleWidth));
    move(placeBeside(target, size(), bounds));
    frame_->setGeometry(target.adjusted(-2, -2, 2, 2).intersected(parentWidget()->rect()));
    frame_->show();
    frame_->raise();
    raise();
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

void Tour::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
        case Qt::Key_Escape:
            end();
            break;
        case Qt::Key_Return:   // Enter triggers the focused button, as in a dialog
        case Qt::Key_Enter:
            if (auto* button = qobject_cast<QPushButton*>(focusWidget())) {
                button->click();
            } else {
                showNextStop();
            }
            break;
        case Qt::Key_Right:
            showNextStop();
            break;
        case Qt::Key_Left:
            goTo(current_ - 1);
            break;
        default:
            QWidget::keyPressEvent(event);
    }
}

void Tour::paintEvent(QPaintEvent*)
{
    const Palette& colors = activePalette();
    QPainter painter(this);
    painter.fillRect(rect(), toQColor(colors.panel));
    painter.setPen(toQColor(colors.accent));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));   // aligned to whole pixels at any scale
}

void Tour::end()
{
    if (frame_) {
        frame_->hide();
    }
    emit ended();
    close();
}

}   // namespace angiopose::ui
