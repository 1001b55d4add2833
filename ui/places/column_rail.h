#pragma once

#include "ui/words/spoken.h"

#include <QAbstractButton>

namespace angiopose::ui {

enum class ColumnSide { Left, Right };

/// What is left of a folded column: a narrow button that names, along its height, what is behind it.
class ColumnRail : public QAbstractButton {
    Q_OBJECT
public:
    ColumnRail(ColumnSide side, const Words& behind, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {sizeHint().width(), 80}; }
    static int wordsRoomPx(int height);   ///< along a rail of this height

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ColumnSide side_;
};

/// A chevron that points to `side`, its middle at `at`, in the painter's pen.
void paintChevron(QPainter& painter, const QPointF& at, ColumnSide side);

}   // namespace angiopose::ui
