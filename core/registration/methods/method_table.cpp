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
          "Coarse search, then robust point-to-line refinement about the tree's centroid, with uncertainty."},
         solveAngioPose},
        {{"dynaweight", "DynaWeightPnP",
          "Alternates kernel-weighted PnP between a few auxiliary points and all points (Song, Ghaffari)."},
         solveDynaWeight},
        {{"iterative-pnp", "DynaWeightPnP*", "Kernel-weighted iterative PnP on all points (Song, Ghaffari)."},
         solveIterativePnp},
        {{"nicp", "NICP",
          "Gradient ascent of the mean kernel value between tree and traced vessels, or of the image intensity "
          "(Aylward 2003; re-implementation, our parameters)."},
         solveNicp},
        {{"nicp-alternating", "NICP*",
          "NICP inside the alternating search (Song, Ghaffari; re-implementation, our parameters)."},
         solveNicpAlternating},
        {{"dt-icp", "DT-ICP",
          "Minimum Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; re-implementation, "
          "our parameters)."},
         solveDtIcp},
        {{"assembled-icp", "Assembled ICP", "Iterative closest points with OpenCV's SQPnP solver."},
         solveAssembledIcp,
         false},
        {{"rgbr", "RGBR",
          "Edges along the normals of the vessel walls; RANSAC with gradient matching selects the pose (Markelj 2008; "
          "re-implementation, our parameters)."},
         solveRgbr},
        {{"automask", "AutoMask",
          "Rank correlation of the image with DRRs of the CTA or of tubes, Nelder–Mead (Steininger 2012; "
          "re-implementation, our parameters)."},
         solveAutoMask},
        {{"gradient-matching", "Gradient matching",
          "Vessel walls against image gradients, Powell's method (Mitrović 2013; re-implementation, our parameters)."},
         solveGradientMatching},
        {{"ogmm", "OGMM",
          "L2 distance between oriented Gaussian mixtures of tree and traced vessels (Baka 2014; re-implementation, "
          "our parameters)."},
         solveOgmm},
        {{"cvo", "CVO",
          "Gradient flow of the inner product of tree and traced vessels, represented as functions in the image "
          "(Ghaffari 2019; re-implementation, our parameters)."},
         solveCvo},
        {{"matched-branches", "Matched branches",
          "Least squares on branches matched by graph matching, followed by length-preserving vessel motion (Groher "
          "2009; re-implementation, our parameters)."},
         solveMatchedBranches},
        {{"graph-matching", "Graph matching",
          "Best-first search over sequences of matched branches, with one pose per sequence (after Zhu; "
          "re-implementation, our parameters)."},
         solveGraphMatching},
        {{"particle", "Particles",
          "Particle filter resampled by likelihood, or a sweep over the out-of-plane angles (after Tian 2022; "
          "re-implementation, our parameters)."},
         solveParticle},
        {{"evolution", "Evolution",
          "Image intensity under the vessels at the scale of each vessel, optimized by an evolution strategy (Jomier "
          "2006; re-implementation, our parameters)."},
         solveEvolution},
        {{"wire", "Guidewire or catheter",
          "For images that show only a guidewire or catheter: finds its path through the tree, and the pose near the "
          "last full registration."},
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
