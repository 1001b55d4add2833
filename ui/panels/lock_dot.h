#pragma once

#include <QAbstractButton>

namespace angiopose::ui {

/// Round switch beside a degree of freedom: an open ring is free, a filled amber dot is locked.
class LockDot : public QAbstractButton {
    Q_OBJECT
public:
    explicit LockDot(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {22, 22}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

}   // namespace angiopose::ui