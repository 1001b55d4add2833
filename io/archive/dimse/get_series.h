#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/arrivals.h"

namespace angiopose::io {

struct SeriesRequest {
    std::string studyUid;
    std::string seriesUid;
    const std::vector<ArchiveObject>& objects;
};

/// C-GET: the objects come on the association on which they are asked for. Nothing where the archive does not offer it.
core::Result<std::optional<core::Done>> getSeries(const ArchiveNode& node, const SeriesRequest& request,
                                                  Arrivals& arrivals);

/// C-MOVE: they come on associations that the archive opens to our port.
core::Status moveSeries(const ArchiveNode& node, const SeriesRequest& request, Arrivals& arrivals);

}   // namespace angiopose::io
