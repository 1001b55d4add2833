#include "io/dicom/projection.h"

#include "io/dicom/functional_groups.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr DicomTag placeTag = 0x00200032;

/// Returns whether a SOP class has slices: CT, MR, and volumes reconstructed from projections (vessels, head, breast).
bool isSliceClass(std::string_view sopClass)
{
    static constexpr std::array<std::string_view, 9> classes{
        "1.2.840.10008.5.1.4.1.1.2",      "1.2.840.10008.5.1.4.1.1.2.1",    "1.2.840.10008.5.1.4.1.1.2.2",
        "1.2.840.10008.5.1.4.1.1.4",      "1.2.840.10008.5.1.4.1.1.4.1",    "1.2.840.10008.5.1.4.1.1.4.4",
        "1.2.840.10008.5.1.4.1.1.13.1.1", "1.2.840.10008.5.1.4.1.1.13.1.2", "1.2.840.10008.5.1.4.1.1.13.1.3"};
    return std::ranges::find(classes, sopClass) != classes.end();
}

/// Returns whether a SOP class has projections: angiography, fluoroscopy, radiography. True if the class is absent.
bool isProjectionClass(std::string_view sopClass)
{
    return sopClass.empty() || sopClass.starts_with("1.2.840.10008.5.1.4.1.1.12.") ||
           sopClass.starts_with("1.2.840.10008.5.1.4.1.1.1.") || sopClass == "1.2.840.10008.5.1.4.1.1.1";
}

/// Returns the distinct positions of a file's frames in the patient, as written in the header.
std::set<std::string> framePositions(const DicomDataset& data)
{
    std::set<std::string> places;
    for (const DicomDataset& frame : data.items(perFrameGroupsTag)) {
        for (const DicomDataset& plane : frame.items(0x00209113)) {
            places.emplace(plane.text(placeTag));
        }
    }
    return places;
}

}   // namespace

bool isProjection(const DicomDataset& data)
{
    static constexpr std::array<std::string_view, 5> modalities{"XA", "RF", "DX", "CR", "DR"};
    const std::string_view sopClass = data.text(0x00080016);
    const bool isPlaced = data.number(placeTag) && data.number(0x00200037) && data.number(0x00280030);
    return std::ranges::find(modalities, data.text(0x00080060)) != modalities.end() && !isSliceClass(sopClass) &&
           (isProjectionClass(sopClass) || !isPlaced) && framePositions(data).size() < 2;
}

}   // namespace angiopose::io
