#pragma once

#include "core/registration/pose/damped_step.h"
#include "core/support/observer_decision.h"

#include <concepts>
#include <optional>
#include <utility>

namespace angiopose::core {

/// Requirements on a least-squares problem for DampedDescent: a state (one or several poses), a step between states,
/// and an evaluation with all quantities computed at a state.
template <class P>
concept LeastSquaresProblem = requires(P& problem, const typename P::State& state, typename P::Evaluation& evaluation,
                                       const typename P::Equations& equations, const typename P::Step& step)
{
    /// Evaluates a state; returns false if the state is not feasible.
    {
        problem.evaluate(state, evaluation)
        } -> std::same_as<bool>;
    /// Returns the normal equations for steps about the state, with frozen weights; called only before a step is taken.
    {
        problem.equations(state, evaluation)
        } -> std::convertible_to<typename P::Equations>;
    /// Returns the damped step along the free directions.
    {
        problem.step(state, equations, 1e-3)
        } -> std::convertible_to<typename P::Step>;
    {
        problem.retract(state, step)
        } -> std::convertible_to<typename P::State>;
    /// Returns the decrease of the cost from the first to the second evaluation; nullopt to reject the step.
    {
        problem.decrease(evaluation, evaluation)
        } -> std::same_as<std::optional<double>>;
    /// Returns the distance by which the step moves the points, mm.
    {
        problem.lengthMm(state, step)
        } -> std::convertible_to<double>;
};

struct StepOptions {
    int maxTriesPerStep = 1;   ///< attempts per step, with increasing damping
    double minMotionMm = 0.0;   ///< the descent ends at a step with less motion
    double minGain = 0.0;   ///< the descent ends at a step with a smaller predicted decrease
};

/// Outcome of one step. A tiny last step may be both accepted and final.
struct StepOutcome {
    bool isAccepted = false;
    bool isConverged = false;   ///< whether the descent has converged
    bool isStopped = false;   ///< whether the observer returned Stop
};

/// Evaluations of the descent at its current and next state; must outlive the descent, so that buffers can be reused.
template <class Evaluation>
struct EvaluationPair {
    Evaluation current;
    Evaluation next;
};

/// Levenberg–Marquardt (ALGORITHMS §1): linearizes, computes the damped step and takes it if the problem accepts it.
template <LeastSquaresProblem Problem>
class DampedDescent {
public:
    using State = typename Problem::State;
    using Evaluation = typename Problem::Evaluation;

    DampedDescent(Problem& problem, const State& start, EvaluationPair<Evaluation>& evaluations,
                  const StepOptions& options)
        : problem_(problem), options_(options), evaluations_(evaluations), state_(start)
    {
        isFeasible_ = problem_.evaluate(state_, evaluations_.current);
    }

    const State& state() const { return state_; }
    Evaluation& evaluation() { return evaluations_.current; }
    bool isFeasible() const { return isFeasible_; }   ///< false if the initial state is not feasible

    /// Discards the normal equations; call if the problem changed but the evaluation remains valid, or was modified.
    void relinearize() { isLinearized_ = false; }

    /// Evaluates the current state again; call after the problem has changed.
    void reevaluate()
    {
        isFeasible_ = problem_.evaluate(state_, evaluations_.current);
        relinearize();
    }

    void resetDamping() { damping_.reset(); }

    StepOutcome step();

    /// Takes up to `maxSteps` steps until convergence and returns the last outcome; `after` receives the outcome of
    /// each step and may return Stop.
    template <class After>
    StepOutcome descend(int maxSteps, const After& after)
    {
        StepOutcome outcome;
        for (int k = 0; k < maxSteps && !outcome.isConverged && !outcome.isStopped; ++k) {
            outcome = step();
            outcome.isStopped = after(outcome) == ObserverDecision::Stop;
        }
        return outcome;
    }

private:
    Problem& problem_;
    StepOptions options_;
    EvaluationPair<Evaluation>& evaluations_;
    State state_;
    typename Problem::Equations equations_;
    Damping damping_;
    bool isFeasible_ = false;
    bool isLinearized_ = false;
};

template <LeastSquaresProblem Problem>
StepOutcome DampedDescent<Problem>::step()
{
    if (!isLinearized_) {
        equations_ = problem_.equations(state_, evaluations_.current);
        isLinearized_ = true;
    }
    for (int attempt = 0; attempt < options_.maxTriesPerStep; ++attempt) {
        const typename Problem::Step step = problem_.step(state_, equations_, damping_.factor());
        const double predicted = predictedDecrease(equations_, step);
        if (!(predicted > 0.0)) {
            return {false, true};
        }
        const bool isTiny = predicted < options_.minGain || problem_.lengthMm(state_, step) < options_.minMotionMm;
        const State trial = problem_.retract(state_, step);
        const bool canEvaluate = problem_.evaluate(trial, evaluations_.next);
        const auto decrease = canEvaluate ? problem_.decrease(evaluations_.current, evaluations_.next) : std::nullopt;
        if (decrease) {
            damping_.accept(*decrease / predicted);
            state_ = trial;
            std::swap(evaluations_.current, evaluations_.next);
            relinearize();
            return {true, isTiny};
        }
        damping_.reject();
        if (isTiny) {
            return {false, true};
        }
    }
    return {};
}

}   // namespace angiopose::core
