#pragma once

#include "angiopose/angiogram.h"
#include "angiopose/deformation.h"
#include "angiopose/geometry.h"
#include "angiopose/options.h"
#include "angiopose/registration.h"
#include "angiopose/vessel_tree.h"
#include "angiopose/volume.h"
#include "core/geometry/c_arm.h"
#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/register_views.h"
#include "core/registration/registration.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "core/tracing/volume/trace_vessels.h"
#include "core/tracing/volume/vessel_input.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

// Conversions between the public types and those of core. A round trip reproduces every number bit for bit. `toCore`
// throws Error if the lengths of arrays differ; core checks whether the values are plausible.
namespace angiopose::library {

core::RigidTransform toCore(const Pose& pose);
core::ProjectionCamera toCore(const ProjectionCamera& camera);
core::CArm toCore(const CArm& cArm);
core::VesselTree toCore(const VesselTree& tree);
core::Centerline2d toCore(const Centerline2d& centerline);
core::ImageF toCore(const Image& image);
core::Polarity toCore(Polarity polarity);
core::TraceOptions toCore(const TraceOptions& options);
core::VolumeGeometry toCore(const VolumeGeometry& geometry);
core::VesselTracingOptions toCore(const VesselTracingOptions& options);
core::RegistrationOptions toCore(const RegistrationOptions& options);
core::RegistrationInput toCore(const RegistrationInput& input);

/// Determines the kind of vessel input in a file, and how to read it.
core::VesselInput vesselInputOf(const std::string& path, const VesselReadOptions& options);

Pose toPublic(const core::RigidTransform& transform);
ProjectionCamera toPublic(const core::ProjectionCamera& camera);
CArm toPublic(const core::CArm& cArm);
VesselTree toPublic(const core::VesselTree& tree);
Centerline2d toPublic(const core::Centerline2d& centerline);
Polarity toPublic(core::Polarity polarity);
TraceOptions toPublic(const core::TraceOptions& options);
VolumeGeometry toPublic(const core::VolumeGeometry& geometry);
RegistrationOptions toPublic(const core::RegistrationOptions& options);
RegistrationInput toPublic(const core::RegistrationInput& input);
StopReason toPublic(core::StopReason reason);
DistanceMetrics toPublic(const core::DistanceMetrics& metrics);
BranchResidual toPublic(const core::BranchResidual& branch);
Hypothesis toPublic(const core::Hypothesis& hypothesis);
WirePath toPublic(const core::WirePath& path);

// These overloads take the tree of the result: the covariance refers to its centroid, the displacements to its points.
PoseUncertainty toPublic(const core::PoseUncertainty& uncertainty, const core::VesselTree& tree);
DeformedVessels toPublic(const core::DeformableResult& deformed, const core::VesselTree& tree);
RegistrationResult toPublic(const core::RegistrationResult& result, const core::VesselTree& tree);
MultiViewResult toPublic(const core::MultiViewResult& result, const core::VesselTree& tree);

template <class T>
Image2d<T> toPublic(core::Image2d<T> image)
{
    return {image.width, image.height, std::move(image.pixels)};
}

}   // namespace angiopose::library
