// How MainWindow remembers its layout: place, widths, folded parts, views in windows of their own.
#include "ui/main_window.h"
#include "ui/places/view_frame.h"

#include <QDataStream>
#include <QIODevice>
#include <QSplitter>

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