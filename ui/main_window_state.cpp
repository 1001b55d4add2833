// How MainWindow remembers its layout: place, widths, folded parts, views in windows of their own.
#include "ui/main_window.h"
#include "ui/places/view_frame.h"

#include <QDataStream>
#include <QIODevice>
#include <QScreen>
#include <QSplitter>

#include <algorithm>

namespace angiopose::ui {
namespace {

/// Names of the parts that are folded now.
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

/// A window that was left on a larger screen, or at a smaller scale, is whole on this one. At 200 % a screen has half
/// as many points as at 100 %.
void fitInto(const QRect& room, QWidget& window)
{
    if (window.isMaximized() || window.isFullScreen() || room.contains(window.geometry())) {
        return;
    }
    QRect place(window.pos(), window.size().boundedTo(room.size()));
    place.moveRight(std::min(place.right(), room.right()));
    place.moveBottom(std::min(place.bottom(), room.bottom()));
    place.moveLeft(std::max(place.left(), room.left()));
    place.moveTop(std::max(place.top(), room.top()));
    window.setGeometry(place);
}

}   // namespace

QByteArray MainWindow::layoutState() const
{
    QByteArray state;
    QDataStream stream(&state, QIODevice::WriteOnly);
    stream << saveGeometry() << (alone_ ? columnsBefore_ : columns_->saveState())
           << (alone_ ? leftBefore_ : leftSplitter_->saveState()) << foldedSections(*this);
    for (const ViewFrame* frame : {imageFrame_, cornerFrame_, slicesFrame_}) {
        stream << frame->windowPlace() << (frame->isOut() && frame != slicesFrame_);   // slices come with a scan
    }
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
    fitInto(screen()->availableGeometry(), *this);
    columns_->restoreState(columnState);
    leftSplitter_->restoreState(leftState);
    if (stream.status() != QDataStream::Ok) {
        return;   // written by a version that did not remember it
    }
    for (Section* section : findChildren<Section*>()) {
        if (section->isFoldable()) {
            section->setFolded(folded.contains(section->objectName()));
        }
    }
    for (ViewFrame* frame : {imageFrame_, cornerFrame_, slicesFrame_}) {
        QByteArray place;
        bool isOut = false;
        stream >> place >> isOut;   // a version that did not know them leaves both as they are
        frame->setWindowPlace(place);
        frame->setOut(isOut);
    }
}

}   // namespace angiopose::ui