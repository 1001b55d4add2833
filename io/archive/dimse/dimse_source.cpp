#include "io/archive/dimse/dimse_source.h"

#include "io/archive/dimse/find.h"
#include "io/archive/dimse/get_series.h"

#include <utility>

namespace angiopose::io {
namespace {

class DimseSource : public SeriesSource {
public:
    DimseSource(ArchiveNode node, StopQuestion isStopWished)
        : node_(std::move(node)), isStopWished_(std::move(isStopWished))
    {
    }

    core::Result<std::vector<std::string>> seriesOf(const std::string& studyUid) override
    {
        auto opened = openForFinding(node_, isStopWished_);
        if (!opened) {
            return opened.error();
        }
        DimseLink link = std::move(opened).value();
        auto found = findSeries(link, node_, studyUid);
        return released(std::move(link), std::move(found));
    }

    core::Result<std::vector<ArchiveObject>> objectsOf(const std::string& studyUid,
                                                       const std::string& seriesUid) override
    {
        auto opened = openForFinding(node_, isStopWished_);
        if (!opened) {
            return opened.error();
        }
        DimseLink link = std::move(opened).value();
        auto found = findObjects(link, node_, studyUid, seriesUid);
        return released(std::move(link), std::move(found));
    }

    core::Status fetch(const std::string& studyUid, const std::string& seriesUid,
                       const std::vector<ArchiveObject>& objects, Arrivals& arrivals) override
    {
        const SeriesWish wish{studyUid, seriesUid, objects};
        auto got = getSeries(node_, wish, arrivals);
        if (!got) {
            return got.error();
        }
        return got.value() ? core::Status(core::Done{}) : moveSeries(node_, wish, arrivals);
    }

private:
    template <class Found>
    static Found released(DimseLink link, Found found)
    {
        if (found) {
            link.release();
        }
        return found;
    }

    ArchiveNode node_;
    StopQuestion isStopWished_;
};

}   // namespace

std::unique_ptr<SeriesSource> makeDimseSource(const ArchiveNode& node, const StopQuestion& isStopWished)
{
    return std::make_unique<DimseSource>(node, isStopWished);
}

}   // namespace angiopose::io
