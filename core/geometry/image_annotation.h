#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace angiopose::core {

enum class AnnotationKind { Arrow, Text };

/// An arrow or words that somebody drew on one frame of an image.
struct ImageAnnotation {
    AnnotationKind kind = AnnotationKind::Text;
    std::vector<Eigen::Vector2d> pixels;   ///< of an arrow its tail and its tip, of words where they begin
    std::string text;   ///< UTF-8, one line; of an arrow it may be empty
    int frame = 0;
    std::string extraKeys{};   ///< JSON object with what a case file says of it that this version does not know

    bool operator==(const ImageAnnotation&) const = default;
};

}   // namespace angiopose::core
