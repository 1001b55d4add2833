#include "io/subtraction_file.h"

#include "io/dicom/dicom_file.h"
#include "io/support/input_bytes.h"

namespace angiopose::io {
namespace {

constexpr DicomTag maskSubtractionSequence = 0x00286100;
constexpr DicomTag maskOperation = 0x00286101;
constexpr DicomTag applicableFrameRange = 0x00286102;
constexpr DicomTag tidOffset = 0x00286120;
constexpr DicomTag maskFrameNumbers = 0x00286110;
constexpr DicomTag maskSubPixelShift = 0x00286114;
constexpr DicomTag pixelIntensityRelationship = 0x00281040;
constexpr DicomTag recommendedViewingMode = 0x00281090;

/// Reads one item of the mask subtraction sequence; returns false if the item specifies no subtraction.
bool readMask(const DicomDataset& item, core::SubtractionPlan& plan)
{
    const std::string_view operation = item.text(maskOperation);
    const int first = item.integer(applicableFrameRange, 0).value_or(1) - 1;   // DICOM counts frames from 1
    if (operation == "TID" || operation == "REV_TID") {
        plan.interval = core::MaskInterval{item.integer(tidOffset, 0).value_or(1), std::nullopt};
        if (operation == "REV_TID") {
            plan.interval->reversedFrom = first;
        }
    } else if (operation != "AVG_SUB") {
        return false;
    }
    for (std::size_t i = 0; const auto number = item.integer(maskFrameNumbers, i); ++i) {
        plan.maskFrames.push_back(*number - 1);
    }
    const auto down = item.number(maskSubPixelShift, 0);
    const auto right = item.number(maskSubPixelShift, 1);
    if (down && right) {
        plan.maskShiftPx = Eigen::Vector2d(*right, *down);
    }
    return true;
}

core::SubtractionPlan planOf(const DicomDataset& data)
{
    core::SubtractionPlan plan;
    const std::string_view relation = data.text(pixelIntensityRelationship);
    if (relation == "LOG" || relation == "DISP") {   // display values are closer to logarithms than to intensities
        plan.relation = core::PixelRelation::Logarithmic;
    }
    for (const DicomDataset& item : data.items(maskSubtractionSequence)) {
        if (readMask(item, plan)) {
            break;
        }
    }
    return plan;
}

}   // namespace

core::Result<core::RunProcessing> readRunProcessing(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    if (!looksLikeDicom(input.value().view())) {
        return core::RunProcessing{};
    }
    const auto file = parseDicom(input.value().view(), path);
    if (!file) {
        return file.error();
    }
    const DicomDataset& data = file.value().dataset;
    core::RunProcessing processing{.plan = planOf(data)};
    processing.isSubtracted =
        (!processing.plan.maskFrames.empty() || processing.plan.interval) && data.text(recommendedViewingMode) != "NAT";
    return processing;
}

core::Result<core::SubtractionPlan> readSubtractionPlan(const std::string& path)
{
    const auto processing = readRunProcessing(path);
    return processing ? core::Result<core::SubtractionPlan>(processing.value().plan) : processing.error();
}

}   // namespace angiopose::io
