#include "core/simulation/study/simulated_room.h"

#include "core/simulation/grow_tree.h"
#include "core/simulation/simulate_view_of.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

enum RoomStream : std::uint64_t { RoomTree = 1, RoomGeometry, RoomViews };

constexpr double isocenterMm = 750.0;
constexpr double maxOffsetMm = 100.0;   ///< maximum distance of the vessels from the isocenter, along the beam
constexpr double centeringMm = 8.0;   ///< 1-σ perpendicular to the beam
constexpr double objectPlaneMm = 40.0;   ///< standard deviation of the assumed object plane, relative to the vessels
constexpr double steepBeamDeg = 60.0;   ///< beam angle above which the device assumes the object to be at the isocenter
constexpr double tableErrorStdMm =
    40.0;   ///< standard deviation of the table position in the header if the table moved

double roundedToStep(double value, double step)
{
    return std::round(value / step) * step;
}

Eigen::Vector3d randomOffset(double std, CounterRandom& random)
{
    const double x = std * random.normal(), y = std * random.normal(), z = std * random.normal();
    return {x, y, z};
}

CArm drawRoomCArm(std::size_t view, double extentMm, const DsaOptions& dsa, CounterRandom& random)
{
    const auto reported = [](double value) { return SourcedValue<double>{value, Origin::Header, ""}; };
    const double primary = view == 0 ? random.uniform(-40.0, 0.0) : random.uniform(30.0, 90.0);
    const double sid = roundedToStep(random.uniform(1000.0, 1200.0), 1.0);
    const double fieldMm = random.uniform(1.15, 1.3) * extentMm * sid / (isocenterMm - maxOffsetMm);
    CArm arm;
    arm.sourceToDetectorMm = reported(sid);
    arm.sourceToIsocenterMm = reported(isocenterMm);
    arm.columnSpacingMm = arm.rowSpacingMm = reported(roundedToStep(fieldMm / std::min(dsa.width, dsa.height), 0.001));
    arm.primaryAngleDeg = reported(roundedToStep(primary, 0.1));
    arm.secondaryAngleDeg = reported(roundedToStep(random.uniform(-30.0, 30.0), 0.1));
    return arm;
}

/// Simulates one view with its true geometry and the geometry in its header.
SimulatedCase simulateRoomView(std::uint64_t seed, std::size_t view, const GrownTree& grown, const RoomOptions& room,
                               double extentMm, const DsaOptions& dsa)
{
    CounterRandom random = CounterRandom(seed).fork(RoomGeometry).fork(view);
    const Eigen::Vector3d centroid = centroidInPatient(grown.tree);
    TrueViewGeometry geometry;
    CArm& header = geometry.header = drawRoomCArm(view, extentMm, dsa, random);
    CArm truth = header;
    *truth.primaryAngleDeg.value += room.angleErrorDeg * random.normal();
    *truth.secondaryAngleDeg.value += room.angleErrorDeg * random.normal();
    const Eigen::Vector3d beam = detectorDirection(*truth.primaryAngleDeg.value, *truth.secondaryAngleDeg.value);
    const double offMm = random.uniform(-maxOffsetMm, maxOffsetMm);
    const Eigen::Vector3d aside = randomOffset(centeringMm, random);
    const Eigen::Vector3d byTable = centroid + offMm * beam + aside - beam * beam.dot(aside);
    const Eigen::Vector3d moved = randomOffset(view > 0 ? room.breathingMm : 0.0, random);
    const double planeMm = isocenterMm - offMm + objectPlaneMm * random.normal();
    const Eigen::Vector3d stray = randomOffset(tableErrorStdMm, random);
    const bool isSteep = std::abs(beam.y()) < std::cos(steepBeamDeg * 3.14159265358979323846 / 180.0);
    header.sourceToObjectMm = {isSteep ? isocenterMm : roundedToStep(planeMm, 1.0), Origin::Header, ""};
    const bool isMirrored = view > 0 && room.isMirrored;
    header.mirrored = {isMirrored, Origin::Header, ""};
    truth.mirrored = header.mirrored;
    geometry.camera = cameraFromCArm(header, dsa.width, dsa.height).value();
    geometry.trueCameraFromPatient = cameraFromPatient(truth, byTable + moved).value();
    CArm start = header;
    start.sourceToIsocenterMm = header.sourceToObjectMm;
    geometry.initialCameraFromPatient = cameraFromPatient(start, centroid).value();
    if (room.header == RoomHeader::ObjectPlane) {
        header.sourceToIsocenterMm = {};
        assumeIsocenter(header);
    }
    SimulatedCase simulated = simulateViewOf(grown, geometry, CounterRandom(seed).fork(RoomViews).fork(view)(), dsa);
    Angiogram& angiogram = simulated.angiogram;
    angiogram.identity.patientId = "ROOM-" + std::to_string(seed);
    angiogram.identity.description = "Simulated room, seed " + std::to_string(seed);
    angiogram.identity.studyUid = "1.2.826.0.1.3680043.10.1523." + std::to_string(seed);
    GantryHeader& gantry = angiogram.gantry;
    gantry.patientPosition = PatientPosition::HFS;
    gantry.tableMoves = view > 0 && room.tableMoves;
    if (room.header == RoomHeader::Siemens || room.header == RoomHeader::Standard) {
        const bool isStandard = room.header == RoomHeader::Standard;
        gantry.table = TablePosition{gantry.tableMoves ? Eigen::Vector3d(byTable + stray) : byTable,
                                     isStandard ? TablePosition::Tags::Standard : TablePosition::Tags::Siemens};
    }
    return simulated;
}

}   // namespace

std::vector<SimulatedCase> simulateRoom(std::uint64_t seed, const RoomOptions& room, const TreeOptions& tree,
                                        const DsaOptions& dsa)
{
    const GrownTree grown = growTree(CounterRandom(seed).fork(RoomTree)(), tree);
    std::vector<SimulatedCase> views;
    for (std::size_t view = 0; view < 2; ++view) {
        views.push_back(simulateRoomView(seed, view, grown, room, tree.extentMm, dsa));
    }
    return views;
}

}   // namespace angiopose::core
