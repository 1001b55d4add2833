#include "app/cli/commands.h"
#include "app/cli/shard.h"
#include "app/messages/messages.h"
#include "core/case/case.h"
#include "core/simulation/simulate_cta.h"
#include "core/simulation/simulated_case.h"
#include "core/simulation/study/simulated_room.h"
#include "core/simulation/study/simulated_study.h"
#include "core/support/parallel_for.h"
#include "core/support/result.h"
#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/centerline2d_file.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/pose_file.h"
#include "io/simulation/study_file.h"
#include "io/support/atomic_file.h"
#include "io/support/case_lock.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace angiopose::app {
namespace {

/// Initial pose of a simulated case: stored in the case file, or derived from the header geometry.
enum class InitialPoseSource { Written, ByHeader };

namespace fs = std::filesystem;

core::Case caseOf(const core::SimulatedCase& simulated, const fs::path& folder, const std::string& title,
                  InitialPoseSource start)
{
    core::Case session;
    session.title = title;
    session.vessels.file.path = (folder / "tree.vtp").string();
    session.vessels.tree = std::make_shared<const core::VesselTree>(simulated.tree);
    core::View& view = session.shown();
    view.imageFile.path = (folder / "angiogram.dcm").string();
    view.angiogram = std::make_shared<const core::Angiogram>(simulated.angiogram);
    view.frame = simulated.angiogram.suggestedFrame;
    view.geometry.cArm = simulated.angiogram.cArm;
    if (start == InitialPoseSource::Written) {
        view.initialCameraFromPatient = simulated.initialCameraFromPatient;
    }
    view.cameraFromPatient = simulated.initialCameraFromPatient;
    return session;
}

core::Status writeTruth(const core::SimulatedCase& simulated, const fs::path& folder)
{
    if (auto status = io::writeCenterline2d(simulated.trueTarget, (folder / "true-centreline.csv").string()); !status) {
        return status;
    }
    if (auto status = io::writePose(simulated.trueCameraFromPatient, (folder / "true-pose.json").string()); !status) {
        return status;
    }
    const fs::path deformed = folder / "true-vessels.vtp";
    if (simulated.deformedTree) {
        return io::writeVesselTree(*simulated.deformedTree, deformed.string());
    }
    std::error_code failure;
    fs::remove(deformed, failure);   // may remain from another case in this folder
    return core::Done{};
}

/// Writes case.angiopose with its inputs tree.vtp and angiogram.dcm, and the ground truth (true-pose.json,
/// true-centreline.csv and, for deformed vessels, true-vessels.vtp). Creates the folder. Never overwrites a case that
/// is open in another process.
core::Status writeSimulatedCase(const core::SimulatedCase& simulated, const std::string& title,
                                const std::string& folderPath, InitialPoseSource start = InitialPoseSource::Written)
{
    const fs::path folder(folderPath);
    const fs::path absolute = fs::absolute(folder);
    const std::string casePath = (absolute / "case.angiopose").string();
    if (const auto holder = io::lockHolderOf(casePath)) {   // overwriting would replace the inputs of an open case
        return core::Error(io::messages::caseOpenElsewhere(holder->process, holder->machine).about(casePath));
    }
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        return core::Error(messages::folderNotMade(folder.string(), failure.message()));
    }
    if (auto status = io::writeVesselTree(simulated.tree, (folder / "tree.vtp").string()); !status) {
        return status;
    }
    if (auto status = io::writeAngiogram(simulated.angiogram, (folder / "angiogram.dcm").string()); !status) {
        return status;
    }
    if (auto status = writeTruth(simulated, folder); !status) {
        return status;
    }
    return io::saveCase(caseOf(simulated, absolute, title, start), casePath);
}

constexpr std::size_t numberDigits = 4;   ///< digits of a case number, zero-padded so that folders sort by number

core::Status writeScan(std::uint64_t seed, const core::TreeOptions& tree, const core::CtaOptions& cta,
                       const fs::path& folder)
{
    return io::writeVolume(core::simulateCta(seed, tree, cta).volume, (folder / "scan.nii.gz").string());
}

