#include "core/registration/pose/evolution.h"

#include "core/support/random.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace angiopose::core {
namespace {

Eigen::VectorXd normalVector(Eigen::Index dimensions, CounterRandom& random)
{
    Eigen::VectorXd x(dimensions);
    for (double& value : x) {
        value = random.normal();
    }
    return x;
}

/// State of the covariance matrix adaptation; member names follow the tutorial cited in the header.
class CovarianceSearch {
public:
    CovarianceSearch(Eigen::Index dimensions, int population);

    struct Child {
        Eigen::VectorXd step;   ///< (x − mean) / sigma
        double cost = 0.0;
    };
    Eigen::VectorXd drawStep(CounterRandom& random) const
    {
        return axes_ * lengths_.cwiseProduct(normalVector(mean_.size(), random));
    }
    Eigen::VectorXd placeOf(const Eigen::VectorXd& step) const { return mean_ + sigma_ * step; }

    /// Adapts the search distribution to a generation.
    void adapt(std::vector<Child>& children);

    double width() const { return sigma_ * lengths_.maxCoeff(); }

private:
    Eigen::VectorXd mean_;
    double sigma_ = 1.0;
    Eigen::MatrixXd covariance_;
    Eigen::MatrixXd axes_;   ///< eigenvectors of the covariance
    Eigen::VectorXd lengths_;   ///< square roots of the eigenvalues of the covariance
    Eigen::VectorXd sigmaPath_;
    Eigen::VectorXd covariancePath_;
    Eigen::VectorXd weights_;   ///< recombination weights of the better half, best first
    double effective_ = 1.0;   ///< effective number of parents, μ_eff
    double cSigma_ = 0.0, dSigma_ = 0.0, cPath_ = 0.0, cOne_ = 0.0, cMu_ = 0.0;
    double expectedNorm_ = 0.0;   ///< expected length of a standard normal vector
    int generation_ = 0;
};

CovarianceSearch::CovarianceSearch(Eigen::Index dimensions, int population)
    : mean_(Eigen::VectorXd::Zero(dimensions)),
      covariance_(Eigen::MatrixXd::Identity(dimensions, dimensions)),
      axes_(covariance_),
      lengths_(Eigen::VectorXd::Ones(dimensions)),
      sigmaPath_(mean_),
      covariancePath_(mean_),
      weights_(std::max(1, population / 2))
{
    for (Eigen::Index i = 0; i < weights_.size(); ++i) {
        weights_(i) = std::log(0.5 * (population + 1.0)) - std::log(static_cast<double>(i) + 1.0);
    }
    weights_ /= weights_.sum();
    effective_ = 1.0 / weights_.squaredNorm();
    const auto n = static_cast<double>(dimensions);
    cSigma_ = (effective_ + 2.0) / (n + effective_ + 5.0);
    dSigma_ = 1.0 + 2.0 * std::max(0.0, std::sqrt((effective_ - 1.0) / (n + 1.0)) - 1.0) + cSigma_;
    cPath_ = (4.0 + effective_ / n) / (n + 4.0 + 2.0 * effective_ / n);
    cOne_ = 2.0 / ((n + 1.3) * (n + 1.3) + effective_);
    cMu_ = std::min(1.0 - cOne_, 2.0 * (effective_ - 2.0 + 1.0 / effective_) / ((n + 2.0) * (n + 2.0) + effective_));
    expectedNorm_ = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
}

void CovarianceSearch::adapt(std::vector<Child>& children)
{
    std::stable_sort(children.begin(), children.end(), [](const Child& a, const Child& b) { return a.cost < b.cost; });
    ++generation_;
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(mean_.size());
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(mean_.size(), mean_.size());
    for (Eigen::Index i = 0; i < weights_.size(); ++i) {
        const Eigen::VectorXd& step = children[static_cast<std::size_t>(i)].step;
        shift += weights_(i) * step;
        spread += weights_(i) * step * step.transpose();
    }
    mean_ += sigma_ * shift;

    const Eigen::VectorXd white = axes_ * (axes_.transpose() * shift).cwiseQuotient(lengths_);
    sigmaPath_ = (1.0 - cSigma_) * sigmaPath_ + std::sqrt(cSigma_ * (2.0 - cSigma_) * effective_) * white;
    const double pathShare = sigmaPath_.norm() / std::sqrt(1.0 - std::pow(1.0 - cSigma_, 2.0 * generation_));
    const auto n = static_cast<double>(mean_.size());
    const bool isSteady = pathShare < (1.4 + 2.0 / (n + 1.0)) * expectedNorm_;
    covariancePath_ *= 1.0 - cPath_;
    if (isSteady) {
        covariancePath_ += std::sqrt(cPath_ * (2.0 - cPath_) * effective_) * shift;
    }
    const double lost = isSteady ? 0.0 : cOne_ * cPath_ * (2.0 - cPath_);
    covariance_ = (1.0 - cOne_ - cMu_ + lost) * covariance_ + cOne_ * covariancePath_ * covariancePath_.transpose() +
                  cMu_ * spread;
    sigma_ *= std::exp(cSigma_ / dSigma_ * (sigmaPath_.norm() / expectedNorm_ - 1.0));

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance_);
    axes_ = eigen.eigenvectors();
    lengths_ = eigen.eigenvalues().cwiseMax(1e-20).cwiseSqrt();
}

}   // namespace

bool minimizeCmaEs(const EvolutionCost& cost, Eigen::Index dimensions, const EvolutionSettings& options,
                   const StopCheck& isStopped)
{
    CovarianceSearch search(dimensions, options.population);
    CounterRandom random(options.seed);
    cost(Eigen::VectorXd::Zero(dimensions));
    int evaluations = 1;
    while (evaluations + options.population <= options.maxEvaluations) {
        std::vector<CovarianceSearch::Child> children;
        for (int i = 0; i < options.population; ++i) {
            if (isStopped()) {
                return false;
            }
            const Eigen::VectorXd step = search.drawStep(random);
            children.push_back({step, cost(search.placeOf(step))});
        }
        evaluations += options.population;
        search.adapt(children);
        if (search.width() < options.minStepSize) {
            return true;
        }
    }
    return false;
}

bool minimizeOnePlusOneEs(const EvolutionCost& cost, Eigen::Index dimensions, const EvolutionSettings& options,
                          const StopCheck& isStopped)
{
    constexpr double growth = 1.05;
    const double shrinkage = std::pow(growth, -0.25);
    CounterRandom random(options.seed);
    Eigen::MatrixXd spread = Eigen::MatrixXd::Identity(dimensions, dimensions);
    Eigen::VectorXd parent = Eigen::VectorXd::Zero(dimensions);
    double parentCost = cost(parent);
    for (int i = 1; i < options.maxEvaluations && !isStopped(); ++i) {
        const Eigen::VectorXd draw = normalVector(dimensions, random);
        const Eigen::VectorXd step = spread * draw;
        const double childCost = cost(parent + step);
        const bool isBetter = childCost < parentCost;
        if (isBetter) {
            parent += step;
            parentCost = childCost;
        }
        const double factor = isBetter ? growth : shrinkage;
        spread += (factor - 1.0) / draw.squaredNorm() * step * draw.transpose();
        if (spread.norm() < options.minStepSize) {
            return true;
        }
    }
    return false;
}

}   // namespace angiopose::core
