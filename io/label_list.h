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

/// Label that occurs in a label image, with its name and size.
struct ListedLabel {
    int label = 0;
    std::string name;   ///< empty if the file has no name for the label
    std::size_t voxels = 0;
    double volumeMl = 0.0;

    bool operator==(const ListedLabel&) const = default;
};

/// Reads the label names of a label image or DICOM segmentation; empty if it has none or is no such file.
LabelNames readLabelNames(const std::string& path);

/// Lists the labels that occur in the image, sorted by number.
std::vector<ListedLabel> listedLabels(const core::LabelVolume& image, const LabelNames& names = {});

/// Lists the labels of a label image or DICOM segmentation. Returns nullopt for a file without a volume and for a scan,
/// which is recognized by its values (immediately if one is negative, as in CT).
std::optional<std::vector<ListedLabel>> labelsIn(const std::string& path, const ReadObserver& observe = {});

/// Labels of a label image to choose from, and the voxels of each, by index in the list.
struct LabelOverview {
    std::vector<ListedLabel> labels;
    core::LabelRows rows;
};
core::Result<LabelOverview> readLabelOverview(const std::string& path, const ReadObserver& observe = {});

/// Returns the labels named after arteries or vessels in general; if there are none, those named after veins. Empty if
/// no name or every name matches.
std::vector<int> vesselsByName(const std::vector<ListedLabel>& labels);

/// Formats labels for messages, for example "4 celiac_trunk" or "7"; truncates long lists.
std::vector<std::string> labelTexts(const std::vector<ListedLabel>& labels);

/// Returns the numbers of labels that are given by number or by name (case-insensitive). The error for an unknown label
/// lists the available labels.
core::Result<std::vector<int>> labelsCalled(const std::vector<std::string>& wanted,
                                            const std::vector<ListedLabel>& labels);

}   // namespace angiopose::io
