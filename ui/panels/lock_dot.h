#pragma once

#include <QAbstractButton>

namespace angiopose::ui {

/// The padlock beside a degree of freedom: open it is free, closed and amber it is locked.
class LockDot : public QAbstractButton {
    Q_OBJECT
public:
    explicit LockDot(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {22, 22}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

}   // namespace angiopose::ui