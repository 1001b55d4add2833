#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "core/vessel/tree_gaps.h"

#include <QObject>

#include <memory>
#include <vector>

namespace angiopose::app {

/// Determines the number of connected components of the tree and the best gaps to bridge, on a worker after each edit.
class TreeGapFinder : public QObject {
    Q_OBJECT
public:
    explicit TreeGapFinder(CaseDocument& document, QObject* parent = nullptr);

    int pieceCount() const { return report_.pieceCount; }
    const std::vector<core::TreeGap>& gaps() const { return report_.gaps; }
    bool isSearching() const { return job_.isRunning(); }

signals:
    void changed();

private:
    struct GapReport {
        int pieceCount = 0;
        std::vector<core::TreeGap> gaps;
    };
    void updateFromDocument();

    CaseDocument& document_;
    std::shared_ptr<const core::VesselTree> tree_;
    Job<GapReport> job_;
    GapReport report_;
};

}   // namespace angiopose::app
