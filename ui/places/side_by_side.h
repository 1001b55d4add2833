#pragma once

#include <QWidget>
#include <cstddef>
#include <vector>

class QGridLayout;
class QScrollBar;
class QSplitter;

namespace angiopose::ui {

class ElidedLabel;

/// What stands over an image among several: which view of the case it is, and how its pose goes with the others'. A
/// click chooses the view.
class PaneTitle : public QWidget {
    Q_OBJECT
public:
    explicit PaneTitle(QWidget* parent = nullptr);

    /// `note` stands on the right, `tip` says it in whole sentences.
    void showWords(const QString& title, const QString& note, const QString& tip);
    void setShown(bool shown);   ///< it is the shown view's: not to be chosen, its name stronger
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

class AngiogramView;
class PaneTitle;
class ViewPane;

/// The shown image, and panes for further views: one beside it, more in a grid on its right.
class SideBySide : public QWidget {
    Q_OBJECT
public:
    explicit SideBySide(AngiogramView& shown, QWidget* parent = nullptr);   ///< owns it

    /// 0: the shown image alone, without its name.
    void setPaneCount(std::size_t count);
    std::size_t paneCount() const { return count_; }
    ViewPane& pane(std::size_t index) { return *panes_[index]; }
    PaneTitle& title() { return *title_; }   ///< of the shown image
    AngiogramView& shown() { return *shown_; }
    std::vector<AngiogramView*> images();   ///< the shown one first, then those of the panes

signals:
    void paneMade(ui::ViewPane* pane);   ///< once for each: what goes is kept for later

private:
    void place();

    PaneTitle* title_;
    AngiogramView* shown_;
    QWidget* others_;
    QGridLayout* grid_;
    QSplitter* halves_;
    std::vector<ViewPane*> panes_;   ///< as many as there ever were
    std::size_t count_ = 0;
};

}   // namespace angiopose::ui
