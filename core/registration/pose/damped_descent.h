#pragma once

#include "core/registration/pose/damped_step.h"
#include "core/support/verdict.h"

#include <concepts>
#include <optional>
#include <utility>

namespace angiopose::core {

/// A least-squares problem as the descent below sees it: a Place where one can stand (a pose, or several), a Step from
/// one place to the next, and a Look, all that is measured at a place.
template <class P>
concept LeastSquaresProblem = requires(P& problem, const typename P::Place& place, typename P::Look& look,
                                       const typename P::Equations& equations, const typename P::Step& step)
{
    /// Measures; false where one cannot stand.
    {
        problem.look(place, look)
        } -> std::same_as<bool>;
    /// Normal equations for steps about the place, weights frozen; asked for only before a step is taken.
    {
        problem.equations(place, look)
        } -> std::convertible_to<typename P::Equations>;
    /// The damped step among those that are free.
    {
        problem.step(place, equations, 1e-3)
        } -> std::convertible_to<typename P::Step>;
    {
        problem.moved(place, step)
        } -> std::convertible_to<typename P::Place>;
    /// How much lower the cost is at the second look; nothing where the step is not to be taken.
    {
        problem.gained(look, look)
        } -> std::same_as<std::optional<double>>;
    /// How far the step moves the points, mm.
    {
        problem.lengthMm(place, step)
        } -> std::convertible_to<double>;
};

struct StepOptions {
    int triesPerStep = 1;   ///< each with more damping than the one before
    double settledMm = 0.0;   ///< a step that moves less settles it
    double settledGain = 0.0;   ///< so does one that promises to lower the cost by less
};

/// What became of one step. A last, tiny step may be taken and settle it.
struct StepOutcome {
    bool isTaken = false;
    bool isSettled = false;   ///< no further step is worth a try
    bool isStopped = false;   ///< who was told of it said Stop
};

/// What the descent measures at its place and at the next; outlives it, so that buffers are used again.
template <class Look>
struct LookPair {
    Look here;
    Look there;
};

/// Levenberg–Marquardt (ALGORITHMS §1): linearise, take the damped step, stand there if the problem accepts it.
template <LeastSquaresProblem Problem>
class DampedDescent {
public:
    using Place = typename Problem::Place;
    using Look = typename Problem::Look;

    DampedDescent(Problem& problem, const Place& start, LookPair<Look>& looks, const StepOptions& options)
        : problem_(problem), options_(options), looks_(looks), place_(start)
    {
        isStanding_ = problem_.look(place_, looks_.here);
    }

    const Place& place() const { return place_; }
    Look& look() { return looks_.here; }
    bool isStanding() const { return isStanding_; }   ///< false: the start is no place for this problem

    /// After the problem changed, but not what was measured; a look changed by hand counts as measured.
    void relinearize() { isLinearized_ = false; }

    /// After the problem changed: measures anew.
    void lookAgain()
    {
        isStanding_ = problem_.look(place_, looks_.here);
        relinearize();
    }

    void resetDamping() { damping_.reset(); }

    StepOutcome step();

    /// Steps until one settles it, at most `most`; `after` hears the outcome of each and may say Stop. The last
    /// outcome.
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
    LookPair<Look>& looks_;
    Place place_;
    typename Problem::Equations equations_;
    Damping damping_;
    bool isStanding_ = false;
    bool isLinearized_ = false;
};

template <LeastSquaresProblem Problem>
StepOutcome DampedDescent<Problem>::step()
{
    if (!isLinearized_) {
        equations_ = problem_.equations(place_, looks_.here);
        isLinearized_ = true;
    }
    for (int attempt = 0; attempt < options_.triesPerStep; ++attempt) {
        const typename Problem::Step step = problem_.step(place_, equations_, damping_.factor());
        const double promised = predictedDecrease(equations_, step);
        if (!(promised > 0.0)) {
            return {false, true};
        }
        const bool isTiny = promised < options_.settledGain || problem_.lengthMm(place_, step) < options_.settledMm;
        const Place trial = problem_.moved(place_, step);
        const bool isFeasible = problem_.look(trial, looks_.there);
        const auto gained = isFeasible ? problem_.gained(looks_.here, looks_.there) : std::nullopt;
        if (gained) {
            damping_.accept(*gained / promised);
            place_ = trial;
            std::swap(looks_.here, looks_.there);
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
