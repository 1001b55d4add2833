#pragma once

#include <QAbstractButton>

namespace angiopose::ui {

/// Padlock beside a degree of freedom: open means free, closed and amber means locked.
class LockDot : public QAbstractButton {
    Q_OBJECT
public:
    explicit LockDot(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {22, 22}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

}   // namespace angiopose::ui