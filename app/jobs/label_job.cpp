#include "app/jobs/label_job.h"

namespace angiopose::app {
namespace {

core::Result<LabelOverview> readOverview(const std::string& path, const io::ReadObserver& observe)
{
    auto read = io::readLabelOverview(path, observe);
    if (!read) {
        return read.error();
    }
    io::LabelOverview overview = std::move(read).value();
    const std::vector<int> vessels = io::vesselLabelsByName(overview.labels);
    return LabelOverview{std::move(overview.labels),
                         {vessels.begin(), vessels.end()},
                         std::make_shared<const core::VoxelMask>(std::move(overview.rows.rows)),
                         std::move(overview.rows.centersInPatient)};
}

}   // namespace

LabelJob::LabelJob(QObject* parent) : QObject(parent), job_(emitAsSignals<LabelOverview>(*this)) {}

void LabelJob::start(const std::string& path)
{
    job_.start([path](JobLink<double>& link) {
        return readOverview(path, [&link](double fraction) { return link.tell(fraction); });
    });
}

}   // namespace angiopose::app
