#include "app/texts/case_texts.h"

#include "app/messages/messages.h"
#include "core/case/case_patients.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::app {
namespace {

void addLine(core::Messages& lines, const std::string& text)
{
    if (!text.empty()) {
        lines.push_back(core::Message::verbatim(text));
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

/// Converts a DICOM person name ("family^given") to readable text.
std::string readableName(std::string name)
{
    std::replace(name.begin(), name.end(), '^', ' ');
    return name;
}

core::Messages patientLines(const core::StudyIdentity& identity)
{
    core::Messages lines;
    addLine(lines, readableName(identity.patientName));
    addLine(lines,
            joined({identity.patientId.empty() ? "" : "ID " + identity.patientId, identity.birthDate, identity.sex},
                   " · "));
    return lines;
}

core::Messages studyLines(const core::StudyIdentity& identity, Identity shown)
{
    core::Messages lines;
    if (shown == Identity::Shown) {
        addLine(lines, identity.institution);
        addLine(lines, joined({identity.modality, identity.studyDate, identity.studyTime}, " "));
    }
    addLine(lines, joined({identity.manufacturer, identity.description}, " · "));
    return lines;
}

void addAngles(core::Messages& lines, const core::CArm& cArm)
{
    if (!cArm.primaryAngleDeg.value || !cArm.secondaryAngleDeg.value) {
        return;
    }
    const double primary = *cArm.primaryAngleDeg.value, secondary = *cArm.secondaryAngleDeg.value;
    const core::Quantity primaryDeg{std::abs(primary), 1}, secondaryDeg{std::abs(secondary), 1};
    lines.push_back(
        messages::twoParts(primary < 0.0 ? messages::angleRao(primaryDeg) : messages::angleLao(primaryDeg),
                           secondary < 0.0 ? messages::angleCau(secondaryDeg) : messages::angleCra(secondaryDeg)));
}

void addDistances(core::Messages& lines, const core::CArm& cArm)
{
    const auto& sid = cArm.sourceToDetectorMm.value;
    const auto& sod = cArm.sourceToIsocenterMm.value;
    const core::Origin sidOrigin = cArm.sourceToDetectorMm.origin, sodOrigin = cArm.sourceToIsocenterMm.origin;
    if (sid && sod && sidOrigin == sodOrigin) {
        lines.push_back(messages::sidAndSod(core::Quantity{*sid}, core::inMm(*sod, 0), originMessage(sidOrigin)));
        return;
    }
    const auto sidLine =
        sid ? std::optional(messages::sidAlone(core::inMm(*sid, 0), originMessage(sidOrigin))) : std::nullopt;
    const auto sodLine =
        sod ? std::optional(messages::sodAlone(core::inMm(*sod, 0), originMessage(sodOrigin))) : std::nullopt;
    if (sidLine && sodLine) {
        lines.push_back(messages::twoParts(*sidLine, *sodLine));
    } else if (sidLine || sodLine) {
        lines.push_back(sidLine ? *sidLine : *sodLine);
    }
}

/// Adds the pixel scale, e.g. "0.391 mm/px detector (header)", and the scale at the vessel if the depth is known.
void addPixelScale(core::Messages& lines, const core::Case& session)
{
    std::optional<core::Message> atDetector, atVessels;
    const auto& spacing = session.shown().geometry.cArm.columnSpacingMm;
    if (spacing.value) {
        atDetector =
            messages::scaleAtDetector(core::Quantity{*spacing.value, 3, "mm/px"}, originMessage(spacing.origin));
    }
    const auto camera = core::cameraOf(session.shown());
    if (camera && session.vessels.tree) {
        const double depthMm = (session.shown().cameraFromPatient * core::centroidInPatient(*session.vessels.tree)).z();
        if (depthMm > core::minProjectableDepthMm) {
            atVessels = messages::scaleAtVessels(
                core::Quantity{core::millimetersPerPixel(camera.value(), depthMm), 3, "mm/px"});
        }
    }
    if (atDetector && atVessels) {
        lines.push_back(messages::twoParts(*atDetector, *atVessels));
    } else if (atDetector || atVessels) {
        lines.push_back(atDetector ? *atDetector : *atVessels);
    }
}

}   // namespace

core::Message originMessage(core::Origin origin)
{
    switch (origin) {
        case core::Origin::Header:
            return messages::originHeader();
        case core::Origin::Derived:
            return messages::originDerived();
        case core::Origin::User:
            return messages::originUser();
        case core::Origin::Assumed:
            return messages::originAssumed();
        case core::Origin::Missing:
            break;
    }
    return messages::originMissing();
}

std::string originText(core::Origin origin)
{
    return originMessage(origin).text();
}

ui::CornerTexts toCornerTexts(const CornerLines& lines, const std::function<std::string(const core::Message&)>& toText)
{
    const auto all = [&toText](const core::Messages& messages) {
        std::vector<std::string> texts;
        for (const core::Message& message : messages) {
            texts.push_back(toText(message));
        }
        return texts;
    };
    ui::CornerTexts texts{all(lines.topLeft), all(lines.topRight), all(lines.bottomLeft), all(lines.bottomRight)};
    texts.scaleHeading = lines.scaleHeading ? toText(*lines.scaleHeading) : std::string();
    return texts;
}

ui::CornerTexts englishTexts(const CornerLines& lines)
{
    return toCornerTexts(lines, [](const core::Message& message) { return message.text(); });
}

CornerLines cornerLines(const core::Case& session, Identity identity)
{
    CornerLines lines;
    if (session.shown().angiogram) {
        const core::StudyIdentity& study = session.shown().angiogram->identity;
        lines.topLeft = identity == Identity::Shown ? patientLines(study) : core::Messages{messages::identityHidden()};
        lines.topRight = studyLines(study, identity);
    }
    if (!core::findMismatch(session).empty()) {
        const bool areSeveral = core::patientsOf(session).size() > 1;
        lines.topLeft.push_back(areSeveral ? messages::notSamePatient() : messages::notTogether());
    }
    addAngles(lines.bottomRight, core::cArmOfFrame(session.shown()));
    addDistances(lines.bottomRight, session.shown().geometry.cArm);
    addPixelScale(lines.bottomRight, session);
    return lines;
}

}   // namespace angiopose::app
