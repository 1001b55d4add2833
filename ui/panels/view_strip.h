#pragma once

#include "core/imaging/image2d.h"

#include <QWidget>

#include <vector>

class QLayout;
class QListWidget;
class QToolButton;

namespace angiopose::ui {

/// One view as displayed in the strip.
struct ViewRow {
    QString label;   ///< two lines: the gantry angles, and the agreement of the view
    QString toolTip;
};

/// Thumbnails of the views of a case, with the current view marked; hidden if there is only one. If the captions do not
/// fit beside the thumbnails, numbers replace them, and the captions appear in tooltips.
class ViewStrip : public QWidget {
    Q_OBJECT
public:
    explicit ViewStrip(QWidget* parent = nullptr);

    void showViews(const std::vector<ViewRow>& views, int shown);   ///< keeps thumbnails if their number is unchanged
    void showThumbnail(int index, const core::ColorImage& picture);
    int thumbnailWidthPx() const;   ///< width of a thumbnail, device px
    int count() const;
    void showSideBySide(bool on);   ///< sets the state of the side-by-side toggle
    void showCrosshair(bool on);   ///< sets the state of the linked crosshair toggle

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
    QLayout* makeSwitches();
    void fit();
    void fitSwitches(bool hasText);
    void fitItem(int index, int widthPx);
    int textWidthPx(int index) const;   ///< width of an item with thumbnail and full text

    std::vector<ViewRow> views_;
    QListWidget* list_;
    QToolButton* sideBySide_;
    QToolButton* crosshair_;
    bool isUpdating_ = false;
};

}   // namespace angiopose::ui
