#include "core/registration/methods/method.h"
#include "core/registration/methods/methods.h"

#include <algorithm>
#include <vector>

namespace angiopose::core {
namespace {

/// Returns the table of all methods; the default comes first. To add a method, add a row.
const std::vector<Method>& table()
{
    static const std::vector<Method> rows{
        {{"angiopose", "AngioPose",
          "Coarse search, then robust point-to-line refinement about the tree's centroid; also estimates the pose "
          "uncertainty."},
         solveAngioPose},
        {{"dynaweight", "DynaWeightPnP",
          "Kernel-weighted PnP that alternates between a few auxiliary points and all points (Song, Ghaffari)."},
         solveDynaWeight},
        {{"iterative-pnp", "DynaWeightPnP*", "Kernel-weighted iterative PnP on all points (Song, Ghaffari)."},
         solveIterativePnp},
        {{"nicp", "NICP",
          "Gradient ascent on the mean kernel value between the tree and the traced vessels, or on the image intensity "
          "(Aylward 2003; reimplementation with our own parameters)."},
         solveNicp},
        {{"nicp-alternating", "NICP*",
          "NICP within the alternating search (Song, Ghaffari; reimplementation with our own parameters)."},
         solveNicpAlternating},
        {{"dt-icp", "DT-ICP",
          "Minimization of the Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; "
          "reimplementation with our own parameters)."},
         solveDtIcp},
        {{"assembled-icp", "Assembled ICP", "Iterative closest point (ICP) registration with OpenCV's SQPnP solver."},
         solveAssembledIcp,
         false},
        {{"rgbr", "RGBR",
          "Edge search along the vessel wall normals; RANSAC with gradient matching selects the pose (Markelj 2008; "
          "reimplementation with our own parameters)."},
         solveRgbr},
        {{"automask", "AutoMask",
          "Rank correlation of the image with DRRs of the CTA or of vessel tubes, optimized by the Nelder–Mead method "
          "(Steininger 2012; reimplementation with our own parameters)."},
         solveAutoMask},
        {{"gradient-matching", "Gradient matching",
          "Matching of vessel walls to image gradients by Powell's method (Mitrović 2013; reimplementation with our "
          "own parameters)."},
         solveGradientMatching},
        {{"ogmm", "OGMM",
          "L2 distance between oriented Gaussian mixtures of the tree and the traced vessels (Baka 2014; "
          "reimplementation with our own parameters)."},
         solveOgmm},
        {{"cvo", "CVO",
          "Gradient flow of the inner product of the tree and the traced vessels, both represented as functions in the "
          "image (Ghaffari 2019; reimplementation with our own parameters)."},
         solveCvo},
        {{"matched-branches", "Matched branches",
          "Least squares on branches matched by graph matching, followed by length-preserving vessel motion (Groher "
          "2009; reimplementation with our own parameters)."},
         solveMatchedBranches},
        {{"graph-matching", "Graph matching",
          "Best-first search over sequences of matched branches, with one pose per sequence (based on Zhu; "
          "reimplementation with our own parameters)."},
         solveGraphMatching},
        {{"particle", "Particles",
          "Particle filter with resampling by likelihood, or a sweep over the out-of-plane angles (based on Tian 2022; "
          "reimplementation with our own parameters)."},
         solveParticle},
        {{"evolution", "Evolution",
          "Image intensity along the projected vessels at the scale of each vessel, optimized by an evolution strategy "
          "(Jomier 2006; reimplementation with our own parameters)."},
         solveEvolution},
        {{"wire", "Guidewire or catheter",
          "For images that show only a guidewire or catheter: finds its path through the tree and a pose near that of "
          "the last full registration."},
         solveWire},
    };
    return rows;
}

}   // namespace

std::span<const Method> methods()
{
    return table();
}

const Method* findMethod(std::string_view id)
{
    const auto found =
        std::find_if(table().begin(), table().end(), [&](const Method& method) { return method.info.id == id; });
    return found == table().end() ? nullptr : &*found;
}

}   // namespace angiopose::core
