#include "app/texts/case_texts.h"

#include "app/texts/number_text.h"

#include <algorithm>

namespace angiopose::app {
namespace {

void addLine(std::vector<std::string>& lines, std::string text)
{
    if (!text.empty()) {
        lines.push_back(std::move(text));
    }
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator)
{
    std::string text;
    for (const std::string& part : parts) {
        if (!part.empty()) {
            text += (text.empty() ? "" : separator) + part;
        }
    }
    return text;
}

/// DICOM parts of a name ("family^given") as people write them.
std::string readableName(std::string name)
{
    std::replace(name.begin(), name.end(), '^', ' ');
    return name;
}

std::vector<std::string> patientLines(const core::StudyIdentity& identity)
{
    std::vector<std::string> lines;
    addLine(lines, readableName(identity.patientName));
    addLine(lines,
            joined({identity.patientId.empty() ? "" : "ID " + identity.patientId, identity.birthDate, identity.sex},
                   " · "));
    return lines;
}

std::vector<std::string> studyLines(const core::StudyIdentity& identity, Identity shown)
{
    std::vector<std::string> lines;
    if (shown == Identity::Shown) {
        addLine(lines, identity.institution);
        addLine(lines, joined({identity.modality, identity.studyDate, identity.studyTime}, " "));
    }
    addLine(lines, joined({identity.manufacturer, identity.description}, " · "));
    return lines;
}

std::string anglesLine(const core::CArm& cArm)
{
    if (!cArm.primaryAngleDeg.value || !cArm.secondaryAngleDeg.value) {
        return {};
    }
    return primaryAngleText(*cArm.primaryAngleDeg.value) + " · " + secondaryAngleText(*cArm.secondaryAngleDeg.value);
}

std::string distancesLine(const core::CArm& cArm)
{
    std::vector<std::string> parts;
    if (cArm.sourceToDetectorMm.value) {
        parts.push_back("SID " + fixedText(*cArm.sourceToDetectorMm.value, 0));
    }
    if (cArm.sourceToPatientMm.value) {
        parts.push_back("SOD " + fixedText(*cArm.sourceToPatientMm.value, 0));
    }
    return parts.empty() ? "" : joined(parts, " · ") + " mm (" + originText(cArm.sourceToDetectorMm.origin) + ")";
}

}   // namespace

std::string originText(core::Origin origin)
{
    switch (origin) {
        case core::Origin::Header:
            return "header";
        case core::Origin::Derived:
            return "derived";
        case core::Origin::User:
            return "user";
        case core::Origin::Assumed:
            return "assumed";
        case core::Origin::Missing:
            break;
    }
    return "missing";
}

std::string pixelScaleText(const core::RegistrationCase& registrationCase)
{
    std::vector<std::string> parts;
    const auto& spacing = registrationCase.cArm.columnSpacingMm;
    if (spacing.value) {
        parts.push_back(fixedText(*spacing.value, 3) + " mm/px detector (" + originText(spacing.origin) + ")");
    }
    const auto camera = core::cameraOf(registrationCase);
    if (camera && registrationCase.tree) {
        const double depthMm =
            (registrationCase.cameraFromPatient * core::centroidInPatient(*registrationCase.tree)).z();
        if (depthMm > core::minProjectableDepthMm) {
            parts.push_back(fixedText(core::millimetresPerPixel(camera.value(), depthMm), 3) + " mm/px at the vessels");
        }
    }
    return joined(parts, " · ");
}

ui::CornerTexts cornerTexts(const core::RegistrationCase& registrationCase, Identity identity)
{
    ui::CornerTexts texts;
    if (registrationCase.angiogram) {
        const core::StudyIdentity& study = registrationCase.angiogram->identity;
        texts.topLeft = identity == Identity::Shown ? patientLines(study) : std::vector<std::string>{"identity hidden"};
        texts.topRight = studyLines(study, identity);
    }
    addLine(texts.bottomRight, anglesLine(core::cArmOfFrame(registrationCase)));
    addLine(texts.bottomRight, distancesLine(registrationCase.cArm));
    addLine(texts.bottomRight, pixelScaleText(registrationCase));
    return texts;
}

}   // namespace angiopose::app