#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "core/vessel/tree_gaps.h"

#include <QObject>

#include <memory>
#include <vector>

namespace angiopose::app {

/// Finds, on a worker after each change, the number of connected components of the tree and the best gaps to bridge.
class RepairAdvice : public QObject {
    Q_OBJECT
public:
    explicit RepairAdvice(CaseDocument& document, QObject* parent = nullptr);

    int pieceCount() const { return found_.pieceCount; }
    const std::vector<core::TreeGap>& gaps() const { return found_.gaps; }
    bool isLooking() const { return job_.isRunning(); }

signals:
    void changed();

private:
    struct Found {
        int pieceCount = 0;
        std::vector<core::TreeGap> gaps;
    };
    void followDocument();

    CaseDocument& document_;
    std::shared_ptr<const core::VesselTree> tree_;
    Job<Found> job_;
    Found found_;
};

}   // namespace angiopose::app
