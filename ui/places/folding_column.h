#pragma once

#include "ui/words/spoken.h"

#include <QAbstractButton>
#include <QByteArray>
#include <QWidget>
#include <optional>

class QSplitterHandle;

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

inline constexpr int columnBorderWidth = 9;   ///< with the button that folds the column

/// Widths and folding of the columns beside the image, and how much of the left one's height the 3-D view has.
struct ColumnLayout {
    int leftWidth = 300;
    int rightWidth = 320;
    bool isLeftFolded = false;
    bool isRightFolded = false;
    double cornerShare = 0.42;

    bool operator==(const ColumnLayout&) const = default;
};

/// What the window is used for in a step: a scan is traced, vessels are registered, or a result is looked at.
enum class Work { Tracing, Registering, Reviewing };

/// Which columns a work needs, in a window of this width.
ColumnLayout columnsFor(Work work, int windowWidth);

/// How the window stands in one work.
struct WorkLayout {
    ColumnLayout columns;
    bool areSlicesLarge = false;
    int cornerPlane = 0;   ///< 0: 3-D, then `core::bodyPlanes`

    bool operator==(const WorkLayout&) const = default;
};

/// As stored, and from there; none from bytes that are no layout.
QByteArray bytesOf(const WorkLayout& layout);
std::optional<WorkLayout> workLayoutOf(const QByteArray& bytes);

}   // namespace angiopose::ui
