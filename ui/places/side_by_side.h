#pragma once

#include <QWidget>
#include <cstddef>
#include <vector>

class QGridLayout;
class QScrollBar;
class QSplitter;

namespace angiopose::ui {

class ElidedLabel;

/// Title above an image in the side-by-side layout: name of the view, and the relation of its pose to that of the
/// current view. A click selects the view.
class PaneTitle : public QWidget {
    Q_OBJECT
public:
    explicit PaneTitle(QWidget* parent = nullptr);

    /// Shows the title with `note` on the right; `tip` explains the note in full sentences.
    void showTexts(const QString& title, const QString& note, const QString& tip);
    void setShown(bool shown);   ///< marks the title as that of the current view: bold and not clickable
    QString title() const;
    QString note() const;

signals:
    void clicked();
    void menuRequested(const QPoint& globalPosition);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void showNote();

    ElidedLabel* title_;
    ElidedLabel* note_;
    bool isShown_ = false;
};

class AngiogramView;
class PaneTitle;

/// Pane with a view other than the current one: title, image with the vessels, and frame slider. Read-only; the user
/// selects a view to work on it.
class ViewPane : public QWidget {
    Q_OBJECT
public:
    explicit ViewPane(QWidget* parent = nullptr);

    AngiogramView& image() { return *image_; }
    PaneTitle& title() { return *title_; }
    void showFrame(int frame, int count);   ///< `frame` is an index from 0; the slider is hidden if `count` < 2

signals:
    void viewChosen();   ///< emitted on a click on the title or a double-click in the image
    void frameRequested(int frame);   ///< emitted with a frame that is always within the run
    void menuRequested(const QPoint& globalPosition);

private:
    void stepFrame(int step);

    PaneTitle* title_;
    AngiogramView* image_;
    QScrollBar* frames_;
};

class AngiogramView;
class PaneTitle;
class ViewPane;

/// The current image and panes for additional views: one pane beside it, or several in a grid at its right.
class SideBySide : public QWidget {
    Q_OBJECT
public:
    explicit SideBySide(AngiogramView& shown, QWidget* parent = nullptr);   ///< takes ownership of `shown`

    /// Sets the number of panes; 0 leaves only the current image, without title.
    void setPaneCount(std::size_t count);
    std::size_t paneCount() const { return count_; }
    ViewPane& pane(std::size_t index) { return *panes_[index]; }
    PaneTitle& title() { return *title_; }   ///< title of the current image
    AngiogramView& shown() { return *primaryImage_; }
    std::vector<AngiogramView*> images();   ///< the current image, followed by the images of the panes

signals:
    void paneCreated(ui::ViewPane* pane);   ///< emitted once per pane, since hidden panes are reused

private:
    void place();

    PaneTitle* title_;
    AngiogramView* primaryImage_;
    QWidget* paneArea_;
    QGridLayout* grid_;
    QSplitter* splitter_;
    std::vector<ViewPane*> panes_;   ///< panes, including hidden ones kept for reuse
    std::size_t count_ = 0;
};

}   // namespace angiopose::ui
