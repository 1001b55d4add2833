#pragma once

#include "io/volume/stored_volume.h"

#include <map>
#include <string>

namespace angiopose::io {

using LabelNames = std::map<int, std::string>;

/// What the header of a label image calls its labels: the segments of 3D Slicer in NRRD, the label table of Connectome
/// Workbench in NIfTI (as TotalSegmentator writes it). Empty where nothing is named.
LabelNames labelNamesOf(const StoredVolume& stored);

}   // namespace angiopose::io