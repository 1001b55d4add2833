#pragma once

#include "core/registration/pose/damped_step.h"
#include "core/support/verdict.h"

#include <concepts>
#include <optional>
#include <utility>

namespace angiopose::core {

/// Requirements on a least-squares problem for the descent below: a state (one or several poses), a step from one state
/// to the next, and an evaluation, which holds all quantities computed at a state.
template <class P>
concept LeastSquaresProblem = requires(P& problem, const typename P::State& state, typename P::Evaluation& evaluation,
                                       const typename P::Equations& equations, const typename P::Step& step)
{
    /// Evaluates a state; returns false if it is not feasible.
    {
        problem.evaluate(state, evaluation)
        } -> std::same_as<bool>;
    /// Normal equations for steps about the state, weights frozen; called only before a step is taken.
    {
        problem.equations(state, evaluation)
        } -> std::convertible_to<typename P::Equations>;
    /// Damped step along the free directions.
    {
        problem.step(state, equations, 1e-3)
        } -> std::convertible_to<typename P::Step>;
    {
        problem.moved(state, step)
        } -> std::convertible_to<typename P::State>;
    /// Decrease of the cost at the second evaluation; nullopt if the step must not be taken.
    {
        problem.decrease(evaluation, evaluation)
        } -> std::same_as<std::optional<double>>;
    /// Distance by which the step moves the points, mm.
    {
        problem.lengthMm(state, step)
        } -> std::convertible_to<double>;
};

struct StepOptions {
    int triesPerStep = 1;   ///< each with more damping than the previous one
    double settledMm = 0.0;   ///< a step that moves less ends the descent
    double settledGain = 0.0;   ///< a step with a smaller predicted decrease also ends it
};

/// Result of one step. A last, tiny step may be both taken and final.
struct StepOutcome {
    bool isTaken = false;
    bool isSettled = false;   ///< no further step is worthwhile
    bool isStopped = false;   ///< the observer returned Stop
};

/// Evaluations of the descent at its current and next state; must outlive it to allow buffers to be reused.
template <class Evaluation>
struct EvaluationPair {
    Evaluation here;
    Evaluation there;
};

/// Levenberg–Marquardt (ALGORITHMS §1): linearize, compute the damped step, and accept it if the problem does.
template <LeastSquaresProblem Problem>
class DampedDescent {
public:
    using State = typename Problem::State;
    using Evaluation = typename Problem::Evaluation;

    DampedDescent(Problem& problem, const State& start, EvaluationPair<Evaluation>& evaluations,
                  const StepOptions& options)
        : problem_(problem), options_(options), evaluations_(evaluations), state_(start)
    {
        isFeasible_ = problem_.evaluate(state_, evaluations_.here);
    }

    const State& state() const { return state_; }
    Evaluation& evaluation() { return evaluations_.here; }
    bool isFeasible() const { return isFeasible_; }   ///< false: the problem cannot be evaluated at the initial state

    /// Call after the problem changed but the evaluation did not; an evaluation modified by the caller counts as
    /// current.
    void relinearize() { isLinearized_ = false; }

    /// Call after the problem changed: evaluates the state again.
    void reevaluate()
    {
        isFeasible_ = problem_.evaluate(state_, evaluations_.here);
        relinearize();
    }

    void resetDamping() { damping_.reset(); }

    StepOutcome step();

    /// Steps until convergence, at most `most` times; `after` receives the outcome of each step and may return Stop.
    /// Returns the last outcome.
    template <class After>
    StepOutcome descend(int most, const After& after)
    {
        StepOutcome outcome;
        for (int k = 0; k < most && !outcome.isSettled && !outcome.isStopped; ++k) {
            outcome = step();
            outcome.isStopped = after(outcome) == Verdict::Stop;
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
        equations_ = problem_.equations(state_, evaluations_.here);
        isLinearized_ = true;
    }
    for (int attempt = 0; attempt < options_.triesPerStep; ++attempt) {
        const typename Problem::Step step = problem_.step(state_, equations_, damping_.factor());
        const double promised = predictedDecrease(equations_, step);
        if (!(promised > 0.0)) {
            return {false, true};
        }
        const bool isTiny = promised < options_.settledGain || problem_.lengthMm(state_, step) < options_.settledMm;
        const State trial = problem_.moved(state_, step);
        const bool canEvaluate = problem_.evaluate(trial, evaluations_.there);
        const auto decrease = canEvaluate ? problem_.decrease(evaluations_.here, evaluations_.there) : std::nullopt;
        if (decrease) {
            damping_.accept(*decrease / promised);
            state_ = trial;
            std::swap(evaluations_.here, evaluations_.there);
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
