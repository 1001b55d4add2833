#pragma once

#include <QObject>

class QTimer;
class QWidget;

namespace angiopose::ui {

/// Minimum height of a widget with changing content: grows at once and shrinks only after the content has been stable
/// for a while, to keep the widgets below it from jumping under the pointer.
class LingeringHeight : public QObject {
public:
    /// `minPx` is the initial minimum height. Owned by the widget.
    LingeringHeight(QWidget& widget, int minPx);

    void ask(int heightPx);

private:
    QWidget& widget_;
    QTimer* rest_;
    int wantedPx_;
};

inline constexpr int restBeforeShrinkingMs = 1500;

}   // namespace angiopose::ui
