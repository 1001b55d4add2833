#pragma once

#include "app/jobs/job.h"
#include "io/label_list.h"

#include <QObject>

#include <memory>
#include <set>

namespace angiopose::app {

/// Labels of a label image, from which the user can select.
struct LabelOverview {
    std::vector<io::LabelInfo> labels;
    std::set<int> vessels;   ///< labels whose names denote vessels; empty if there are none
    std::shared_ptr<const core::VoxelMask> rows;   ///< see core::CompactLabels
    std::vector<Eigen::Vector3d> centersInPatient;
};

/// Lists the labels of a label image off the GUI thread. A new start or the destructor abandons the previous request.
class LabelJob : public QObject {
    Q_OBJECT
public:
    explicit LabelJob(QObject* parent = nullptr);

    void start(const std::string& path);
    void drop() { job_.drop(); }   ///< abandons the request without further signals
    bool isRunning() const { return job_.isRunning(); }

signals:
    void finished(const app::LabelOverview& overview);
    void failed(const core::Message& reason);

private:
    Job<LabelOverview> job_;
};

}   // namespace angiopose::app
