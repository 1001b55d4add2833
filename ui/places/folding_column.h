#pragma once

#include "ui/words/retranslation.h"

#include <QAbstractButton>
#include <QByteArray>
#include <QWidget>
#include <optional>

class QSplitterHandle;

namespace angiopose::ui {

enum class ColumnSide { Left, Right };

/// Rail shown in place of a folded column: a narrow button with vertical text that names the hidden content.
class ColumnRail : public QAbstractButton {
    Q_OBJECT
public:
    ColumnRail(ColumnSide side, const LocalizedText& contentName, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {sizeHint().width(), 80}; }
    static int maxTextLengthPx(int height);   ///< maximum length of text on a rail of this height

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ColumnSide side_;
};

/// Paints a chevron that points to `side` and is centered at `at`, with the current pen of the painter.
void paintChevron(QPainter& painter, const QPointF& at, ColumnSide side);

/// Button on the border of a column with a chevron that points to the side toward which the column folds.
class FoldButton : public QAbstractButton {
    Q_OBJECT
public:
    FoldButton(ColumnSide side, const LocalizedText& folds, QWidget* parent = nullptr);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ColumnSide side_;
};

/// Window column that folds into a rail and remembers its width. Folding hides the content but does not destroy it.
class FoldingColumn : public QWidget {
    Q_OBJECT
public:
    /// Takes ownership of `content`, which users see named `contentName`.
    FoldingColumn(ColumnSide side, QWidget& content, const LocalizedText& contentName, QWidget* parent = nullptr);

    bool isFolded() const { return isFolded_; }
    void setFolded(bool folded);
    void setHeldOpen(bool isHeld);   ///< if true, shows the content even if the column is folded

    int openWidth() const { return openWidth_; }   ///< current width, or the width before folding
    void setOpenWidth(int width) { openWidth_ = width; }

    /// Places the fold button in the middle of the splitter handle.
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

inline constexpr int columnBorderWidth = 9;   ///< leaves room for the fold button

/// Widths and folding of the columns beside the image, and the fraction of the left column's height for the 3-D view.
struct ColumnLayout {
    int leftWidth = 300;
    int rightWidth = 320;
    bool isLeftFolded = false;
    bool isRightFolded = false;
    double cornerFraction = 0.42;

    bool operator==(const ColumnLayout&) const = default;
};

/// User activity that determines the layout: tracing a scan, registering vessels, or reviewing a result.
enum class Activity { Tracing, Registering, Reviewing };

/// Returns the default columns for an activity in a window of this width.
ColumnLayout defaultColumns(Activity work, int windowWidth);

/// Window layout saved for one activity.
struct ActivityLayout {
    ColumnLayout columns;
    bool areSlicesEnlarged = false;
    int cornerPlane = 0;   ///< 0 for the 3-D view, otherwise 1 + index into `core::bodyPlanes`

    bool operator==(const ActivityLayout&) const = default;
};

/// Serialize and restore a layout; `activityLayoutFromBytes` returns nullopt for invalid bytes.
QByteArray toBytes(const ActivityLayout& layout);
std::optional<ActivityLayout> activityLayoutFromBytes(const QByteArray& bytes);

}   // namespace angiopose::ui
