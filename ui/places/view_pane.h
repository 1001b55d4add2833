#pragma once

#include <QWidget>

class QScrollBar;

namespace angiopose::ui {

class AngiogramView;
class PaneTitle;

/// A further view of the case: its name, its image with the vessels, its frames. To be looked at; to work on it is to
/// choose it.
class ViewPane : public QWidget {
    Q_OBJECT
public:
    explicit ViewPane(QWidget* parent = nullptr);

    AngiogramView& image() { return *image_; }
    PaneTitle& title() { return *title_; }
    void showFrame(int frame, int count);   ///< counted from 0; a count below 2 needs no bar

signals:
    void chosen();   ///< by a click on the name, or a double click in the image
    void frameRequested(int frame);   ///< not beyond the run
    void menuRequested(const QPoint& globalPosition);

private:
    void stepFrame(int step);

    PaneTitle* title_;
    AngiogramView* image_;
    QScrollBar* frames_;
};

}   // namespace angiopose::ui
