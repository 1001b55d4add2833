#include "io/case_file.h"

#include "core/geometry/geometry_checks.h"
#include "io/angiogram_file.h"
#include "io/case/case_document.h"
#include "io/case/case_inputs.h"
#include "io/case/case_schema.h"
#include "io/case/saved_files.h"
#include "io/case/view_inputs.h"
#include "io/messages/says.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <utility>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::RegistrationCase;

constexpr std::size_t maxCaseBytes = 16 << 20;

/// The text of a case file that is JSON.
core::Result<std::string> readCaseText(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (content.size() > maxCaseBytes) {
        return fileError(path, says::caseTooLarge());
    }
    const auto* found = describeContent(content);
    if (found != nullptr && found != &says::aJsonFile) {
        return fileError(path, says::caseIsOther((*found)()));
    }
    if (const auto valid = checkJson(content, path); !valid) {
        return valid.error();
    }
    return std::string(content);
}

/// Content, and everything wrong with it.
CaseDocument examine(const std::string& text)
{
    CaseDocument document;
    document.problems = findSchemaProblems(text);
    return document.problems.empty() ? parseCaseDocument(text) : document;
}

/// The document of a case file, its paths absolute. Fails where the file is no case, or one that makes no sense.
core::Result<CaseDocument> readDocument(const std::string& path)
{
    const auto text = readCaseText(path);
    if (!text) {
        return text.error();
    }
    CaseDocument document = examine(text.value());
    if (!document.problems.empty()) {
        return fileError(path, document.problems.front());
    }
    makePathsAbsolute(document, path);
    return document;
}

/// A view that stands in the case, or in a case file of its own.
core::Result<CaseDocument> documentOf(const core::OtherView& other, std::vector<CaseDocument>& standing)
{
    if (!other.file.path.empty()) {
        return readDocument(other.file.path);
    }
    CaseDocument document = std::move(standing.front());
    standing.erase(standing.begin());
    return document;
}

/// A view that cannot be had is a warning: the case opens without.
void loadOtherViews(RegistrationCase& loaded, std::vector<CaseDocument> standing, const std::string& path,
                    core::Messages& warnings)
{
    core::Messages found;
    for (core::OtherView& other : loaded.otherViews) {
        auto document = documentOf(other, standing);
        if (document) {
            other.view = std::make_shared<const RegistrationCase>(
                loadOtherView(std::move(document).value(), loaded, path, found));
        } else {
            found.push_back(says::caseViewLeftOut(document.error().message));
        }
    }
    for (core::Message& warning : found) {   // what holds for all images of a study is said once
        if (std::ranges::find(warnings, warning) == warnings.end()) {
            warnings.push_back(std::move(warning));
        }
    }
}

/// The input that `path` is, if any.
std::string inputAt(const RegistrationCase& registrationCase, const std::string& path)
{
    std::vector<const core::InputFile*> files{&registrationCase.centerlineFile, &registrationCase.scanFile,
                                              &registrationCase.imageFile, &registrationCase.targetFile};
    for (const core::OtherView& other : registrationCase.otherViews) {
        files.push_back(&other.file);
        if (other.view) {
            files.push_back(&other.view->imageFile);
            files.push_back(&other.view->targetFile);
        }
    }
    for (const core::InputFile* file : files) {
        std::error_code absent;
        if (!file->path.empty() && fs::equivalent(file->path, path, absent)) {
            return file->path;
        }
    }
    return {};
}

}   // namespace

core::Result<RegistrationCase> loadCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe,
                                        const MovedInputs& moved)
{
    try {
        auto read = readDocument(path);
        if (!read) {
            return read.error();
        }
        CaseDocument document = std::move(read).value();
        for (core::InputFile* file : inputsOf(document)) {
            const auto place = moved.find(file->path);
            file->path = place == moved.end() ? file->path : place->second;
        }
        std::vector<CaseDocument> standing = std::move(document.views);
        auto loaded = loadInputs(std::move(document), path, warnings, observe);
        if (!loaded) {
            return loaded.error();
        }
        RegistrationCase values = std::move(loaded).value();
        loadOtherViews(values, std::move(standing), path, warnings);
        return values;
    } catch (const std::exception&) {   // a value the schema let through
        return fileError(path, says::caseWrongKind());
    }
}

