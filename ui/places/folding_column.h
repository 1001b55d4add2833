#pragma once

#include "ui/words/spoken.h"

#include <QAbstractButton>
#include <QByteArray>
#include <QWidget>
#include <optional>

class QSplitterHandle;

namespace angiopose::ui {

enum class ColumnSide { Left, Right };

/// Rail of a folded column: a narrow button with vertical text that names the hidden content.
class ColumnRail : public QAbstractButton {
    Q_OBJECT
public:
    ColumnRail(ColumnSide side, const Words& behind, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {sizeHint().width(), 80}; }
    static int wordsRoomPx(int height);   ///< length available for the text on a rail of this height

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ColumnSide side_;
};

/// Paints a chevron that points to `side`, centered at `at`, with the painter's pen.
void paintChevron(QPainter& painter, const QPointF& at, ColumnSide side);

/// Visible handle on a column's border: a chevron towards the side to which the column folds.
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

/// Column of the window that folds to a rail and remembers its width. The content stays alive while folded.
class FoldingColumn : public QWidget {
    Q_OBJECT
public:
    /// Takes ownership of the content. `behind` is its display name.
    FoldingColumn(ColumnSide side, QWidget& content, const Words& behind, QWidget* parent = nullptr);

    bool isFolded() const { return isFolded_; }
    void setFolded(bool folded);
    void holdOpen(bool hold);   ///< shows the content while true, even if folded

    int openWidth() const { return openWidth_; }   ///< current width, or the width before folding
    void setOpenWidth(int width) { openWidth_ = width; }

    /// Places the fold button in the middle of the column's border.
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

inline constexpr int columnBorderWidth = 9;   ///< includes the fold button

/// Widths and folding of the columns beside the image, and the share of the left column's height used by the 3-D view.
struct ColumnLayout {
    int leftWidth = 300;
    int rightWidth = 320;
    bool isLeftFolded = false;
    bool isRightFolded = false;
    double cornerShare = 0.42;

    bool operator==(const ColumnLayout&) const = default;
};

/// Activity of a step that determines the layout: tracing a scan, registering vessels, or reviewing a result.
enum class Work { Tracing, Registering, Reviewing };

/// Default columns for an activity in a window of this width.
ColumnLayout columnsFor(Work work, int windowWidth);

/// Window layout of one activity.
struct WorkLayout {
    ColumnLayout columns;
    bool areSlicesLarge = false;
    int cornerPlane = 0;   ///< 0: 3-D, then indices into `core::bodyPlanes`

    bool operator==(const WorkLayout&) const = default;
};

/// Serializes and restores a layout; returns none for invalid bytes.
QByteArray bytesOf(const WorkLayout& layout);
std::optional<WorkLayout> workLayoutOf(const QByteArray& bytes);

}   // namespace angiopose::ui
