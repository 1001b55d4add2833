#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

#include <string>

namespace angiopose::benchmarks {

/// True deformation of a tree. Only the fields have the form that the program assumes.
struct TrueMotion {
    enum class Form { None, Field, Waves, Breathing, Wire, Half };

    Form form = Form::None;
    double lengthMm = 0.0;   ///< for fields: correlation length; for waves: a sixth of their mean length
    double sizeMm = 0.0;   ///< for fields and waves: rms over the tree, in 3-D; for others: the maximum motion

    std::string name() const;
};

/// The tree after the motion, with the same points.
core::VesselTree deformedBy(const core::VesselTree& tree, const TrueMotion& motion, core::CounterRandom random);

}   // namespace angiopose::benchmarks
