#include "io/case/tracked_deformations_file.h"

#include "core/registration/deformable/deformed_tree.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/byte_order.h"
#include "io/support/companion_path.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using core::BranchMotion;
using core::TrackedRun;
using core::TrackedRunFrame;

constexpr std::size_t numbersOfPoint = 9;   // displacement x, y, z; covariance xx, xy, xz, yy, yz, zz
constexpr std::size_t bytesOfNumber = 4;

std::vector<const TrackedRunFrame*> framesWithDeformation(const TrackedRun& run)
{
    std::vector<const TrackedRunFrame*> frames;
    for (const TrackedRunFrame& each : core::framesOf(run)) {
        if (core::hasOwnDeformation(each)) {
            frames.push_back(&each);
        }
    }
    return frames;
}

/// Returns the file header, which depends only on the numbers of points and deformations.
std::string deformationsHeader(std::size_t points, std::size_t deformations)
{
    return "NRRD0004\n"
           "# How vessels are bent in the frames of a run: FORMATS 2.12 of AngioPose\n"
           "type: float\n"
           "dimension: 3\n"
           "sizes: " +
           std::to_string(numbersOfPoint) + " " + std::to_string(points) + " " + std::to_string(deformations) +
           "\n"
           "endian: little\n"
           "encoding: raw\n"
           "labels: \"x y z xx xy xz yy yz zz\" \"point\" \"bend\"\n"
           "\n";
}

void appendNumber(std::string& bytes, double value)
{
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (std::size_t k = 0; k < bytesOfNumber; ++k) {
        bytes += static_cast<char>(bits >> (8 * k) & 0xFF);
    }
}

void appendMotion(std::string& bytes, const BranchMotion& motion)
{
    for (std::size_t i = 0; i < motion.displacementMm.size(); ++i) {
        const Eigen::Vector3d& moved = motion.displacementMm[i];
        const Eigen::Matrix3d& m = motion.covariance[i];
        for (const double value :
             {moved.x(), moved.y(), moved.z(), m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)}) {
            appendNumber(bytes, value);
        }
    }
}

std::string deformationsContent(const std::vector<const TrackedRunFrame*>& frames)
{
    std::size_t points = 0;
    for (const BranchMotion& motion : frames.front()->deformed->branches) {
        points += motion.displacementMm.size();
    }
    std::string bytes = deformationsHeader(points, frames.size());
    bytes.reserve(bytes.size() + frames.size() * points * numbersOfPoint * bytesOfNumber);
    for (const TrackedRunFrame* frame : frames) {
        for (const BranchMotion& motion : frame->deformed->branches) {
            appendMotion(bytes, motion);
        }
    }
    return bytes;
}

/// Returns the deformation file that the existing case file names for a view; empty if it names none.
fs::path namedDeformation(const fs::path& casePath, std::optional<std::size_t> otherView)
{
    const auto input = openInput(casePath.string());
    const Json root = input ? Json::parse(input.value().view(), nullptr, false) : Json();
    const std::string views = otherView ? "/views/" + std::to_string(*otherView) : std::string();
    const Json::json_pointer place(views + "/followed/bends/path");
    if (!root.is_object() || !root.contains(place) || !root[place].is_string()) {
        return {};
    }
    return (casePath.parent_path() / root[place].get<std::string>()).lexically_normal();
}

/// Reads displacement and covariance point by point.
class DeformationReader {
public:
    explicit DeformationReader(std::string_view bytes) : bytes_(bytes) {}

    double next()
    {
        const auto value = std::bit_cast<float>(readUint32(bytes_, ByteOrder::Little));
        bytes_.remove_prefix(bytesOfNumber);
        areFinite_ = areFinite_ && std::isfinite(value);
        return value;
    }

    void readInto(BranchMotion& motion, std::size_t points)
    {
        for (std::size_t i = 0; i < points; ++i) {
            const double x = next();
            const double y = next();
            motion.displacementMm.emplace_back(x, y, next());
            Eigen::Matrix3d& m = motion.covariance.emplace_back();
            for (int row = 0; row < 3; ++row) {
                for (int column = row; column < 3; ++column) {
                    m(row, column) = m(column, row) = next();
                }
            }
        }
        core::roundMotion(motion);   // restores the values as rounded before writing (single precision)
    }

    bool areFinite() const { return areFinite_; }

private:
    std::string_view bytes_;
    bool areFinite_ = true;
};

/// Returns whether the deformation contains exactly the branches of this tree.
bool namesBranchesOf(const core::VesselTree& tree, const core::DeformableResult& deformed)
{
    return deformed.branches.size() == tree.branches.size() &&
           std::ranges::all_of(tree.branches, [&deformed](const auto& branch) {
               return core::findMotion(deformed, branch.id) != nullptr;
           });
}

