#pragma once

#include "core/imaging/image2d.h"
#include "ui/controls/section.h"

#include <vector>

class QListWidget;

namespace angiopose::ui {

/// Texts of one candidate pose: a one-line summary, and details for the tooltip.
struct SolutionLine {
    QString words;
    QString toolTip;
};

/// Strip with the solutions of the last registration as thumbnails, best first; hidden if there is only one. Passive
/// view: displays the given state and emits signals for user actions.
class SolutionStrip : public Section {
    Q_OBJECT
public:
    explicit SolutionStrip(QWidget* parent = nullptr);

    void showSolutions(const std::vector<SolutionLine>& solutions);   ///< emits no signal; thumbnails follow
    void showThumbnail(int index, const core::ColorImage& picture);
    void showCurrent(int index);   ///< emits no signal
    int thumbnailWidthPx() const;   ///< thumbnail width in device pixels
    QListWidget* list() const { return list_; }

signals:
    void solutionPicked(int index);   ///< solution to display; 0 is the registered pose
    void acceptRequested(int index);

private:
    QListWidget* list_;
    bool isUpdating_ = false;
};

}   // namespace angiopose::ui
