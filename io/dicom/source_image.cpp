#include "io/dicom/source_image.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/new_uid.h"

#include <algorithm>
#include <array>

namespace angiopose::io {
namespace {

struct CopiedElement {
    DicomTag tag;
    const char* vr;
    bool isType2;   ///< type 2: must be present but may be empty
};

/// Elements of the Patient, General Study and Patient Study modules (PS3.3 C.7.1.1, C.7.2.1, C.7.2.2) to copy; comments
/// are not copied.
constexpr auto patientAndStudyElements = std::to_array<CopiedElement>({
    {0x00080020, "DA", true},
    {0x00080030, "TM", true},
    {0x00080050, "SH", true},
    {0x00080090, "PN", true},
    {0x00081030, "LO", false},
    {0x00100010, "PN", true},
    {0x00100020, "LO", true},
    {0x00100021, "LO", false},
    {0x00100030, "DA", true},
    {0x00100040, "CS", true},
    {0x00101010, "AS", false},
    {0x00101020, "DS", false},
    {0x00101030, "DS", false},
    {0x00200010, "SH", true},
});

constexpr auto lossyElements =
    std::to_array<CopiedElement>({{0x00282110, "CS", false}, {0x00282112, "DS", false}, {0x00282114, "CS", false}});
constexpr auto rescaleElements =
    std::to_array<CopiedElement>({{0x00281052, "DS", false}, {0x00281053, "DS", false}, {0x00281054, "LO", false}});

bool isAllDigits(std::string_view text)
{
    return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns whether the standard permits a value. Other values, which some devices write, are left empty.
bool isAllowed(const CopiedElement& element, std::string_view value)
{
    const std::string_view vr = element.vr;
    if (vr == "DA") {
        return value.size() == 8 && isAllDigits(value);
    }
    if (vr == "TM") {
        return value.size() >= 2 && isAllDigits(value.substr(0, std::min(value.find('.'), value.size())));
    }
    if (vr == "AS") {
        return value.size() == 4 && isAllDigits(value.substr(0, 3)) &&
               std::string_view("DWMY").find(value[3]) != std::string_view::npos;
    }
    if (element.tag == 0x00100040) {
        return value == "M" || value == "F" || value == "O";
    }
    return true;
}

std::string takenOver(const DicomDataset& data, const CopiedElement& element)
{
    const std::size_t most = std::string_view(element.vr) == "SH" ? 16 : 64;
    std::string value = truncateUtf8(utf8Text(data, element.tag), most);
    if (!isAllowed(element, value)) {
        value.clear();
    }
    return value;
}

template <std::size_t Count>
std::vector<SourceImage::Text> textsOf(const DicomDataset& data, const std::array<CopiedElement, Count>& elements)
{
    std::vector<SourceImage::Text> texts;
    for (const CopiedElement& element : elements) {
        std::string value = takenOver(data, element);
        if (element.isType2 || !value.empty()) {
            texts.push_back({element.tag, element.vr, std::move(value)});
        }
    }
    return texts;
}

}   // namespace

std::string SourceImage::patientText(DicomTag tag) const
{
    const auto found = std::ranges::find(patientAndStudy, tag, &Text::tag);
    return found == patientAndStudy.end() ? std::string() : found->value;
}

SourceImage sourceImageOf(const DicomDataset& data)
{
    SourceImage source;
    const auto text = [&data](DicomTag tag) { return std::string(data.text(tag)); };
    const auto uid = [&text](DicomTag tag) { return isUid(text(tag)) ? text(tag) : std::string(); };
    source.patientAndStudy = textsOf(data, patientAndStudyElements);
    source.sopClassUid = uid(0x00080016);
    source.sopInstanceUid = uid(0x00080018);
    source.studyUid = text(0x0020000d).empty() ? std::string() : validUid(text(0x0020000d));
    source.seriesUid = uid(0x0020000e);
    source.frameOfReferenceUid = uid(0x00200052);
    source.modality = text(0x00080060);
    source.laterality = text(0x00200060);
    source.rows = data.integer(0x00280010).value_or(0);
    source.columns = data.integer(0x00280011).value_or(0);
    source.frames = std::max(1, data.integer(0x00280008).value_or(1));
    source.modalityLut = textsOf(data, rescaleElements);
    if (data.text(0x00282110) == "01") {
        source.lossyCompression = textsOf(data, lossyElements);
    }
    source.isShownInverted = data.text(0x00280004) == "MONOCHROME1" || data.text(0x20500020) == "INVERSE";
    source.declaresBurnedInText = data.text(0x00280301) == "YES";
    return source;
}

core::Result<SourceImage> readSourceImage(const std::string& path)
{
    if (!isDicomFile(path)) {
        const auto there = openInputStart(path);
        SourceImage none;
        none.patientAndStudy = textsOf(DicomDataset(), patientAndStudyElements);
        return there ? core::Result<SourceImage>(std::move(none)) : there.error();
    }
    const auto input = openDicom(path);
    if (!input) {
        return input.error();
    }
    const auto file = parseDicom(input.value().view(), path);
    if (!file) {
        return file.error();
    }
    SourceImage source = sourceImageOf(file.value().dataset);
    source.isDicom = true;
    return source;
}

DicomItem addReference(DicomItem& item, DicomTag sequence, const std::string& sopClassUid,
                       const std::string& sopInstanceUid)
{
    DicomItem reference = item.addItem(sequence);
    reference.text(0x00081150, "UI", sopClassUid);
    reference.text(0x00081155, "UI", sopInstanceUid);
    return reference;
}

}   // namespace angiopose::io
