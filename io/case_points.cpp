#include "io/case_points.h"

namespace angiopose::io {

std::vector<Fiducial> caseFiducials(const core::Case& session)
{
    std::vector<Fiducial> points;
    for (const core::VesselMark& mark : session.vessels.marks) {
        const bool isRing = mark.kind == core::VesselMarkKind::OstiumRing;
        points.push_back({mark.pointInPatient, mark.name, isRing ? "ostium ring" : "target point"});
    }
    for (const core::Landmark& landmark : session.shown().landmarks) {
        points.push_back({landmark.pointInPatient, landmark.name, "landmark"});
    }
    return points;
}

}   // namespace angiopose::io
