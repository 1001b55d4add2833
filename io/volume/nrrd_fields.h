#pragma once

#include "io/volume/stored_volume.h"

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// Header fields by lower-case name.
using NrrdFields = std::map<std::string, std::string>;

/// "key: value" lines up to the first blank one; `end` is where the data begin.
NrrdFields nrrdFieldsOf(std::string_view content, std::size_t& end);

/// Value of a field; empty when absent.
std::string field(const NrrdFields& fields, const char* key);

std::string lowered(std::string_view text);
std::vector<std::string> wordsOf(const std::string& text);

/// "(1,0,0) none (0, 1,0)": one entry per axis, nothing where it says none; no value when damaged.
std::optional<std::vector<std::optional<Eigen::Vector3d>>> vectorsOf(const std::string& text);

/// The voxel type of a lower-case NRRD type name.
std::optional<VoxelType> nrrdTypeOf(const std::string& name);

}   // namespace angiopose::io