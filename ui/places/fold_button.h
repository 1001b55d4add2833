#pragma once

#include "ui/places/column_rail.h"

namespace angiopose::ui {

/// The visible handle on a column's border: a chevron towards the side where the column goes when it folds.
class FoldButton : public QAbstractButton {
    Q_OBJECT
public:
    FoldButton(ColumnSide side, const Words& folds, QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ColumnSide side_;
};

}   // namespace angiopose::ui
