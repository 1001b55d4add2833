#include "io/case/case_file.h"

#include "core/case/case_patients.h"
#include "core/geometry/geometry_checks.h"
#include "io/angiogram_file.h"
#include "io/case/case_document.h"
#include "io/case/case_inputs.h"
#include "io/case/case_schema.h"
#include "io/case/load_case_with_options.h"
#include "io/case/saved_files.h"
#include "io/case/stale_results.h"
#include "io/case/tracked_deformations_file.h"
#include "io/case/view_inputs.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <utility>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::Case;

constexpr std::size_t maxCaseBytes = 16 << 20;

/// Reads the text of a case file; fails if the text is not JSON.
core::Result<std::string> readCaseText(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (content.size() > maxCaseBytes) {
        return fileError(path, messages::caseTooLarge());
    }
    const auto* found = describeContent(content);
    if (found != nullptr && found != &messages::aJsonFile) {
        return fileError(path, messages::caseIsOther((*found)()));
    }
    if (const auto valid = checkJson(content, path); !valid) {
        return valid.error();
    }
    return std::string(content);
}

/// Parses the text of a case at `path`, makes the paths in it absolute and lists all problems.
CaseDocument examineText(const std::string& text, const std::string& path)
{
    CaseDocument document;
    document.problems = findSchemaProblems(text);
    if (document.problems.empty()) {
        document = parseCaseDocument(text);
    }
    makePathsAbsolute(document, path);
    return document;
}

/// Parses a case file and lists all problems; fails if the file is not JSON.
core::Result<CaseDocument> examine(const std::string& path)
{
    const auto text = readCaseText(path);
    return text ? core::Result<CaseDocument>(examineText(text.value(), path)) : text.error();
}

/// Parses a case file; fails if the file is not a case or has problems.
core::Result<CaseDocument> readDocument(const std::string& path, const std::optional<std::string>& text = std::nullopt)
{
    auto document = text ? core::Result<CaseDocument>(examineText(*text, path)) : examine(path);
    if (document && !document.value().problems.empty()) {
        return fileError(path, document.value().problems.front());
    }
    return document;
}

/// Reads a view stored in a case file of its own.
core::Status readViewOfCase(core::View& view, ViewNotes& notes)
{
    auto read = readDocument(view.caseFile.path);
    if (!read) {
        return read.error();
    }
    CaseDocument document = std::move(read).value();
    document.values.shown().caseFile = view.caseFile;
    view = std::move(document.values.shown());
    view.observations.clear();   // sightings refer to target points of the other case
    notes = std::move(document.notes.front());
    return core::Done{};
}

/// Loads the other views; omits a view that cannot be loaded and adds a warning.
void loadOtherViews(Case& loaded, std::vector<ViewNotes> notes, const std::string& path, core::Messages& warnings,
                    PeakFrameSearch peak)
{
    core::Messages found;
    for (std::size_t k = 1; k < loaded.views.size(); ++k) {
        core::View& view = loaded.views[k];
        const core::Status read = view.caseFile.path.empty() ? core::Done{} : readViewOfCase(view, notes[k]);
        if (read) {
            loadOtherView(view, notes[k], loaded.vessels, path, found, peak);
        } else {
            found.push_back(messages::caseViewLeftOut(read.error().message));
        }
    }
    for (core::Message& warning : found) {   // report a warning only once if all images of a study share it
        if (std::ranges::find(warnings, warning) == warnings.end()) {
            warnings.push_back(std::move(warning));
        }
    }
}

/// Returns the input case (JSON) stored at `path`; empty if there is none.
std::string inputAt(const Case& session, const std::string& path)
{
    std::vector<const core::InputFile*> files{&session.vessels.file, &session.vessels.scanFile};
    for (const core::View& view : session.views) {
        files.insert(files.end(),
                     {&view.imageFile, &view.target.file, &view.caseFile, &view.followed.deformationsFile});
    }
    for (const core::InputFile* file : files) {
        std::error_code absent;
        if (!file->path.empty() && fs::equivalent(file->path, path, absent)) {
            return file->path;
        }
    }
    return {};
}

/// Moves the shown view, which is read first, to its stored position among the views.
void putInPlace(Case& session, std::size_t place)
{
    const auto first = session.views.begin();
    std::rotate(first, first + 1, first + static_cast<std::ptrdiff_t>(place) + 1);
    session.shownView = place;
}

}   // namespace

core::Result<Case> loadCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe,
                            const MovedInputs& moved)
{
    return loadCaseWithOptions({}, path, warnings, observe, moved);
}

core::Result<Case> loadCaseWithOptions(const CaseLoadOptions& request, const std::string& path,
                                       core::Messages& warnings, const ReadObserver& observe, const MovedInputs& moved)
{
    try {
        auto read = readDocument(path, request.text);
        if (!read) {
            return read.error();
        }
        CaseDocument document = std::move(read).value();
        for (core::InputFile* file : inputsOf(document)) {
            const auto place = moved.find(file->path);
            file->path = place == moved.end() ? file->path : place->second;
        }
        const std::vector<ViewNotes> notes = document.notes;
        const std::size_t shownViewIndex = document.shownViewIndex;
        const Case stored = document.values;
        request.settings.applyTo(document.values);
        auto loaded = loadInputs(std::move(document), path, warnings, observe, request.peak);
        if (!loaded) {
            return loaded.error();
        }
        Case values = std::move(loaded).value();
        loadOtherViews(values, notes, path, warnings, request.peak);
        request.settings.applyTo(values);   // settings also apply to views with their own case files
        dropStaleResults(stored, notes, values, warnings);
        readTrackedDeformations(values, warnings);
        putInPlace(values, shownViewIndex);
        const core::Messages mismatch = core::findMismatch(values);
        warnings.insert(warnings.end(), mismatch.begin(), mismatch.end());
        return values;
    } catch (const std::exception&) {   // the schema does not reject every invalid value
        return fileError(path, messages::caseWrongKind());
    }
}

