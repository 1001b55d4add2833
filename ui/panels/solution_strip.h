#pragma once

#include "core/imaging/image2d.h"
#include "ui/controls/section.h"

#include <vector>

class QListWidget;

namespace angiopose::ui {

/// One pose that explains the image: what to say of it in a line, and more.
struct SolutionLine {
    QString words;
    QString toolTip;
};

/// The solutions of the last run as small pictures, the best first. Hidden where there is only one. Shows what it is
/// told, reports what the user wants.
class SolutionStrip : public Section {
    Q_OBJECT
public:
    explicit SolutionStrip(QWidget* parent = nullptr);

    void showSolutions(const std::vector<SolutionLine>& solutions);   ///< silent; pictures follow
    void showPicture(int index, const core::ColorImage& picture);
    void showCurrent(int index);   ///< silent
    int pictureWidthPx() const;   ///< in screen px
    QListWidget* list() const { return list_; }

signals:
    void wasPicked(int index);   ///< to be looked at; 0 is the pose itself
    void takeRequested(int index);

private:
    QListWidget* list_;
    bool showing_ = false;
};

}   // namespace angiopose::ui