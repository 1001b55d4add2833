#pragma once

#include "app/jobs/job.h"
#include "io/label_list.h"

#include <QObject>

#include <memory>
#include <set>

namespace angiopose::app {

/// What there is to choose from in a label image.
struct LabelOverview {
    std::vector<io::ListedLabel> labels;
    std::set<int> vessels;   ///< by their names; empty where no name says so
    std::shared_ptr<const core::VoxelMask> rows;   ///< see core::LabelRows
    std::vector<Eigen::Vector3d> middlesInPatient;
};

/// Reads what labels there are off the GUI thread. A later start drops an earlier one, as does destruction.
class LabelJob : public QObject {
    Q_OBJECT
public:
    explicit LabelJob(QObject* parent = nullptr);

    void start(const std::string& path);
    void drop() { job_.drop(); }   ///< nothing comes any more
    bool isRunning() const { return job_.isRunning(); }

signals:
    void finished(const app::LabelOverview& overview);
    void failed(const core::Message& reason);

private:
    Job<LabelOverview> job_;
};

}   // namespace angiopose::app