#pragma once

#include <QObject>

class QTimer;
class QWidget;

namespace angiopose::ui {

/// The least height of a widget whose content comes and goes: it grows at once and shrinks only after the content has
/// been at rest, so that nothing below it moves under the hand.
class LingeringHeight : public QObject {
public:
    /// `least` holds from the start. Belongs to the widget.
    LingeringHeight(QWidget& widget, int minPx);

    void ask(int heightPx);

private:
    QWidget& widget_;
    QTimer* rest_;
    int wantedPx_;
};

inline constexpr int restBeforeShrinkingMs = 1500;

}   // namespace angiopose::ui
