#include "core/vessel/smoothing_spline.h"

namespace angiopose::core {
namespace {

/// Symmetric pentadiagonal matrix of a linear system, which is solved in place for one right-hand side.
struct PentadiagonalMatrix {
    std::vector<double> diagonal;
    std::vector<double> upper1;   ///< element i is the matrix element (i, i + 1)
    std::vector<double> upper2;   ///< element i is the matrix element (i, i + 2)
};

/// Returns W + λ DᵀD, where D computes second differences.
PentadiagonalMatrix normalMatrix(const std::vector<double>& weights, double lambda)
{
    const std::size_t n = weights.size();
    PentadiagonalMatrix a{weights, std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
    for (std::size_t k = 0; k + 2 < n; ++k) {
        a.diagonal[k] += lambda;
        a.diagonal[k + 1] += 4.0 * lambda;
        a.diagonal[k + 2] += lambda;
        a.upper1[k] -= 2.0 * lambda;
        a.upper1[k + 1] -= 2.0 * lambda;
        a.upper2[k] += lambda;
    }
    return a;
}

/// Factors the matrix as L D Lᵀ row by row during forward substitution, then back-substitutes.
template <class Value>
void solveInPlace(PentadiagonalMatrix a, std::vector<Value>& x)
{
    const std::size_t n = x.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double factor1 = a.upper1[i] / a.diagonal[i];
        const double factor2 = a.upper2[i] / a.diagonal[i];
        if (i + 1 < n) {
            a.diagonal[i + 1] -= factor1 * a.upper1[i];
            a.upper1[i + 1] -= factor1 * a.upper2[i];
            x[i + 1] -= factor1 * x[i];
        }
        if (i + 2 < n) {
            a.diagonal[i + 2] -= factor2 * a.upper2[i];
            x[i + 2] -= factor2 * x[i];
        }
        x[i] /= a.diagonal[i];
        a.upper1[i] = factor1;
        a.upper2[i] = factor2;
    }
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n) {
            x[i] -= a.upper1[i] * x[i + 1];
        }
        if (i + 2 < n) {
            x[i] -= a.upper2[i] * x[i + 2];
        }
    }
}

template <class Value>
std::vector<Value> smoothedValues(const std::vector<Value>& points, const std::vector<double>& weights, double lambda)
{
    if (points.size() < 3) {
        return points;
    }
    std::vector<Value> x(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        x[i] = weights[i] * points[i];
    }
    solveInPlace(normalMatrix(weights, lambda), x);
    return x;
}

}   // namespace

std::vector<Eigen::Vector2d> smoothSpline(const std::vector<Eigen::Vector2d>& points,
                                          const std::vector<double>& weights, double lambda)
{
    return smoothedValues(points, weights, lambda);
}

std::vector<Eigen::Vector3d> smoothSpline(const std::vector<Eigen::Vector3d>& points,
                                          const std::vector<double>& weights, double lambda)
{
    return smoothedValues(points, weights, lambda);
}

std::vector<double> smoothSpline(const std::vector<double>& values, const std::vector<double>& weights, double lambda)
{
    return smoothedValues(values, weights, lambda);
}

}   // namespace angiopose::core
