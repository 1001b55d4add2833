#pragma once

#include <string>

namespace angiopose::ui {

/// GLSL that draws lines in space with the same result as the painter: projected by VTK's camera, with a width on the
/// screen, mitered up to 60°, rounded at sharper turns and at the ends, with faded edges.
struct ShaderSources {
    std::string vertex;
    std::string geometry;
    std::string fragment;
};
const ShaderSources& lineShaders();

/// Returns GLSL that shows the angiogram, resampled in the same way as by the painter, with a DRR tint.
const ShaderSources& frameShaders();

}   // namespace angiopose::ui
