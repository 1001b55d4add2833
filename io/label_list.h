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

/// One label of a label image.
struct ListedLabel {
    int label = 0;
    std::string name;   ///< empty where the file gives none
    std::size_t voxels = 0;
    double volumeMl = 0.0;

    bool operator==(const ListedLabel&) const = default;
};

/// What a label image or DICOM segmentation calls its labels; empty where it names none, or is no such file.
LabelNames readLabelNames(const std::string& path);

/// The labels that occur, by number.
std::vector<ListedLabel> listedLabels(const core::LabelVolume& image, const LabelNames& names = {});

/// The labels of a label image or DICOM segmentation; nothing for a scan, which is told by its values (at once where it
/// has any below 0, as CT has), and for what is no volume.
std::optional<std::vector<ListedLabel>> labelsIn(const std::string& path, const ReadObserver& observe = {});

/// What there is to choose from in a label image: its labels, and where they lie, by their places in the list.
struct LabelOverview {
    std::vector<ListedLabel> labels;
    core::LabelRows rows;
};
core::Result<LabelOverview> readLabelOverview(const std::string& path, const ReadObserver& observe = {});

/// The labels whose names are those of arteries or of vessels in general; of veins where there are only those. Empty
/// when no name says so, or all do.
std::vector<int> vesselsByName(const std::vector<ListedLabel>& labels);

/// "4 celiac_trunk", "7" for messages; long lists are cut.
std::vector<std::string> labelTexts(const std::vector<ListedLabel>& labels);

/// Numbers of labels given as numbers or names (in any case). Fails naming what there is instead.
core::Result<std::vector<int>> labelsCalled(const std::vector<std::string>& wanted,
                                            const std::vector<ListedLabel>& labels);

}   // namespace angiopose::io