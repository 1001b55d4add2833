#pragma once

#include <QWidget>

class QScrollBar;

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

}   // namespace angiopose::ui
