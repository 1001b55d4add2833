#pragma once

#include "core/simulation/scan_painter.h"

namespace angiopose::core {

inline constexpr double airHu = -1000.0;
inline constexpr double fatHu = -100.0;
inline constexpr double muscleHu = 45.0;
inline constexpr double lungHu = -850.0;
inline constexpr double cortexHu = 900.0;

/// Extent of the scanned volume in the patient.
struct ScanField {
    Eigen::Vector3d center;
    Eigen::Vector3d half;
};

ScanField fieldOf(const VolumeGeometry& geometry);

/// Paints subcutaneous fat and muscle, unbounded along the body axis.
void paintTorso(ScanPainter& painter, const ScanField& field);

/// Paints spine and ribs as cortical shells around inhomogeneous marrow.
void paintSkeleton(ScanPainter& painter, const ScanField& field, CounterRandom& random);

}   // namespace angiopose::core
