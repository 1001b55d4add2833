#pragma once

#include "io/series/slice_record.h"

#include <vector>

namespace angiopose::io {

using Slices = std::vector<SliceRecord>;

/// Whether two slices lie in the same plane.
bool isSamePosition(const SliceRecord& a, const SliceRecord& b);

/// Sorts slices by position, then by recording, then by name, independently of the order of the files.
void sortAlongNormal(Slices& slices);

/// Splits sorted slices into volumes with one slice per position, by a phase key or by repetition. Slices that cannot
/// be separated in either way stay together.
std::vector<Slices> splitVolumes(const Slices& sorted);

}   // namespace angiopose::io