core::Result<std::vector<MissingInput>> findMissingInputs(const std::string& casePath)
{
    try {
        auto read = readDocument(casePath);
        if (!read) {
            return read.error();
        }
        CaseDocument document = std::move(read).value();
        const Case& values = document.values;
        std::vector<MissingInput> missing;
        for (const core::InputFile* file : inputsOf(document)) {
            const bool isNeeded = file == &values.vessels.file || file == &values.shown().imageFile ||
                                  file == &values.shown().target.file;
            if (std::error_code failed; !fs::exists(file->path, failed)) {
                missing.push_back({file->path, file->sha256, !isNeeded});
            }
        }
        return missing;
    } catch (const std::exception&) {
        return fileError(casePath, messages::caseWrongKind());
    }
}

std::vector<std::string> referencedPaths(const std::string& casePath)
{
    std::vector<std::string> paths;
    try {
        if (auto read = readDocument(casePath)) {
            CaseDocument document = std::move(read).value();
            for (const core::InputFile* file : inputsOf(document)) {
                paths.push_back(file->path);
            }
        }
    } catch (const std::exception&) {   // the file names no readable inputs
    }
    return paths;
}

std::vector<core::InputFile> referencedFiles(const std::string& text, const std::string& casePath)
{
    std::vector<core::InputFile> files;
    try {
        CaseDocument document = examineText(text, casePath);
        for (const core::InputFile* file : inputsOf(document)) {
            files.push_back(*file);
        }
    } catch (const std::exception&) {   // the text names no readable inputs
    }
    return files;
}

std::vector<core::InputFile> inputFilesOf(const Case& session)
{
    std::vector<core::InputFile> files;
    CaseDocument document;
    document.values = session;
    for (const core::InputFile* file : inputsOf(document)) {
        files.push_back(*file);
    }
    return files;
}

core::Result<core::Messages> validateCase(const std::string& path)
{
    try {
        auto examined = examine(path);
        if (!examined) {
            return examined.error();
        }
        CaseDocument document = std::move(examined).value();
        for (const core::InputFile* file : {&document.values.vessels.file, &document.values.shown().imageFile,
                                            &document.values.shown().target.file}) {
            const bool isSeries = document.values.vessels.input.kind == core::VesselInputKind::Volume &&
                                  file == &document.values.vessels.file && isFolder(file->path);
            if (file->path.empty() || isSeries) {
                continue;
            }
            if (const auto input = openInput(file->path); !input) {
                document.problems.push_back(input.error().message);
            }
        }
        return std::move(document.problems);
    } catch (const std::exception&) {
        return fileError(path, messages::caseWrongKind());
    }
}

core::Result<core::Messages> checkCaseGeometry(const std::string& path)
{
    try {
        auto examined = examine(path);
        if (!examined) {
            return examined.error();
        }
        CaseDocument document = std::move(examined).value();
        Case& values = document.values;
        const auto angiogram = readAngiogram(values.shown().imageFile.path);
        if (!angiogram) {
            return angiogram.error();
        }
        fillFromHeader(values.shown().geometry.cArm, angiogram.value().cArm);
        auto doubts = core::findContradictions(values.shown().geometry.cArm, angiogram.value().gantry,
                                               {angiogram.value().width(), angiogram.value().height()});
        if (!values.shown().geometry.cameraOverride && !values.shown().initialCameraFromPatient) {
            for (core::Message& missing : core::findMissingGeometry(values.shown().geometry.cArm)) {
                doubts.push_back(std::move(missing));
            }
        }
        return doubts;
    } catch (const std::exception&) {
        return fileError(path, messages::caseWrongKind());
    }
}

std::optional<core::Message> findSaveObstacle(const Case& session)
{
    if (!session.vessels.tree && session.vessels.scan) {
        return messages::caseScanAlone();
    }
    const bool hasMask =
        session.vessels.isLumenEdited && session.vessels.lumen;   // an edited mask is saved next to the case file
    if ((session.vessels.file.path.empty() && !hasMask) || session.shown().imageFile.path.empty()) {
        return messages::caseIncomplete();
    }
    const auto& initial = session.shown().initialCameraFromPatient;
    if (!core::isRigid(session.shown().cameraFromPatient) || (initial && !core::isRigid(*initial))) {
        return messages::casePoseNotRigid();
    }
    return {};
}

core::Status saveCase(const Case& session, const std::string& path)
{
    if (const std::string input = inputAt(session, path); !input.empty()) {
        return fileError(path, messages::caseIsInput());
    }
    if (const auto unsavable = findSaveObstacle(session)) {
        return fileError(path, *unsavable);
    }
    Case savedCase = session;
    if (auto completed = writeCompanionFiles(savedCase, path); !completed) {
        return completed;
    }
    try {
        const fs::path folder = fs::weakly_canonical(fs::absolute(path).parent_path());
        return writeAtomically(path, caseDocumentJson(savedCase, folder));
    } catch (const std::exception&) {   // JSON is UTF-8, but file names may not be
        return fileError(path, messages::caseNotUtf8());
    }
}

}   // namespace angiopose::io
