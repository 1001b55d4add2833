#pragma once

#include "core/imaging/image2d.h"

#include <QWidget>

#include <vector>

class QLayout;
class QListWidget;
class QToolButton;

namespace angiopose::ui {

/// One view in the strip.
struct ViewLine {
    QString words;   ///< angles; below them how the view agrees
    QString toolTip;
};

/// The views of the case as small pictures, the shown one marked; hidden while there is only one. Where there is no
/// room for words beside the pictures, numbers stand there and the tips say the words.
class ViewStrip : public QWidget {
    Q_OBJECT
public:
    explicit ViewStrip(QWidget* parent = nullptr);

    void showViews(const std::vector<ViewLine>& views, int shown);   ///< keeps pictures while their number stays
    void showPicture(int index, const core::ColorImage& picture);
    int pictureWidthPx() const;   ///< in device pixels
    int count() const;
    void showSideBySide(bool on);   ///< that the views stand side by side,
    void showCrosshair(bool on);   ///< and that a cross-hair links them then

signals:
    void viewPicked(int index);
    void addRequested();
    void sideBySideRequested(bool on);
    void crosshairRequested(bool on);
    void removeRequested(int index);
    void menuRequested(int index, const QPoint& globalPosition);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void setUpList();
    QLayout* placedSwitches();
    void fit();
    void fitSwitches(bool hasWords);
    void fitItem(int index, int widthPx);
    int wordsWidthPx(int index) const;   ///< of a picture with its words

    std::vector<ViewLine> views_;
    QListWidget* list_;
    QToolButton* sideBySide_;
    QToolButton* crosshair_;
    bool showing_ = false;
};

}   // namespace angiopose::ui