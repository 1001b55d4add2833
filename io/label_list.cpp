#include "io/label_list.h"

#include "io/dicom/dicom_file.h"
#include "io/messages/messages.h"
#include "io/series/dicom_segmentation.h"
#include "io/support/numbers.h"
#include "io/volume/open_stored_volume.h"
#include "io/volume_file.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr std::size_t maxMentioned = 8;

template <std::size_t Count>
bool holdsAny(const std::string& name, const std::array<std::string_view, Count>& words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// Returns whether the name contains an artery term of Terminologia Anatomica or of common segmentation programs.
bool isArteryName(const std::string& name)
{
    constexpr std::array<std::string_view, 10> words{"arter", "aort",   "carotid", "coronar",   "celiac",
                                                     "trunk", "vessel", "lumen",   "subclavia", "vascul"};
    constexpr std::array<std::string_view, 7> others{"thromb", "calci", "plaque", "valve", "wall", "annulus", "sinus"};
    return holdsAny(name, words) && !holdsAny(name, others);
}

bool isVeinName(const std::string& name)
{
    constexpr std::array<std::string_view, 5> words{"vein", "vena", "venous", "cava", "portal"};
    return holdsAny(name, words);
}

template <class IsMeant>
std::vector<int> labelsWhere(const std::vector<LabelInfo>& labels, const IsMeant& isMeant)
{
    std::vector<int> found;
    for (const LabelInfo& each : labels) {
        if (isMeant(toLower(each.name))) {
            found.push_back(each.label);
        }
    }
    return found;
}

}   // namespace

LabelNames readLabelNames(const std::string& path)
{
    if (!isDicomFile(path)) {
        const auto stored = openStoredVolume(path);
        return stored ? stored.value().labelNames : LabelNames();
    }
    LabelNames names;
    const auto segments = listSegments(path);
    for (const DicomSegment& segment : segments ? segments.value() : std::vector<DicomSegment>{}) {
        names.emplace(segment.number, segment.name);
    }
    return names;
}

std::vector<LabelInfo> listLabels(const core::LabelVolume& image, const LabelNames& names)
{
    std::vector<std::size_t> counts(65536, 0);
    for (const std::uint16_t voxel : image.voxels) {
        ++counts[voxel];
    }
    const double voxelMl = image.geometry.spacingMm.prod() / 1000.0;
    std::vector<LabelInfo> labels;
    for (int label = 1; label < static_cast<int>(counts.size()); ++label) {
        if (const std::size_t voxels = counts[static_cast<std::size_t>(label)]; voxels > 0) {
            const auto name = names.find(label);
            labels.push_back({label, name == names.end() ? std::string() : name->second, voxels,
                              voxelMl * static_cast<double>(voxels)});
        }
    }
    return labels;
}

std::optional<std::vector<LabelInfo>> listLabelsOfFile(const std::string& path, const ReadObserver& observe)
{
    const bool isSegmentation = isDicomFile(path) && isDicomSegmentation(path);
    if (!isSegmentation && !isVolumeFile(path)) {
        return std::nullopt;
    }
    const auto summary = isSegmentation ? core::Result<VolumeSummary>(VolumeSummary{}) : describeVolume(path);
    const bool isSure = isSegmentation || (summary && summary.value().isDeclaredLabelMap);
    if (!isSure && !summary) {
        return std::nullopt;
    }
    const auto image = readLabels(path, observe);
    if (!image || !(isSure || looksLikeLabels(image.value()))) {
        return std::nullopt;
    }
    return listLabels(image.value(), readLabelNames(path));
}

core::Result<LabelOverview> readLabelOverview(const std::string& path, const ReadObserver& observe)
{
    const auto image = readLabels(path, observe);
    if (!image) {
        return image.error();
    }
    LabelOverview overview{listLabels(image.value(), readLabelNames(path)), {}};
    std::vector<int> numbers;
    for (const LabelInfo& each : overview.labels) {
        numbers.push_back(each.label);
    }
    overview.rows = core::compactLabels(image.value(), numbers);
    return overview;
}

std::vector<int> vesselLabelsByName(const std::vector<LabelInfo>& labels)
{
    std::vector<int> found =
        labelsWhere(labels, [](const std::string& name) { return isArteryName(name) && !isVeinName(name); });
    if (found.empty()) {
        found = labelsWhere(labels, isVeinName);
    }
    return found.size() == labels.size() ? std::vector<int>() : found;
}

std::vector<std::string> formatLabels(const std::vector<LabelInfo>& labels)
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(labels.size(), maxMentioned); ++i) {
        texts.push_back(std::to_string(labels[i].label) + (labels[i].name.empty() ? "" : " " + labels[i].name));
    }
    if (labels.size() > maxMentioned) {
        texts.emplace_back("…");
    }
    return texts;
}

core::Result<std::vector<int>> findLabels(const std::vector<std::string>& wanted, const std::vector<LabelInfo>& labels)
{
    std::vector<int> numbers;
    for (const std::string& each : wanted) {
        const auto number = parseInteger(each);
        const auto found = std::find_if(labels.begin(), labels.end(), [&](const LabelInfo& label) {
            return number ? label.label == *number : toLower(label.name) == toLower(each);
        });
        if (found == labels.end()) {
            const std::string asked = each.substr(0, 40);
            return core::Error(labels.empty() ? messages::labelsNoSuchName(asked, messages::labelsNone())
                                              : messages::labelsNoSuchName(asked, formatLabels(labels)));
        }
        numbers.push_back(found->label);
    }
    return numbers;
}

}   // namespace angiopose::io
