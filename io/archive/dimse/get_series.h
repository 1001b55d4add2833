#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/arrivals.h"

namespace angiopose::io {

struct SeriesRequest {
    std::string studyUid;
    std::string seriesUid;
    const std::vector<ArchiveObject>& objects;
};

/// Retrieves a series by C-GET, with the objects on the same association. Returns nothing if the archive does not offer
/// C-GET.
core::Result<std::optional<core::Done>> getSeries(const ArchiveNode& node, const SeriesRequest& request,
                                                  Arrivals& arrivals);

/// Retrieves a series by C-MOVE, with the objects on associations that the archive opens to our receiving port.
core::Status moveSeries(const ArchiveNode& node, const SeriesRequest& request, Arrivals& arrivals);

}   // namespace angiopose::io
