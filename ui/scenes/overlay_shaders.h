#pragma once

#include <string>

namespace angiopose::ui {

/// GLSL that draws lines in space like the painter draws them on the image: projected by VTK's camera, widened on the
/// screen, mitered up to 60°, rounded beyond that and at the ends, with faded edges.
struct ShaderTexts {
    std::string vertex;
    std::string geometry;
    std::string fragment;
};
const ShaderTexts& lineShaders();

/// GLSL that shows the angiogram: resampled like the painter does, with a DRR tint.
const ShaderTexts& frameShaders();

}   // namespace angiopose::ui
