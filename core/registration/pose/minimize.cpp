#include "core/registration/pose/minimize.h"

#include <nlopt.h>
#include <limits>
#include <memory>
#include <vector>

namespace angiopose::core {
namespace {

constexpr unsigned lbfgsMemory = 8;
constexpr unsigned long powellSeed = 1;   // Brent's version takes random steps where directions become dependent

nlopt_algorithm algorithmOf(Minimizer minimizer)
{
    switch (minimizer) {
        case Minimizer::NelderMead:
            return NLOPT_LN_NELDERMEAD;
        case Minimizer::Powell:
            return NLOPT_LN_PRAXIS;
        case Minimizer::Lbfgs:
            return NLOPT_LD_LBFGS;
    }
    return NLOPT_LN_NELDERMEAD;
}

/// Callback data for NLopt. Keeps the best x, because some algorithms return the last x instead.
struct Evaluation {
    const CostFunction& cost;
    const std::function<bool()>& isStopped;
    nlopt_opt optimiser;
    Minimum best;
    Eigen::VectorXd gradient;
};

double evaluate(unsigned count, const double* x, double* gradient, void* data)
{
    auto& evaluation = *static_cast<Evaluation*>(data);
    if (nlopt_get_force_stop(evaluation.optimiser) != 0) {
        return evaluation.best.cost;   // skips the evaluation, because PRAXIS finishes its line search after a stop
    }
    const Eigen::VectorXd point = Eigen::Map<const Eigen::VectorXd>(x, count);
    evaluation.gradient.resize(gradient == nullptr ? 0 : count);
    const double cost = evaluation.cost(point, evaluation.gradient);
    if (gradient != nullptr) {
        Eigen::Map<Eigen::VectorXd>(gradient, count) = evaluation.gradient;
    }
    if (cost < evaluation.best.cost) {
        evaluation.best.x = point;
        evaluation.best.cost = cost;
    }
    if (evaluation.isStopped()) {
        nlopt_force_stop(evaluation.optimiser);
    }
    return cost;
}

}   // namespace

Minimum minimize(const CostFunction& cost, const Eigen::VectorXd& start, const MinimizeOptions& options,
                 const std::function<bool()>& isStopped)
{
    const auto count = static_cast<unsigned>(start.size());
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
        nlopt_create(algorithmOf(options.minimizer), count), &nlopt_destroy);
    Evaluation evaluation{cost, isStopped, optimiser.get(), {start, std::numeric_limits<double>::infinity()}, {}};
    nlopt_set_min_objective(optimiser.get(), &evaluate, &evaluation);
    nlopt_set_maxeval(optimiser.get(), options.maxEvaluations);
    nlopt_set_xtol_abs1(optimiser.get(), options.tolerance);
    if (options.relativeTolerance > 0.0) {
        nlopt_set_ftol_rel(optimiser.get(), options.relativeTolerance);
    }
    if (options.minimizer == Minimizer::Lbfgs) {
        nlopt_set_vector_storage(optimiser.get(), lbfgsMemory);
    } else {
        nlopt_set_initial_step1(optimiser.get(), options.firstStep);
    }
    nlopt_srand(powellSeed);
    std::vector<double> x(start.data(), start.data() + start.size());
    double last = 0.0;
    const nlopt_result ended = nlopt_optimize(optimiser.get(), x.data(), &last);
    evaluation.best.isConverged = ended > 0 && ended != NLOPT_MAXEVAL_REACHED;
    return evaluation.best;
}

}   // namespace angiopose::core
