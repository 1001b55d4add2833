#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "core/registration/judging/branch_information.h"

#include <QObject>

#include <array>
#include <optional>
#include <vector>

namespace angiopose::app {

/// How strongly the branches of the tree constrain the pose of the shown view.
struct BranchAdvice {
    core::Vector6d stdAllBranches =
        core::Vector6d::Zero();   ///< standard deviations of the pose components from all branches, degrees and mm
    core::Vector6d stdAuxiliary =
        core::Vector6d::Zero();   ///< the same from the auxiliary branches; if there are none, from all branches
    std::array<std::vector<int>, 6> constrainedBy;   ///< branches that constrain each component best
    std::vector<int> suggestedIds;   ///< a few branches that together are nearly as informative as the whole tree
};

/// Computes the advice on a worker thread. Requests made meanwhile are merged into one that starts afterwards.
class BranchAdviser : public QObject {
    Q_OBJECT
public:
    explicit BranchAdviser(const CaseDocument& document, QObject* parent = nullptr);

    void requestAdvice();   ///< requests the advice for the current case
    bool isRunning() const { return job_.isRunning(); }
    const std::optional<BranchAdvice>& advice() const { return advice_; }   ///< nullopt until known

signals:
    void adviceReady();

private:
    void start();
    void setAdvice(const BranchAdvice& advice);

    const CaseDocument& document_;
    Job<BranchAdvice> job_;
    std::optional<BranchAdvice> advice_;
    bool isRestartPending_ = false;   ///< true if the job must start again when the current one has finished
};

}   // namespace angiopose::app
