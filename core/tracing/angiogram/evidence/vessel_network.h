#pragma once

#include "core/imaging/image2d.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace angiopose::core {

/// How likely each pixel shows what, 0…1; background is what is left of 1.
struct FrameClasses {
    ImageF vessel;
    ImageF device;   ///< catheters, wires, leads, clips, coils
};

/// A small trained network that sees vessels and devices in frames (ALGORITHMS §8.14; made by resources/network). The
/// same frame gives the same bits; one network may serve several threads.
class VesselNetwork {
public:
    /// From the bytes of an ONNX file; nothing if they are no such network.
    static std::optional<VesselNetwork> read(std::span<const std::uint8_t> onnx);

    /// Of a frame with dark vessels that is not empty, seen at a reduced size.
    FrameClasses classesOf(const ImageF& vesselsDark) const;

private:
    struct Copies;
    explicit VesselNetwork(std::shared_ptr<Copies> copies) : copies_(std::move(copies)) {}

    std::shared_ptr<Copies> copies_;   ///< one for each thread at work
};

/// The network built into the program; null where it was built without.
const VesselNetwork* trainedNetwork();

}   // namespace angiopose::core
