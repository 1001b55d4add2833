#pragma once

#include "core/imaging/image2d.h"
#include "ui/controls/section.h"

#include <vector>

class QListWidget;

namespace angiopose::ui {

/// One candidate pose that explains the image: one-line summary and details.
struct SolutionLine {
    QString words;
    QString toolTip;
};

/// Solutions of the last registration as thumbnails, best first. Hidden if there is only one. Displays the values it is
/// given and emits signals for user actions.
class SolutionStrip : public Section {
    Q_OBJECT
public:
    explicit SolutionStrip(QWidget* parent = nullptr);

    void showSolutions(const std::vector<SolutionLine>& solutions);   ///< emits no signal; thumbnails follow
    void showPicture(int index, const core::ColorImage& picture);
    void showCurrent(int index);   ///< emits no signal
    int pictureWidthPx() const;   ///< in device px
    QListWidget* list() const { return list_; }

signals:
    void wasPicked(int index);   ///< solution to display; 0 is the pose itself
    void takeRequested(int index);

private:
    QListWidget* list_;
    bool showing_ = false;
};

}   // namespace angiopose::ui