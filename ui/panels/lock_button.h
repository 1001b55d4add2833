#pragma once

#include <QAbstractButton>

namespace angiopose::ui {

/// Padlock toggle for one degree of freedom: open if free, closed and amber if locked.
class LockButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit LockButton(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {22, 22}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

}   // namespace angiopose::ui