/// Returns the data after the header; fails unless they hold this number of deformations of this tree.
core::Result<std::string_view> deformationNumbersIn(std::string_view content, const core::VesselTree& tree,
                                                    std::size_t deformations)
{
    if (!content.starts_with("NRRD")) {
        return core::Error(messages::caseDeformationNone());
    }
    const std::string header = deformationsHeader(tree.pointCount(), deformations);
    if (!content.starts_with(header)) {
        return core::Error(messages::caseDeformationOfOthers());
    }
    content.remove_prefix(header.size());
    if (content.size() != tree.pointCount() * deformations * numbersOfPoint * bytesOfNumber) {
        return core::Error(messages::caseDeformationCut());
    }
    return content;
}

core::Result<InputBytes> openDeformation(const core::InputFile& file)
{
    if (file.path.empty()) {
        return core::Error(messages::caseDeformationUnnamed());
    }
    auto input = openInput(file.path);
    if (!input) {
        return input.error();
    }
    if (!file.sha256.empty()) {
        const auto hash = sha256OfText(input.value().view());
        if (!hash || hash.value() != file.sha256) {
            return fileError(file.path, messages::caseDeformationChanged());
        }
    }
    return input;
}

/// Reads all deformations of a cine run; reads none on failure.
core::Status readDeformation(TrackedRun& run, const core::VesselTree& tree)
{
    const std::vector<const TrackedRunFrame*> deformed = framesWithDeformation(run);
    const auto input = openDeformation(run.deformationsFile);
    if (!input) {
        return input.error();
    }
    const auto bytes = deformationNumbersIn(input.value().view(), tree, deformed.size());
    if (!bytes) {
        return fileError(run.deformationsFile.path, bytes.error());
    }
    DeformationReader numbers(bytes.value());
    auto frames = std::make_shared<std::vector<TrackedRunFrame>>(core::framesOf(run));
    for (TrackedRunFrame& each : *frames) {
        if (!core::hasOwnDeformation(each)) {
            continue;
        }
        if (!namesBranchesOf(tree, *each.deformed)) {
            return fileError(run.deformationsFile.path, messages::caseDeformationOfOthers());
        }
        auto whole = std::make_shared<core::DeformableResult>(*each.deformed);
        for (BranchMotion& motion : whole->branches) {
            numbers.readInto(motion, tree.find(motion.branchId)->pointsInPatient.size());
        }
        each.deformed = std::move(whole);
    }
    if (!numbers.areFinite()) {
        return fileError(run.deformationsFile.path, messages::caseDeformationCut());
    }
    run.frames = std::move(frames);
    return core::Done{};
}

/// Copies deformations to frames that do not show the vessels.
void propagateDeformation(TrackedRun& run)
{
    auto frames = std::make_shared<std::vector<TrackedRunFrame>>(core::framesOf(run));
    for (TrackedRunFrame& each : *frames) {
        const TrackedRunFrame* from =
            each.deformationSourceFrame ? core::findFrame(run, *each.deformationSourceFrame) : nullptr;
        if (from && core::hasOwnDeformation(*from)) {
            each.deformed = core::transferDeformation(*from, each.tracked.cameraFromPatient);
        }
    }
    run.frames = std::move(frames);
}

void dropDeformation(TrackedRun& run)
{
    auto frames = std::make_shared<std::vector<TrackedRunFrame>>(core::framesOf(run));
    for (TrackedRunFrame& each : *frames) {
        each.deformed.reset();
        each.deformationSourceFrame.reset();
    }
    run.frames = std::move(frames);
    run.deformationsFile = {};
}

}   // namespace

core::Result<core::InputFile> saveTrackedDeformations(const TrackedRun& run, const std::string& casePath,
                                                      std::optional<std::size_t> otherView)
{
    const std::vector<const TrackedRunFrame*> frames = framesWithDeformation(run);
    if (frames.empty()) {
        return core::InputFile{};
    }
    const std::string content = deformationsContent(frames);
    const fs::path whole = fs::absolute(casePath);
    const std::string path =
        companionPath(whole, {otherView, "bends", "nrrd"}, namedDeformation(whole, otherView)).string();
    if (const auto written = writeAtomically(path, content); !written) {
        return written.error();
    }
    auto hash = sha256OfText(content);
    return hash ? core::Result<core::InputFile>(core::InputFile{path, std::move(hash).value()}) : hash.error();
}

void readTrackedDeformations(core::Case& read, core::Messages& warnings)
{
    for (core::View& view : read.views) {
        TrackedRun& run = view.followed;
        if (framesWithDeformation(run).empty() || !read.vessels.tree) {
            continue;
        }
        if (const core::Status status = readDeformation(run, *read.vessels.tree)) {
            propagateDeformation(run);
        } else {
            warnings.push_back(messages::caseDeformationLeftOut(status.error().message));
            dropDeformation(run);
        }
    }
}

}   // namespace angiopose::io
