#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/store/store_writer.h"

namespace angiopose::io {

struct SeriesRequest {
    std::string studyUid;
    std::string seriesUid;
    const std::vector<ArchiveObject>& objects;
};

/// Retrieves a series by C-GET, which delivers the objects on the same association. Returns nullopt if the archive does
/// not support C-GET.
core::Result<std::optional<core::Done>> getSeries(const ArchiveNode& node, const SeriesRequest& request,
                                                  StoreWriter& storeWriter);

/// Retrieves a series by C-MOVE, for which the archive opens associations to our receiving port to deliver the objects.
core::Status moveSeries(const ArchiveNode& node, const SeriesRequest& request, StoreWriter& storeWriter);

}   // namespace angiopose::io
