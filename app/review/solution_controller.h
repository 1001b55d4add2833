#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "core/imaging/image2d.h"

#include <QObject>

#include <vector>

namespace angiopose::ui {
class SolutionStrip;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Shows the solutions of the last registration as a strip of thumbnails: first the pose itself, then the alternatives
/// by score, each with its distance from the pose. A worker thread renders the thumbnails.
class SolutionController : public QObject {
    Q_OBJECT
public:
    SolutionController(const CaseDocument& document, ui::SolutionStrip& strip, QObject* parent = nullptr);

    void showCurrent(std::size_t index);   ///< highlights the solution currently shown

signals:
    void solutionSelected(std::size_t index);   ///< emitted when the user selects a solution; 0 is the pose itself
    void acceptRequested(std::size_t index);

private:
    using Thumbnails = std::vector<core::ColorImage>;
    void updateFromDocument();
    void draw(const std::vector<core::RigidTransform>& poses);
    void showThumbnails(const Thumbnails& pictures);

    const CaseDocument& document_;
    ui::SolutionStrip& strip_;
    std::vector<core::RigidTransform> shownPoses_;   ///< poses shown in the strip
    Job<Thumbnails> drawingJob_;
};

}   // namespace angiopose::app
