#include "app/cli/evaluate_own.h"

#include "app/cli/case_input.h"
#include "app/cli/console.h"
#include "app/cli/shard.h"
#include "core/evaluation/own/evaluate_own_case.h"
#include "core/messages/messages.h"
#include "core/support/parallel_for.h"
#include "core/support/stopwatch.h"
#include "core/workflow/register_case.h"
#include "io/evaluation/cohort_manifest.h"
#include "io/evaluation/observer_readings.h"
#include "io/messages/messages.h"
#include "io/pose_file.h"
#include "io/vessel_tree_file.h"

#include <algorithm>
#include <mutex>

namespace angiopose::app {
namespace {

/// Method with its options; without options, those of each case are used.
struct UserCaseMethod {
    std::string label;
    std::optional<core::RegistrationOptions> options;
};

/// Row of the manifest with the contents of its files.
struct EvaluationTask {
    io::CohortEntry entry;
    std::uint64_t trial = 0;   ///< index of the row in the manifest
    core::OwnGroundTruth truth;
    std::optional<core::RigidTransform> start;
    std::vector<std::pair<std::string, core::RigidTransform>>
        found;   ///< poses found by other programs, with the names of their sources
};

core::Result<std::optional<core::RigidTransform>> poseAt(const std::string& path)
{
    if (path.empty()) {
        return std::optional<core::RigidTransform>();
    }
    const auto pose = io::readPose(path);
    return pose ? core::Result<std::optional<core::RigidTransform>>(pose.value()) : pose.error();
}

core::Result<core::OwnGroundTruth> groundTruthOf(const io::CohortEntry& entry)
{
    core::OwnGroundTruth truth;
    const auto reference = poseAt(entry.referencePath);
    if (!reference) {
        return reference.error();
    }
    truth.cameraFromPatient = reference.value();
    if (!entry.deformedVesselsPath.empty()) {
        auto deformed = io::readVesselTree(entry.deformedVesselsPath);
        if (!deformed) {
            return deformed.error();
        }
        truth.deformedTree = std::make_shared<const core::VesselTree>(std::move(deformed).value());
    }
    if (!entry.landmarksPath.empty()) {
        auto landmarks = io::readLandmarks(entry.landmarksPath);
        if (!landmarks) {
            return landmarks.error();
        }
        truth.landmarksInPatient = std::move(landmarks).value();
    }
    if (!entry.pointPairsPath.empty()) {
        auto pairs = io::readPointPairs(entry.pointPairsPath);
        if (!pairs) {
            return pairs.error();
        }
        truth.pairs = std::move(pairs).value();
    }
    return truth;
}

core::Result<EvaluationTask> taskOf(const io::CohortEntry& entry, std::uint64_t trial)
{
    auto truth = groundTruthOf(entry);
    if (!truth) {
        return truth.error();
    }
    const auto start = poseAt(entry.initialPosePath);
    if (!start) {
        return start.error();
    }
    EvaluationTask task{entry, trial, std::move(truth).value(), start.value(), {}};
    for (const auto& [name, path] : entry.methodPosePaths) {
        const auto pose = io::readPose(path);
        if (!pose) {
            return pose.error();
        }
        task.found.emplace_back(name, pose.value());
    }
    return task;
}

/// Reads the rows of the shard with all ground-truth files before the first case is registered.
core::Result<std::vector<EvaluationTask>> tasksOf(const std::vector<io::CohortEntry>& entries, const core::Shard& shard)
{
    std::vector<EvaluationTask> tasks;
    for (std::uint64_t row = shard.index; row < entries.size(); row += shard.count) {
        auto task = taskOf(entries[row], row);
        if (!task) {
            return task.error();
        }
        tasks.push_back(std::move(task).value());
    }
    return tasks;
}

core::Result<std::vector<UserCaseMethod>> methodsOf(const std::string& requests)
{
    std::vector<UserCaseMethod> methods;
    if (requests.empty()) {
        methods.push_back({"case", std::nullopt});
        return methods;
    }
    const auto evaluatedMethods = core::parseMethods(requests);
    if (!evaluatedMethods) {
        return evaluatedMethods.error();
    }
    for (const core::EvaluatedMethod& evaluatedMethod : evaluatedMethods.value()) {
        methods.push_back({evaluatedMethod.label, evaluatedMethod.options});
    }
    return methods;
}

/// Registers and evaluates rows, one at a time or several in parallel.
class CaseEvaluator {
public:
    explicit CaseEvaluator(const std::vector<UserCaseMethod>& methods) : methods_(methods) {}

