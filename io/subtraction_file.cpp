#include "io/subtraction_file.h"

#include "io/dicom/dicom_file.h"
#include "io/support/input_bytes.h"

namespace io {
namespace {

constexpr DicomTag maskSubtractionSequence = 0x00286100;
constexpr DicomTag maskOperation = 0x00286101;
constexpr DicomTag maskFrameNumbers = 0x00286110;
constexpr DicomTag maskSubPixelShift = 0x00286114;
constexpr DicomTag pixelIntensityRelationship = 0x00281040;

void readMask(const DicomDataset& item, core::SubtractionPlan& plan)
{
    for (std::size_t i = 0; const auto number = item.integer(maskFrameNumbers, i); ++i) {
        plan.maskFrames.push_back(*number - 1);   // DICOM counts frames from 1
    }
    const auto down = item.number(maskSubPixelShift, 0);
    const auto right = item.number(maskSubPixelShift, 1);
    if (down && right) {
        plan.maskShiftPx = Eigen::Vector2d(*right, *down);
    }
}

core::SubtractionPlan planOf(const DicomDataset& data)
{
    core::SubtractionPlan plan;
    const std::string_view relation = data.text(pixelIntensityRelationship);
    if (relation == "LOG" || relation == "DISP") {   // display values are closer to logarithms than to intensities
        plan.relation = core::PixelRelation::Logarithmic;
    }
    for (const DicomDataset& item : data.items(maskSubtractionSequence)) {
        if (item.text(maskOperation) == "AVG_SUB") {
            readMask(item, plan);
            break;
        }
    }
    return plan;
}

}   // namespace

core::Result<core::SubtractionPlan> readSubtractionPlan(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    if (!looksLikeDicom(input.value().view())) {
        return core::SubtractionPlan{};
    }
    const auto file = parseDicom(input.value().view(), path);
    return file ? core::Result<core::SubtractionPlan>(planOf(file.value().dataset)) : file.error();
}

}   // namespace io
