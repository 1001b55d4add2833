#include "core/measuring/measure_slice.h"

#include "core/measuring/measure_image.h"
#include "core/messages/says.h"

namespace angiopose::core {

Result<Quantity> valueOf(const SliceMeasurement& measurement)
{
    const PlaneAxes axes = axesOf(measurement.plane);
    ImageMeasurement inPlane;
    inPlane.kind = measurement.kind;
    for (const Eigen::Vector3d& point : measurement.pointsInPatient) {
        inPlane.pixels.emplace_back(point.dot(axes.right), point.dot(axes.down));   // a pixel is a millimetre
    }
    ImageScale scale;
    scale.plane = MeasurementPlane::Typed;
    return valueOf(inPlane, scale);
}

Messages basisOf(const SliceMeasurement& measurement, const VolumeGeometry* scan)
{
    Messages basis;
    if (scan) {
        const Eigen::Vector3d& mm = scan->spacingMm;
        basis.push_back(
            says::measureBasisScan(Quantity{mm.x(), 3, "mm"}, Quantity{mm.y(), 3, "mm"}, Quantity{mm.z(), 3, "mm"}));
    } else {
        basis.push_back(says::measureBasisScanAway());
    }
    if (measurement.kind == MeasurementKind::Angle) {
        basis.push_back(says::measureBasisScanAngle());
    }
    return basis;
}

double sliceAtMm(const SliceMeasurement& measurement)
{
    return measurement.pointsInPatient.empty()
               ? 0.0
               : measurement.pointsInPatient.front().dot(axesOf(measurement.plane).normal);
}

Eigen::Vector3d middleOf(const SliceMeasurement& measurement)
{
    if (measurement.pointsInPatient.empty()) {
        return Eigen::Vector3d::Zero();
    }
    Eigen::Vector3d low = measurement.pointsInPatient.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& point : measurement.pointsInPatient) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return 0.5 * (low + high);
}

}   // namespace angiopose::core