core::Result<std::vector<MissingInput>> missingInputs(const std::string& casePath)
{
    try {
        auto read = readDocument(casePath);
        if (!read) {
            return read.error();
        }
        CaseDocument document = std::move(read).value();
        const RegistrationCase& values = document.values;
        std::vector<MissingInput> missing;
        for (const core::InputFile* file : inputsOf(document)) {
            const bool isNeeded =
                file == &values.centerlineFile || file == &values.imageFile || file == &values.targetFile;
            if (std::error_code failed; !fs::exists(file->path, failed)) {
                missing.push_back({file->path, file->sha256, !isNeeded});
            }
        }
        return missing;
    } catch (const std::exception&) {
        return fileError(casePath, says::caseWrongKind());
    }
}

core::Result<core::Messages> validateCase(const std::string& path)
{
    const auto text = readCaseText(path);
    if (!text) {
        return text.error();
    }
    try {
        CaseDocument document = examine(text.value());
        makePathsAbsolute(document, path);
        for (const core::InputFile* file :
             {&document.values.centerlineFile, &document.values.imageFile, &document.values.targetFile}) {
            const bool isSeries = document.values.vesselInput.kind == core::VesselInputKind::Volume &&
                                  file == &document.values.centerlineFile && fs::is_directory(file->path);
            if (file->path.empty() || isSeries) {
                continue;
            }
            if (const auto input = openInput(file->path); !input) {
                document.problems.push_back(input.error().message);
            }
        }
        return std::move(document.problems);
    } catch (const std::exception&) {
        return fileError(path, says::caseWrongKind());
    }
}

core::Result<core::Messages> doubtsOfCase(const std::string& path)
{
    const auto text = readCaseText(path);
    if (!text) {
        return text.error();
    }
    try {
        CaseDocument document = examine(text.value());
        makePathsAbsolute(document, path);
        RegistrationCase& values = document.values;
        const auto angiogram = readAngiogram(values.imageFile.path);
        if (!angiogram) {
            return angiogram.error();
        }
        fillFromHeader(values.cArm, angiogram.value().cArm);
        auto doubts = core::findContradictions(values.cArm, angiogram.value().gantry,
                                               {angiogram.value().width(), angiogram.value().height()});
        if (!values.cameraOverride && !values.hasInitialPose) {
            for (core::Message& missing : core::findMissing(values.cArm)) {
                doubts.push_back(std::move(missing));
            }
        }
        return doubts;
    } catch (const std::exception&) {
        return fileError(path, says::caseWrongKind());
    }
}

std::optional<core::Message> findUnsavable(const RegistrationCase& registrationCase)
{
    if (!registrationCase.tree && registrationCase.volume) {
        return says::caseScanAlone();
    }
    if (registrationCase.centerlineFile.path.empty() || registrationCase.imageFile.path.empty()) {
        return says::caseIncomplete();
    }
    if (!core::isRigid(registrationCase.cameraFromPatient) ||
        (registrationCase.hasInitialPose && !core::isRigid(registrationCase.initialCameraFromPatient))) {
        return says::casePoseNotRigid();
    }
    return {};
}

core::Status saveCase(const RegistrationCase& registrationCase, const std::string& path)
{
    if (const std::string input = inputAt(registrationCase, path); !input.empty()) {
        return fileError(path, says::caseIsInput());
    }
    if (const auto unsavable = findUnsavable(registrationCase)) {
        return fileError(path, *unsavable);
    }
    RegistrationCase hashed = registrationCase;
    if (auto completed = completeFiles(hashed, path); !completed) {
        return completed;
    }
    try {
        const fs::path folder = fs::weakly_canonical(fs::absolute(path).parent_path());
        return writeAtomically(path, caseDocumentText(hashed, folder));
    } catch (const std::exception&) {   // JSON is UTF-8, file names need not be
        return fileError(path, says::caseNotUtf8());
    }
}

}   // namespace angiopose::io