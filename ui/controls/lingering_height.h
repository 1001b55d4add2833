#pragma once

#include <QObject>

class QTimer;
class QWidget;

namespace angiopose::ui {

/// Keeps the minimum height of a widget with changing content: grows at once, but shrinks only after a pause, to keep
/// the widgets below from jumping under the pointer.
class LingeringHeight : public QObject {
public:
    /// `minPx` is the initial minimum height. The widget owns this object.
    LingeringHeight(QWidget& widget, int minPx);

    void ask(int heightPx);

private:
    QWidget& widget_;
    QTimer* rest_;
    int wantedPx_;
};

inline constexpr int restBeforeShrinkingMs = 1500;

}   // namespace angiopose::ui
