// Saving and restoring the layout of MainWindow: geometry, widths, folded sections, popped-out views.
#include "ui/controls/screen_fit.h"
#include "ui/main_window.h"
#include "ui/places/folding_column.h"
#include "ui/places/view_frame.h"

#include <QDataStream>
#include <QIODevice>
#include <QScreen>
#include <QSplitter>

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

/// Returns the names of the folded sections.
QStringList foldedSections(const QWidget& window)
{
    QStringList names;
    for (const Section* section : window.findChildren<Section*>()) {
        if (section->isFoldable() && section->isFolded()) {
            names << section->objectName();
        }
    }
    return names;
}

/// Returns splitter sizes that give the lower widget `lowerShare` of the height.
QList<int> heightsOf(double lowerShare, int height)
{
    const int lower = static_cast<int>(std::lround(std::clamp(lowerShare, 0.05, 0.95) * height));
    return {height - lower, lower};
}

}   // namespace

ColumnLayout MainWindow::columns() const
{
    if (maximizedView_) {
        return layoutBefore_;
    }
    const QList<int> heights = leftSplitter_->sizes();
    const int height = heights[0] + heights[1];
    return {leftColumn_->openWidth(), rightColumn_->openWidth(), leftColumn_->isFolded(), rightColumn_->isFolded(),
            height > 0 ? static_cast<double>(heights[1]) / height : ColumnLayout{}.cornerFraction};
}

void MainWindow::setColumns(const ColumnLayout& layout)
{
    leftColumn_->setOpenWidth(layout.leftWidth);   // set before unfolding, so that the column is laid out only once
    rightColumn_->setOpenWidth(layout.rightWidth);
    leftColumn_->setFolded(layout.isLeftFolded);
    rightColumn_->setFolded(layout.isRightFolded);
    const int left = layout.isLeftFolded ? leftColumn_->minimumWidth() : layout.leftWidth;
    const int right = layout.isRightFolded ? rightColumn_->minimumWidth() : layout.rightWidth;
    columns_->setSizes({left, std::max(1, width() - left - right - 2 * columnBorderWidth), right});
    leftSplitter_->setSizes(heightsOf(layout.cornerFraction, std::max(leftSplitter_->height(), 720)));
}

QByteArray MainWindow::layoutState() const
{
    QByteArray state;
    QDataStream stream(&state, QIODevice::WriteOnly);
    stream << saveGeometry() << (maximizedView_ ? savedColumns_ : columns_->saveState())
           << (maximizedView_ ? savedLeft_ : leftSplitter_->saveState()) << foldedSections(*this);
    for (const ViewFrame* frame : {imageFrame_, cornerFrame_, slicesFrame_}) {
        stream << frame->savedGeometry() << (frame->isPoppedOut() && frame != slicesFrame_);   // slices require a scan
    }
    const ColumnLayout columnLayout = columns();
    stream << columnLayout.isLeftFolded << columnLayout.isRightFolded << columnLayout.leftWidth
           << columnLayout.rightWidth;
    return state;
}

void MainWindow::restoreLayout(const QByteArray& state)
{
    QDataStream stream(state);
    QByteArray windowGeometry;
    QByteArray columnState;
    QByteArray leftState;
    QStringList folded;
    stream >> windowGeometry >> columnState >> leftState >> folded;
    restoreGeometry(windowGeometry);
    fitToScreen(screen()->availableGeometry(), *this);
    columns_->restoreState(columnState);
    columns_->setHandleWidth(columnBorderWidth);   // overrides the handle width saved by older versions
    columns_->setChildrenCollapsible(false);
    leftSplitter_->restoreState(leftState);
    if (stream.status() != QDataStream::Ok) {
        return;   // older versions did not save folded sections
    }
    for (Section* section : findChildren<Section*>()) {
        if (section->isFoldable()) {
            section->setFolded(folded.contains(section->objectName()));
        }
    }
    for (ViewFrame* frame : {imageFrame_, cornerFrame_, slicesFrame_}) {
        QByteArray place;
        bool isPoppedOut = false;
        stream >> place >> isPoppedOut;   // not saved by older versions, so the defaults remain
        frame->setSavedGeometry(place);
        frame->setPoppedOut(isPoppedOut);
    }
    restoreFolding(stream);
}

/// Restores which columns are folded; layouts saved by older versions leave all columns unfolded.
void MainWindow::restoreFolding(QDataStream& stream)
{
    ColumnLayout stored = columns();
    stream >> stored.isLeftFolded >> stored.isRightFolded >> stored.leftWidth >> stored.rightWidth;
    if (stream.status() == QDataStream::Ok) {
        setColumns(stored);
    }
}

}   // namespace angiopose::ui
