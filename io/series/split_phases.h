#pragma once

#include "io/series/slice_record.h"

#include <vector>

namespace angiopose::io {

using Slices = std::vector<SliceRecord>;

/// True for slices that lie in one plane.
bool isSamePlace(const SliceRecord& a, const SliceRecord& b);

/// Orders slices by place, then by recording, then by name: the same for any order of files.
void sortAlongNormal(Slices& slices);

/// Sorted slices as volumes with one slice per place: told apart by a phase key, or by how often each place was
/// recorded. Slices that neither tells apart stay together.
std::vector<Slices> splitVolumes(const Slices& sorted);

}   // namespace angiopose::io