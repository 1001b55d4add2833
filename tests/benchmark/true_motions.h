#pragma once

#include "core/support/random.h"
#include "core/vessel/vessel_tree.h"

#include <string>

namespace angiopose::benchmarks {

/// How a tree is bent in truth. Only the fields have the form that the program assumes.
struct TrueMotion {
    enum class Form { None, Field, Waves, Breathing, Wire, Half };

    Form form = Form::None;
    double lengthMm = 0.0;   ///< of a field: its correlation length; of waves: a sixth of their mean length
    double sizeMm = 0.0;   ///< of fields and waves: rms over the tree, in space; of others: the greatest motion

    std::string name() const;
};

/// The tree after the motion; the same points.
core::VesselTree deformedBy(const core::VesselTree& tree, const TrueMotion& motion, core::CounterRandom random);

}   // namespace angiopose::benchmarks
