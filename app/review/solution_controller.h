#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "core/imaging/image2d.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace angiopose::ui {
class SolutionStrip;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The solutions of the last run as a strip of small pictures: the pose itself first, then the others by their score,
/// each with how far it lies from the pose. Pictures are drawn on a worker.
class SolutionController : public QObject {
    Q_OBJECT
public:
    SolutionController(const CaseDocument& document, ui::SolutionStrip& strip, QObject* parent = nullptr);

    void showCurrent(std::size_t index);   ///< the one that is on screen now

signals:
    void solutionWanted(std::size_t index);   ///< 0: the pose itself
    void takeWanted(std::size_t index);

private:
    using Pictures = std::vector<core::ColorImage>;
    void followDocument();
    void draw(const std::vector<core::RigidTransform>& poses);
    void showPictures(const Pictures& pictures);

    const CaseDocument& document_;
    ui::SolutionStrip& strip_;
    std::vector<core::RigidTransform> shown_;   ///< poses in the strip
    Job<Pictures> pictures_;
};

}   // namespace angiopose::app