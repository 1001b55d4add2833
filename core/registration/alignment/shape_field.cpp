#include "core/registration/alignment/shape_field.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr std::size_t minBlockPoints = 10;   // minimum block length, points
constexpr std::size_t typicalBlockCount = 64;   // approximate number of blocks; the cost grows with its cube
constexpr std::array<double, 7> offsetsTriedPx{0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.4};

/// Derivatives of a row with its residual appended.
template <int Parameters>
Eigen::Vector<double, Parameters + 1> derivativesAndResidual(const ResidualRow& row)
{
    Eigen::Vector<double, Parameters + 1> both;
    if constexpr (Parameters == 6) {
        both << row.gradient, row.residual;
    } else {
        both << row.gradient, row.cameraGradient, row.residual;
    }
    return both;
}

/// Sums over the rows of one block.
template <int Parameters>
struct FieldBlock {
    int branchIndex = -1;
    std::size_t count = 0;
    double information = 0.0;
    Eigen::Vector<double, Parameters + 1> rows = Eigen::Vector<double, Parameters + 1>::Zero();
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();

    void add(const ResidualRow& row, double weight)
    {
        information += weight;
        rows += weight * derivativesAndResidual<Parameters>(row);
        place += weight * row.fromCentroid;
        normal += weight * row.gradient.segment<2>(3);
    }
};

template <int Parameters>
std::vector<FieldBlock<Parameters>> blocksOf(const std::vector<ResidualRow>& rows, double rowVariance)
{
    const std::size_t length = std::max(minBlockPoints, rows.size() / typicalBlockCount);
    std::vector<FieldBlock<Parameters>> blocks;
    FieldBlock<Parameters> block;
    const auto finish = [&] {
        if (block.information > 0.0) {
            block.place /= block.information;
            block.normal.normalize();
            blocks.push_back(block);
        }
    };
    for (const ResidualRow& row : rows) {
        if (row.branchIndex != block.branchIndex || block.count == length) {
            finish();
            block = {};
            block.branchIndex = row.branchIndex;
        }
        ++block.count;
        if (row.weight > 0.0) {
            block.add(row, row.weight / rowVariance);
        }
    }
    finish();
    return blocks;
}

}   // namespace

template <int Parameters>
ShapeFieldOf<Parameters>::ShapeFieldOf(const std::vector<ResidualRow>& rows, double rowVariance)
{
    for (const ResidualRow& row : rows) {
        if (row.weight > 0.0) {
            const auto both = derivativesAndResidual<Parameters>(row);
            gram_ += row.weight / rowVariance * both * both.transpose();
        }
    }
    const std::vector<FieldBlock<Parameters>> blocks = blocksOf<Parameters>(rows, rowVariance);
    const auto count = static_cast<Eigen::Index>(blocks.size());
    blocks_.resize(count, columnCount);
    kernel_.resize(count, count);
    for (Eigen::Index a = 0; a < count; ++a) {
        const FieldBlock<Parameters>& block = blocks[static_cast<std::size_t>(a)];
        blocks_.row(a) = block.rows / std::sqrt(block.information);
        for (Eigen::Index b = 0; b <= a; ++b) {
            const FieldBlock<Parameters>& other = blocks[static_cast<std::size_t>(b)];
            const double squared = (block.place - other.place).squaredNorm() / (reachMm * reachMm);
            kernel_(a, b) = std::sqrt(block.information * other.information) * block.normal.dot(other.normal) *
                            std::exp(-0.5 * squared);
        }
    }
}

template <int Parameters>
void ShapeFieldOf<Parameters>::eliminate(double offsetPx)
{
    // With K the scaled covariance, the field absorbs (K⁻¹ + I)⁻¹ = I − (I + K)⁻¹.
    factor_ = offsetPx * offsetPx * kernel_;
    factor_.diagonal().array() += 1.0;
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> llt(factor_);
    const Blocks whitened = factor_.triangularView<Eigen::Lower>().solve(blocks_);
    reducedGram_ = gram_ - blocks_.transpose() * blocks_ + whitened.transpose() * whitened;
    logDeterminant_ = 2.0 * factor_.diagonal().array().log().sum();
}

template <int Parameters>
EquationsOf<Parameters> ShapeFieldOf<Parameters>::equations(double offsetPx)
{
    eliminate(offsetPx);
    Equations equations;
    equations.hessian = reducedGram_.template topLeftCorner<Parameters, Parameters>();
    equations.gradient = reducedGram_.template topRightCorner<Parameters, 1>();
    return equations;
}

template <int Parameters>
double ShapeFieldOf<Parameters>::logLikelihood(double offsetPx, const Equations& prior)
{
    using Square = Eigen::Matrix<double, Parameters, Parameters>;
    const Equations data = equations(offsetPx);
    const Eigen::LLT<Square> best(data.hessian + Square(prior.hessian.template selfadjointView<Eigen::Lower>()));
    const Eigen::Vector<double, Parameters> gradient = data.gradient + prior.gradient;
    const Square factor = best.matrixL();
    const double squares = reducedGram_(Parameters, Parameters) - gradient.dot(best.solve(gradient));
    return -0.5 * (logDeterminant_ + 2.0 * factor.diagonal().array().log().sum() + squares);
}

template <int Parameters>
double ShapeFieldOf<Parameters>::estimateOffsetPx(const Equations& prior)
{
    std::array<double, offsetsTriedPx.size()> likelihoods{};
    std::size_t best = 0;
    for (std::size_t k = 0; k < offsetsTriedPx.size(); ++k) {
        likelihoods[k] = logLikelihood(offsetsTriedPx[k], prior);
        if (likelihoods[k] > likelihoods[best]) {
            best = k;
        } else if (k > best + 1) {
            break;
        }
    }
    if (best == 0 || best + 1 == offsetsTriedPx.size()) {
        return offsetsTriedPx[best];
    }
    // Interpolates the maximum with a parabola through three points one octave apart.
    const double below = likelihoods[best - 1] - likelihoods[best];
    const double above = likelihoods[best + 1] - likelihoods[best];
    return offsetsTriedPx[best] * std::exp2(0.5 * (above - below) / -(above + below));
}

template class ShapeFieldOf<6>;
template class ShapeFieldOf<9>;

}   // namespace angiopose::core
