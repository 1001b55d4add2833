#include "core/tracing/smoothing_spline.h"

namespace core {
namespace {

template <class Value>
std::vector<Value> smoothedValues(const std::vector<Value>& points, const std::vector<double>& weights, double lambda)
{
    const std::size_t n = points.size();
    if (n < 3) {
        return points;
    }
    // Symmetric band matrix W + λ DᵀD with two side diagonals, factored in place as L D Lᵀ.
    std::vector<double> diagonal = weights;
    std::vector<double> upper1(n, 0.0);
    std::vector<double> upper2(n, 0.0);
    for (std::size_t k = 0; k + 2 < n; ++k) {
        diagonal[k] += lambda;
        diagonal[k + 1] += 4.0 * lambda;
        diagonal[k + 2] += lambda;
        upper1[k] -= 2.0 * lambda;
        upper1[k + 1] -= 2.0 * lambda;
        upper2[k] += lambda;
    }
    std::vector<Value> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = weights[i] * points[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double factor1 = upper1[i] / diagonal[i];
        const double factor2 = upper2[i] / diagonal[i];
        if (i + 1 < n) {
            diagonal[i + 1] -= factor1 * upper1[i];
            upper1[i + 1] -= factor1 * upper2[i];
            x[i + 1] -= factor1 * x[i];
        }
        if (i + 2 < n) {
            diagonal[i + 2] -= factor2 * upper2[i];
            x[i + 2] -= factor2 * x[i];
        }
        x[i] /= diagonal[i];
        upper1[i] = factor1;
        upper2[i] = factor2;
    }
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n) {
            x[i] -= upper1[i] * x[i + 1];
        }
        if (i + 2 < n) {
            x[i] -= upper2[i] * x[i + 2];
        }
    }
    return x;
}

}   // namespace

std::vector<Eigen::Vector2d> smoothed(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights,
                                      double lambda)
{
    return smoothedValues(points, weights, lambda);
}

std::vector<Eigen::Vector3d> smoothed(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights,
                                      double lambda)
{
    return smoothedValues(points, weights, lambda);
}

std::vector<double> smoothed(const std::vector<double>& values, const std::vector<double>& weights, double lambda)
{
    return smoothedValues(values, weights, lambda);
}

}   // namespace core
