#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::core {

enum class AnnotationKind { Arrow, Text };

/// An arrow or text drawn on one frame of an image.
struct ImageAnnotation {
    AnnotationKind kind = AnnotationKind::Text;
    std::vector<Eigen::Vector2d> pixels;   ///< tail and tip of an arrow, or start of the text
    std::string text;   ///< UTF-8, one line; may be empty for an arrow
    int frame = 0;
    std::string extraKeys{};   ///< JSON object with the case-file keys that this version does not recognize

    bool operator==(const ImageAnnotation&) const = default;
};

}   // namespace angiopose::core
