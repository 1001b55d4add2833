#pragma once

#include <QObject>

class QTimer;
class QWidget;

namespace angiopose::ui {

/// Keeps the minimum height of a widget with changing content: grows at once, but shrinks only after a pause, to keep
/// the widgets below from jumping under the pointer.
class StableMinimumHeight : public QObject {
public:
    /// `minPx` is the initial minimum height. The widget owns this object.
    StableMinimumHeight(QWidget& widget, int minPx);

    void requestHeight(int heightPx);

private:
    QWidget& widget_;
    QTimer* shrinkTimer_;
    int requestedPx_;
};

inline constexpr int shrinkDelayMs = 1500;

}   // namespace angiopose::ui
