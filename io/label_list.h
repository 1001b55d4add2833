#pragma once

#include "core/imaging/label_rows.h"
#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/volume/stored_volume.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// A label of a label image.
struct ListedLabel {
    int label = 0;
    std::string name;   ///< empty if the file names none
    std::size_t voxels = 0;
    double volumeMl = 0.0;

    bool operator==(const ListedLabel&) const = default;
};

/// Reads the label names of a label image or DICOM segmentation; empty if it has none or is no such file.
LabelNames readLabelNames(const std::string& path);

/// Lists the labels that occur, sorted by number.
std::vector<ListedLabel> listedLabels(const core::LabelVolume& image, const LabelNames& names = {});

/// Lists the labels of a label image or DICOM segmentation; nullopt for a file without a volume and for a scan, which
/// its values reveal (immediately if any is below 0, as in CT).
std::optional<std::vector<ListedLabel>> labelsIn(const std::string& path, const ReadObserver& observe = {});

/// The labels of a label image to choose from, and where each lies, by its index in the list.
struct LabelOverview {
    std::vector<ListedLabel> labels;
    core::LabelRows rows;
};
core::Result<LabelOverview> readLabelOverview(const std::string& path, const ReadObserver& observe = {});

/// Returns the labels whose names are those of arteries or of vessels in general, or those of veins if there are no
/// others. Empty if no name or every name matches.
std::vector<int> vesselsByName(const std::vector<ListedLabel>& labels);

/// Returns texts for messages, such as "4 celiac_trunk" or "7"; long lists are truncated.
std::vector<std::string> labelTexts(const std::vector<ListedLabel>& labels);

/// Returns the numbers of labels given as numbers or names (case-insensitive). Fails with a list of the available
/// labels.
core::Result<std::vector<int>> labelsCalled(const std::vector<std::string>& wanted,
                                            const std::vector<ListedLabel>& labels);

}   // namespace angiopose::io