core::RoomHeader roomHeaderFrom(const std::string& word)
{
    return word == "siemens"         ? core::RoomHeader::Siemens
           : word == "standard"      ? core::RoomHeader::Standard
           : word == "without-table" ? core::RoomHeader::WithoutTable
                                     : core::RoomHeader::ObjectPlane;
}

/// Simulates the views in a room, whose initial poses the headers determine.
int runSimulateRoom(const SimulateArguments& arguments, const core::TreeOptions& tree, const core::DsaOptions& dsa)
{
    const core::RoomOptions room{roomHeaderFrom(arguments.room), arguments.moveTable, arguments.isMirrored};
    const auto views = core::simulateRoom(*arguments.seed, room, tree, dsa);
    for (std::size_t k = 0; k < views.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        const fs::path folder = fs::path(arguments.outputFolder) / ("view-" + number);
        const std::string title = "Simulated room, seed " + std::to_string(*arguments.seed) + ", view " + number;
        if (const auto status = writeSimulatedCase(views[k], title, folder.string(), InitialPoseSource::ByHeader);
            !status) {
            return reportInputError(status.error());
        }
        std::printf("%s\n", (folder / "case.angiopose").string().c_str());
    }
    return exitSuccess;
}

int runSimulateOne(const SimulateArguments& arguments)
{
    core::TreeOptions tree;
    tree.branchCount = arguments.branches;
    core::DsaOptions dsa;
    dsa.nonRigidStdMm = arguments.nonRigidMm;
    if (const auto problem = core::findProblem(tree, dsa)) {
        return reportInputError(*problem);
    }
    if (!arguments.room.empty()) {
        return runSimulateRoom(arguments, tree, dsa);
    }
    const core::CtaOptions cta;
    if (arguments.withScan) {
        tree = core::treeOptionsForScan(tree, cta);
    }
    const std::uint64_t seed = *arguments.seed;
    const fs::path folder(arguments.outputFolder);
    core::Status status = writeSimulatedCase(core::simulateCase(seed, tree, dsa),
                                             "Simulated case, seed " + std::to_string(seed), folder.string());
    if (status && arguments.withScan) {
        status = writeScan(seed, tree, cta, folder);
    }
    if (!status) {
        return reportInputError(status.error());
    }
    std::printf("%s\n", (folder / "case.angiopose").string().c_str());
    return exitSuccess;
}

/// Returns the folder of a case relative to the study's folder, such as "rigid/0007".
std::string folderOf(const core::SimulatedStudy& study, std::size_t index)
{
    const core::StudyCase place = core::studyCaseOf(study, index);
    const std::string number = std::to_string(place.number + 1);
    return study.settings[place.setting].name + "/" +
           std::string(numberDigits - std::min(numberDigits, number.size()), '0') + number;
}

bool isDeformed(const core::SimulatedStudy& study, std::size_t index)
{
    return study.settings[core::studyCaseOf(study, index).setting].dsa.nonRigidStdMm > 0.0;
}

/// Lists the files of a case in alphabetical order.
std::vector<std::string> filesOfCase(const core::SimulatedStudy& study, std::size_t index)
{
    std::vector<std::string> files{"angiogram.dcm", "case.angiopose", "true-centreline.csv", "true-pose.json"};
    if (isDeformed(study, index)) {
        files.push_back("true-vessels.vtp");
    }
    files.push_back("tree.vtp");
    return files;
}

/// Returns the manifest of all cases and their ground truth, for `batch` and `evaluate own`.
std::string manifestOf(const core::SimulatedStudy& study)
{
    std::string text = "case,name,reference,bent,patient,condition\n";
    for (std::size_t k = 0; k < study.caseCount(); ++k) {
        const core::StudyCase place = core::studyCaseOf(study, k);
        const std::string folder = folderOf(study, k);
        std::string name = folder;
        std::ranges::replace(name, '/', '-');
        const std::string deformed = isDeformed(study, k) ? folder + "/true-vessels.vtp" : "";
        text += folder + "/case.angiopose," + name + "," + folder + "/true-pose.json," + deformed + ",tree-" +
                std::to_string(place.tree + 1) + "," + study.settings[place.setting].name + "\n";
    }
    return text;
}