    /// Returns the records of all methods and of the poses found by other programs; empty if the user has canceled.
    std::vector<core::RunRecord> judge(const EvaluationTask& task)
    {
        const auto session = loaded(task);
        const auto camera =
            session ? core::cameraOf(session.value().shown()) : core::Result<core::ProjectionCamera>(session.error());
        if (!camera || !session.value().vessels.tree) {
            tell(task, camera ? core::Error(core::messages::noVesselTree()) : camera.error());
            return recordsWithoutResult(task);
        }
        const core::VesselTree* deformed = task.truth.deformedTree.get();
        if (deformed && !core::isGroundTruthFor(*deformed, *session.value().vessels.tree)) {
            tell(task, core::Error(io::messages::ownDeformedOther()).about(task.entry.deformedVesselsPath));
            return recordsWithoutResult(task);
        }
        const core::OwnCase own{*session.value().vessels.tree, camera.value(),
                                session.value().shown().cameraFromPatient, task.truth};
        std::vector<core::RunRecord> records;
        for (const UserCaseMethod& method : methods_) {
            records.push_back(named(judgeMethod(task, own, session.value(), method), task, method.label));
        }
        for (const auto& [name, pose] : task.found) {
            records.push_back(named(core::evaluateOwnCase(own, pose), task, name));
        }
        return isInterrupted() ? std::vector<core::RunRecord>() : records;
    }

private:
    void tell(const EvaluationTask& task, const core::Error& error)
    {
        const std::lock_guard lock(informative_);
        printMessage("line " + std::to_string(task.entry.line) + ": " + std::string(error.message.text()));
    }

    /// Loads the case of a row under a lock, since the file readers are not thread-safe.
    core::Result<core::Case> loaded(const EvaluationTask& task)
    {
        const std::lock_guard lock(loading_);
        auto read = loadCaseForCommand(task.entry.casePath, std::nullopt);
        if (!read) {
            return read.error();
        }
        core::Case session = std::move(read).value();
        session.shown().cameraFromPatient = task.start.value_or(session.shown().cameraFromPatient);
        return session;
    }

    core::RunRecord judgeMethod(const EvaluationTask& task, const core::OwnCase& own, core::Case session,
                                const UserCaseMethod& method)
    {
        if (method.options) {
            session.options = *method.options;
        }
        const core::ThreadStopwatch processor;
        const auto registered = core::registerCase(std::move(session), {}, [](const auto&) {
            return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
        });
        if (!registered) {
            tell(task, registered.error());
        }
        core::RunRecord record = core::evaluateOwnCase(
            own, registered ? std::optional(registered.value().result()) : std::optional<core::RegistrationResult>());
        record.processorMs = processor.elapsedMs();
        return record;
    }

    /// Returns records without a result for a case that cannot be opened.
    std::vector<core::RunRecord> recordsWithoutResult(const EvaluationTask& task) const
    {
        std::vector<core::RunRecord> records;
        for (const UserCaseMethod& method : methods_) {
            records.push_back(named({}, task, method.label));
        }
        return records;
    }

    static core::RunRecord named(core::RunRecord record, const EvaluationTask& task, const std::string& label)
    {
        record.condition = task.entry.condition;
        record.method = label;
        record.trial = task.trial;
        record.anatomy = task.entry.patient;
        return record;
    }

    const std::vector<UserCaseMethod>& methods_;
    std::mutex loading_;
    std::mutex informative_;
};

/// Evaluates all rows; the records do not depend on the number of threads.
core::Experiment evaluateAll(const std::vector<EvaluationTask>& tasks, const std::vector<UserCaseMethod>& methods,
                             int threads)
{
    CaseEvaluator judge(methods);
    ProgressLine progress("judging");
    std::vector<std::vector<core::RunRecord>> found(tasks.size());
    core::parallelFor(
        tasks.size(), threads, [&](std::size_t k) { found[k] = judge.judge(tasks[k]); },
        [&](double done) {
            progress.show(done, std::to_string(tasks.size()) + " cases");
            return !isInterrupted();
        });
    core::Experiment experiment{{userCasesProtocol, 1, {}}, isInterrupted()};
    for (std::vector<core::RunRecord>& records : found) {
        std::ranges::move(records, std::back_inserter(experiment.runs.runs));
    }
    return experiment;
}

}   // namespace

core::Result<core::Experiment> evaluateUserCases(const EvaluateArguments& arguments)
{
    const auto shard = parseShard(arguments.shard);
    if (!shard) {
        return shard.error();
    }
    const auto methods = methodsOf(arguments.methods);
    if (!methods) {
        return methods.error();
    }
    const auto entries = io::readCohortManifest(arguments.inputPaths.front());
    if (!entries) {
        return entries.error();
    }
    const auto tasks = tasksOf(entries.value(), shard.value());
    if (!tasks) {
        return tasks.error();
    }
    return evaluateAll(tasks.value(), methods.value(), core::threadCount(arguments.threads.value_or(0)));
}

core::Result<std::vector<core::ObserverReading>> readObserverLogs(const std::vector<std::string>& paths)
{
    std::vector<core::ObserverReading> all;
    for (const std::string& path : paths) {
        auto readings = io::readObserverReadings(path);
        if (!readings) {
            return readings.error();
        }
        std::ranges::move(readings.value(), std::back_inserter(all));
    }
    return all;
}

}   // namespace angiopose::app
