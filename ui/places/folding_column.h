#pragma once

#include "ui/places/column_rail.h"

#include <QWidget>

class QSplitterHandle;

namespace angiopose::ui {

/// A column of the window that folds to a rail and remembers how wide it was. What is in it stays alive meanwhile.
class FoldingColumn : public QWidget {
    Q_OBJECT
public:
    /// Owns the content. `behind` names what is in it.
    FoldingColumn(ColumnSide side, QWidget& content, const Words& behind, QWidget* parent = nullptr);

    bool isFolded() const { return isFolded_; }
    void setFolded(bool folded);
    void holdOpen(bool hold);   ///< as long as this holds the content is shown, folded or not

    int openWidth() const { return openWidth_; }   ///< that it has, or had before it was folded
    void setOpenWidth(int width) { openWidth_ = width; }

    /// A button in the middle of the column's border that folds it.
    void placeButton(QSplitterHandle& border);

signals:
    void foldedChanged(bool folded);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();
    void placeRail();
    void showContent();
    bool isRail() const;

    ColumnSide side_;
    QWidget* content_;
    ColumnRail* rail_;
    QWidget* button_ = nullptr;
    int openWidth_ = 0;
    bool isFolded_ = false;
    bool isHeldOpen_ = false;
};

}   // namespace angiopose::ui
