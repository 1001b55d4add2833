#pragma once

#include "core/imaging/compact_labels.h"
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
struct LabelInfo {
    int label = 0;
    std::string name;   ///< empty if the file does not name the label
    std::size_t voxels = 0;
    double volumeMl = 0.0;

    bool operator==(const LabelInfo&) const = default;
};

/// Reads the label names of a label image or DICOM segmentation; empty if the file has none or is neither.
LabelNames readLabelNames(const std::string& path);

/// Lists the labels that occur in the image, sorted by number.
std::vector<LabelInfo> listLabels(const core::LabelVolume& image, const LabelNames& names = {});

/// Lists the labels of a label image or DICOM segmentation. Returns nullopt if the file contains no volume, or a scan,
/// which is recognized by its values (at the first negative one, as in CT).
std::optional<std::vector<LabelInfo>> listLabelsOfFile(const std::string& path, const ReadObserver& observe = {});

/// Labels of a label image that the user can select, and the voxels of each label by its index in the list.
struct LabelOverview {
    std::vector<LabelInfo> labels;
    core::CompactLabels rows;
};
core::Result<LabelOverview> readLabelOverview(const std::string& path, const ReadObserver& observe = {});

/// Returns the labels named after arteries or vessels in general; if there are none, those named after veins. Empty if
/// no name matches or all names do.
std::vector<int> vesselLabelsByName(const std::vector<LabelInfo>& labels);

/// Formats labels for messages, for example "4 celiac_trunk" or "7"; truncates long lists.
std::vector<std::string> formatLabels(const std::vector<LabelInfo>& labels);

/// Returns the numbers of labels specified by number or by name (case-insensitive). The error for an unknown label
/// lists the available labels.
core::Result<std::vector<int>> findLabels(const std::vector<std::string>& wanted, const std::vector<LabelInfo>& labels);

}   // namespace angiopose::io
