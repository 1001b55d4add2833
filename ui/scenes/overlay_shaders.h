#pragma once

#include <string>

namespace angiopose::ui {

/// GLSL that draws lines in space as the painter draws them on the image: projected by VTK's camera, widened on the
/// screen, mitred up to 60°, rounded beyond and at the ends, with edges that fade.
struct ShaderTexts {
    std::string vertex;
    std::string geometry;
    std::string fragment;
};
const ShaderTexts& lineShaders();

/// GLSL that shows the angiogram: resampled as the painter does, tinted by a radiograph.
const ShaderTexts& frameShaders();

}   // namespace angiopose::ui
