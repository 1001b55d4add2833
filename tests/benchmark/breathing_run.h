#pragma once

#include "core/evaluation/trial/run_record.h"
#include "core/registration/track_frames.h"

namespace angiopose::benchmarks {

/// A run in which the tree of a trial breathes, 10 mm up and down with 3° of tilt, observed with jittered points.
struct BreathingRun {
    core::RegistrationProblem first;   ///< registered in the previous frame
    std::vector<core::Centerline2d> targets;   ///< of the following frames
    std::vector<core::RigidTransform> truth;
    std::shared_ptr<const core::VesselTree> tree;

    /// Mean projection distance of a frame's pose, px.
    double errorPx(const core::RigidTransform& pose, std::size_t frame) const;
};

BreathingRun breathingRun(const core::Trial& trial, std::size_t frames);

}   // namespace angiopose::benchmarks
