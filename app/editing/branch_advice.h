#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "core/registration/judging/branch_information.h"

#include <QObject>

#include <array>
#include <optional>
#include <vector>

namespace angiopose::app {

/// What the branches of the tree tell about the pose of the shown view.
struct BranchAdvice {
    core::Vector6d stdOfAll = core::Vector6d::Zero();   ///< of the steps of a pose, degrees and mm, from all branches
    core::Vector6d stdOfChosen = core::Vector6d::Zero();   ///< from the auxiliary ones; none chosen: from all
    std::array<std::vector<int>, 6> pinnedBy;   ///< branches that tell most about each step
    std::vector<int> suggested;   ///< few that tell nearly as much as all
};

/// Finds on a worker what the branches tell; while one answer is on its way, only the newest question waits.
class BranchAdviser : public QObject {
    Q_OBJECT
public:
    explicit BranchAdviser(const CaseDocument& document, QObject* parent = nullptr);

    void ask();   ///< about the case as it is
    bool isRunning() const { return job_.isRunning(); }
    const std::optional<BranchAdvice>& advice() const { return advice_; }   ///< nothing: not known

signals:
    void answered();

private:
    void start();
    void take(const BranchAdvice& advice);

    const CaseDocument& document_;
    Job<BranchAdvice> job_;
    std::optional<BranchAdvice> advice_;
    bool isAskedAgain_ = false;   ///< when the running one is done
};

}   // namespace angiopose::app