core::Status writeStudyCase(const core::SimulatedStudy& study, std::size_t index, const fs::path& output)
{
    const std::string folder = folderOf(study, index);
    return writeSimulatedCase(core::simulateStudyCase(study, index), study.name + ", " + folder,
                              (output / folder).string());
}

/// Returns checksum lines in the format of sha256sum.
core::Result<std::string> checksumsOf(const core::SimulatedStudy& study, const std::vector<std::size_t>& cases,
                                      const fs::path& output)
{
    std::string text;
    for (const std::size_t index : cases) {
        for (const std::string& name : filesOfCase(study, index)) {
            const std::string file = folderOf(study, index) + "/" + name;
            const auto hash = io::sha256OfFile((output / file).string());
            if (!hash) {
                return hash.error();
            }
            text += hash.value() + "  " + file + "\n";
        }
    }
    return text;
}

std::vector<std::size_t> casesOf(const core::SimulatedStudy& study, const core::Shard& shard)
{
    std::vector<std::size_t> cases;
    for (std::size_t k = shard.index; k < study.caseCount(); k += shard.count) {
        cases.push_back(k);
    }
    return cases;
}

/// Writes the cases and returns the first error in case order; nullopt if all were written or the user stopped.
std::optional<core::Error> writeCases(const core::SimulatedStudy& study, const std::vector<std::size_t>& cases,
                                      int threads, const fs::path& output)
{
    ProgressLine progress("simulating");
    std::vector<std::optional<core::Error>> faults(cases.size());
    core::parallelFor(
        cases.size(), threads,
        [&](std::size_t k) {
            if (const auto status = writeStudyCase(study, cases[k], output); !status) {
                faults[k] = status.error();
            }
        },
        [&](double done) {
            progress.show(done, std::to_string(cases.size()) + " cases");
            return !isInterrupted();
        });
    const auto first = std::ranges::find_if(faults, [](const auto& fault) { return fault.has_value(); });
    return first == faults.end() ? std::nullopt : *first;
}

std::string sumsName(const core::Shard& shard)
{
    return shard.count == 1 ? "SHA256SUMS"
                            : "SHA256SUMS-" + std::to_string(shard.index + 1) + "-of-" + std::to_string(shard.count);
}

core::Status writeLists(const core::SimulatedStudy& study, const core::Shard& shard, const fs::path& output)
{
    const auto sums = checksumsOf(study, casesOf(study, shard), output);
    if (!sums) {
        return sums.error();
    }
    if (auto status = io::writeAtomically((output / sumsName(shard)).string(), sums.value()); !status) {
        return status;
    }
    return io::writeAtomically((output / "cases.csv").string(), manifestOf(study));
}

int runSimulateStudy(const SimulateArguments& arguments)
{
    const auto shard = parseShard(arguments.shard);
    if (!shard) {
        printMessage(shard.error().message.text());
        return exitUsageError;
    }
    const auto study = io::readStudy(arguments.studyPath);
    if (!study) {
        return reportInputError(study.error());
    }
    if (const auto problem = core::findProblem(study.value())) {
        return reportInputError(*problem);
    }
    const fs::path output(arguments.outputFolder);
    if (const auto fault = writeCases(study.value(), casesOf(study.value(), shard.value()),
                                      core::threadCount(arguments.threads.value_or(0)), output)) {
        return reportInputError(*fault);
    }
    if (isInterrupted()) {
        return exitInterrupted;
    }
    if (const auto status = writeLists(study.value(), shard.value(), output); !status) {
        return reportInputError(status.error());
    }
    std::printf("%s\n", (output / "cases.csv").string().c_str());
    return exitSuccess;
}

}   // namespace

int runSimulate(const SimulateArguments& arguments)
{
    if (!arguments.studyPath.empty()) {
        return runSimulateStudy(arguments);
    }
    if (!arguments.seed) {
        printMessage(core::Message(messages::simulateWhat()).text());
        return exitUsageError;
    }
    return runSimulateOne(arguments);
}

}   // namespace angiopose::app
