#include "core/evaluation/protocols/phantoms.h"
#include "core/evaluation/protocols/protocol_rows.h"
#include "core/simulation/simulated_case.h"

#include "core/geometry/angle_units.h"

#include <array>

namespace angiopose::core {
namespace {

constexpr double tiltDeg = 30.0;
constexpr double shiftMm = 1.0;
const Eigen::Vector3d middle(7.5, 0.0, 12.5);

/// `Literal`: the square as printed, coplanar with the source; `Tilted`: tilted out of that plane (variants T-A and T-B
/// of ALGORITHMS §4.1).
enum class SquareView { Literal, Tilted };

struct ToySetting {
    Condition condition;
    int segmentsPerEdge = 0;
    double rotationDeg = 0.0;   ///< rotation of the initial pose about the source
    SquareView view = SquareView::Tilted;
};

/// Adds one setting for each number of points.
void addToySettings(const std::string& variant, const std::string& disturbance, const ToySetting& base,
                    std::vector<ToySetting>& rows)
{
    for (const int segments : {2, 11, 21, 31, 41}) {
        const std::string points = std::to_string(4 * segments);
        ToySetting row = base;
        row.condition = {variant + "-" + points, points + " points, " + disturbance, true};
        row.segmentsPerEdge = segments;
        rows.push_back(std::move(row));
    }
}

std::vector<ToySetting> makeToySettings()
{
    std::vector<ToySetting> rows;
    addToySettings("b1", "shift 1", {}, rows);
    addToySettings("b2", "shift 1 and 1°", {{}, 0, 1.0, SquareView::Tilted}, rows);
    addToySettings("a", "as printed, shift 1", {{}, 0, 0.0, SquareView::Literal}, rows);
    return rows;
}

const std::vector<ToySetting>& toySettings()
{
    static const std::vector<ToySetting> rows = makeToySettings();
    return rows;
}

/// Returns the published square: four edges of length 5 in the plane y = 0. Neighboring edges share a corner.
VesselTree makeSquare(int segmentsPerEdge)
{
    const std::array<Eigen::Vector3d, 4> corners{Eigen::Vector3d(5, 0, 10), {10, 0, 10}, {10, 0, 15}, {5, 0, 15}};
    VesselTree square;
    for (std::size_t edge = 0; edge < corners.size(); ++edge) {
        VesselBranch branch{static_cast<int>(edge), "", {}, {}};
        for (int k = 0; k <= segmentsPerEdge; ++k) {
            const double share = static_cast<double>(k) / segmentsPerEdge;
            branch.pointsInPatient.emplace_back((1.0 - share) * corners[edge] + share * corners[(edge + 1) % 4]);
        }
        square.branches.push_back(std::move(branch));
    }
    return square;
}

RigidTransform poseOf(SquareView view)
{
    if (view == SquareView::Literal) {
        return {};
    }
    const Eigen::Matrix3d tilt = expSo3(Eigen::Vector3d(tiltDeg * radiansPerDegree, 0.0, 0.0));
    return {tilt, Eigen::Vector3d(0.0, 0.0, middle.z()) - tilt * middle};
}

Phantom makeToy(const ToySetting& setting)
{
    Phantom toy;
    toy.tree = makeSquare(setting.segmentsPerEdge);
    toy.camera = {520.0, 520.0, 512.0, 512.0, 1024, 1024};
    toy.trueCameraFromPatient = poseOf(setting.view);
    toy.exactTarget = projectTree(toy.tree, toy.camera, toy.trueCameraFromPatient);
    toy.target = toy.exactTarget;   // not resampled: the experiment varies the number of points
    return toy;
}

TrialMaker prepareToy(std::size_t condition, std::uint64_t seed)
{
    const ToySetting& setting = toySettings()[condition];
    const auto toy = std::make_shared<const SharedPhantom>(makeToy(setting));
    return [toy, rotationDeg = setting.rotationDeg, seed](std::uint64_t number) {
        CounterRandom random = trialRandom(toyNumber, seed, number);
        const Eigen::Vector3d shift = randomDirection(shiftMm, random);
        const RigidTransform disturbance{expSo3(randomDirection(rotationDeg * radiansPerDegree, random)), shift};
        Trial trial = toy->makeExactTrial();
        trial.input.initialCameraFromPatient = disturbance * trial.trueCameraFromPatient;
        return trial;
    };
}

}   // namespace

Protocol toyProtocol()
{
    return {"toy",
            "A square of equally spaced points, tilted and as printed, shifted by 1 in a random direction (ALGORITHMS "
            "4.1).",
            100,
            1,
            SuccessCriterion::ProjectionWithin1Px,
            conditionsOf(toySettings()),
            prepareToy};
}

}   // namespace angiopose::core
