#pragma once

#include "io/archive/model/query.h"
#include "io/archive/store/arrivals.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// The way to the objects of an archive, whatever language it speaks.
class SeriesSource {
public:
    virtual ~SeriesSource() = default;

    virtual core::Result<std::vector<std::string>> seriesOf(const std::string& studyUid) = 0;
    virtual core::Result<std::vector<ArchiveObject>> objectsOf(const std::string& studyUid,
                                                               const std::string& seriesUid) = 0;

    /// All objects of a series, into their places. What single objects lack is noted there.
    virtual core::Status fetch(const std::string& studyUid, const std::string& seriesUid,
                               const std::vector<ArchiveObject>& objects, Arrivals& arrivals) = 0;
};

}   // namespace angiopose::io
