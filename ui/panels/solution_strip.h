#pragma once

#include "core/imaging/image2d.h"
#include "ui/controls/section.h"

#include <vector>

class QListWidget;

namespace angiopose::ui {

/// One candidate pose as displayed: a one-line summary, and details for the tooltip.
struct SolutionRow {
    QString label;
    QString toolTip;
};

/// Strip with the solutions of the last registration as thumbnails, best first; hidden if there is only one. Passive
/// view: displays the given state and emits signals for user actions.
class SolutionStrip : public Section {
    Q_OBJECT
public:
    explicit SolutionStrip(QWidget* parent = nullptr);

    void showSolutions(const std::vector<SolutionRow>& solutions);   ///< emits no signal; thumbnails follow
    void showThumbnail(int index, const core::ColorImage& picture);
    void showCurrent(int index);   ///< emits no signal
    int thumbnailWidthPx() const;   ///< width of a thumbnail, device px
    QListWidget* list() const { return list_; }

signals:
    void solutionPicked(int index);   ///< emitted with the solution to display; 0 is the registered pose
    void acceptRequested(int index);

private:
    QListWidget* list_;
    bool isUpdating_ = false;
};

}   // namespace angiopose::ui
