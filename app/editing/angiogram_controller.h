#pragma once

#include "app/editing/curve_controller.h"
#include "app/editing/curve_tracing_controller.h"
#include "app/editing/opacification_controller.h"
#include "app/editing/subtraction_controller.h"

namespace angiopose::app {

/// Owns the controllers that lead from the stored run to the target curves of registration: subtraction, tracing and
/// manual editing.
class AngiogramController {
public:
    explicit AngiogramController(const AngiogramParts& parts)
        : curves_(parts), subtraction_(parts), tracing_(parts), opacification_(parts)
    {
    }

    CurveController& curves() { return curves_; }
    SubtractionController& subtraction() { return subtraction_; }

private:
    CurveController curves_;
    SubtractionController subtraction_;
    CurveTracingController tracing_;
    OpacificationController opacification_;
};

}   // namespace angiopose::app
