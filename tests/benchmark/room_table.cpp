// Prints the success of joint registration on simulated two-view studies of rooms whose table moves between the views
// and whose (0018,1111) refers to the plane of an assumed object: headers are written as DICOM and read again, vessels
// are traced, initial poses come from the headers. Right: both views together are reliable, and the joint pose lies
// within 2 mm of the truth, in 3-D, in the mean over the tree.

#include "core/case/initial_pose.h"
#include "core/simulation/study/simulated_room.h"
#include "core/support/parallel_for.h"
#include "core/workflow/register_case.h"
#include "io/angiogram_file.h"
#include "tests/benchmark/arguments.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <mutex>

using namespace angiopose;

namespace {

const char* const usage =
    "room_table [--studies <n>] [--seed <first>] [--rooms <list>] [--threads <n>] [--each ]\n"
    "  --studies <n>   of each room (20), from --seed on (1)\n"
    "  --rooms <list>  siemens, standard, moving, mirrored, without-table, object-plane (all)\n"
    "  --each          a line for each study\n";

constexpr double asideMm = 2.0;

struct Room {
    const char* name;
    core::RoomOptions options;
    double aim;   ///< target share of reliable and right results
};

const std::array rooms{
    Room{"siemens", {}, 0.95},
    Room{"standard", {.header = core::RoomHeader::Standard}, 0.95},
    Room{"moving", {.tableMoves = true}, 0.90},
    Room{"mirrored", {.isMirrored = true}, 0.95},
    Room{"without-table", {.header = core::RoomHeader::WithoutTable}, 0.90},
    Room{"object-plane", {.header = core::RoomHeader::ObjectPlane}, 0.90},
};

struct Outcome {
    double inSpaceMm = 0.0;   ///< 3-D error of the first view
    double acrossMm = 0.0;   ///< in-plane error of the worse view
    bool isTrusted = false;
    std::string words;

    bool isRight() const { return inSpaceMm < asideMm; }
};

struct Offsets {
    double inSpaceMm = 0.0, acrossMm = 0.0;
};

Offsets meanOffsets(const core::VesselTree& tree, const core::RigidTransform& found, const core::RigidTransform& truth)
{
    Offsets sum;
    double count = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const Eigen::Vector3d right = truth * point, offset = found * point - right;
            const Eigen::Vector3d ray = right.normalized();
            sum.inSpaceMm += offset.norm();
            sum.acrossMm += (offset - ray * ray.dot(offset)).norm();
            count += 1.0;
        }
    }
    return {sum.inSpaceMm / count, sum.acrossMm / count};
}

Outcome outcomeOf(const Room& room, std::uint64_t seed)
{
    const auto simulated = core::simulateRoom(seed, room.options);
    const test::TemporaryFolder folder;
    core::Case session;
    session.vessels.tree = std::make_shared<const core::VesselTree>(simulated.front().tree);
    session.views.clear();
    for (const core::SimulatedCase& view : simulated) {
        const std::string path = folder.file("view-" + std::to_string(session.views.size()) + ".dcm");
        core::View& read = session.views.emplace_back();
        const auto written = io::writeAngiogram(view.angiogram, path);
        auto angiogram = io::readAngiogram(path);
        if (!written || !angiogram) {
            return {.words = "not read"};
        }
        read.imageFile.path = path;
        read.geometry.cArm = angiogram.value().cArm;
        read.frame = view.angiogram.suggestedFrame;
        read.angiogram = std::make_shared<const core::Angiogram>(std::move(angiogram).value());
        read.cameraFromPatient = core::initialPoseOf(read, session.vessels).value();
    }
    const auto found = core::registerCase(session);
    if (!found) {
        return {.words = found.error().message.text()};
    }
    Outcome outcome;
    outcome.isTrusted = found.value().result().trustworthy;
    for (std::size_t k = 0; k < simulated.size(); ++k) {
        const Offsets offsets = meanOffsets(simulated[k].tree, found.value().joint->views[k].cameraFromPatient,
                                            simulated[k].trueCameraFromPatient);
        outcome.inSpaceMm = std::max(outcome.inSpaceMm, offsets.inSpaceMm);
        outcome.acrossMm = std::max(outcome.acrossMm, offsets.acrossMm);
    }
    for (const core::Message& warning : found.value().joint->warnings) {
        outcome.words += std::string(warning.id()) + " ";
    }
    return outcome;
}

void print(const Room& room, const std::vector<Outcome>& outcomes)
{
    const auto share = [&](auto isOne) {
        return static_cast<double>(std::ranges::count_if(outcomes, isOne)) / static_cast<double>(outcomes.size());
    };
    const double right = share([](const Outcome& each) { return each.isRight(); });
    const double both = share([](const Outcome& each) { return each.isRight() && each.isTrusted; });
    const double misleading = share([](const Outcome& each) { return !each.isRight() && each.isTrusted; });
    const double across = share([](const Outcome& each) { return each.acrossMm < asideMm; });
    std::printf(
        "%-14s %3zu  below 2 mm in space %5.1f %%, across the ray in both views %5.1f %%, right and trusted %5.1f %%, "
        "wrong and trusted %5.1f %%  (aim %.0f %%)  %s\n",
        room.name, outcomes.size(), 100.0 * right, 100.0 * across, 100.0 * both, 100.0 * misleading, 100.0 * room.aim,
        right >= room.aim && misleading == 0.0 ? "reached" : "MISSED");
    std::fflush(stdout);
}

}   // namespace

int main(int argc, char** argv)
{
    const benchmarks::Arguments arguments(argc, argv, usage);
    const auto count = static_cast<std::size_t>(arguments.number("studies", 20.0));
    const auto first = static_cast<std::uint64_t>(arguments.number("seed", 1.0));
    const auto wanted = arguments.list("rooms", "siemens,standard,moving,mirrored,without-table,object-plane");
    for (const Room& room : rooms) {
        if (std::ranges::find(wanted, room.name) == wanted.end()) {
            continue;
        }
        std::vector<Outcome> outcomes(count);
        std::mutex printing;
        core::parallelFor(
            count, static_cast<int>(arguments.number("threads", 2.0)),
            [&](std::size_t k) {
                outcomes[k] = outcomeOf(room, first + k);
                if (arguments.isSet("each")) {
                    const std::scoped_lock lock(printing);
                    std::printf("  %s seed %llu: %6.2f mm in space, %5.2f across, %s  %s\n", room.name,
                                static_cast<unsigned long long>(first + k), outcomes[k].inSpaceMm, outcomes[k].acrossMm,
                                outcomes[k].isTrusted ? "trusted" : "-", outcomes[k].words.c_str());
                    std::fflush(stdout);
                }
            },
            [](double) { return true; });
        print(room, outcomes);
    }
    return 0;
}
