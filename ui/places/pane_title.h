#pragma once

#include <QWidget>

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

}   // namespace angiopose::ui
