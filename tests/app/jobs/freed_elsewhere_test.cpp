#include "app/jobs/freed_elsewhere.h"

#include <gtest/gtest.h>
#include <QThread>
#include <QThreadPool>

namespace angiopose::app {
namespace {

/// Notes on which thread it goes.
struct Witness {
    explicit Witness(QThread*& goneOn) : goneOn_(goneOn) {}
    ~Witness() { goneOn_ = QThread::currentThread(); }
    Witness(const Witness&) = delete;
    Witness& operator=(const Witness&) = delete;

private:
    QThread*& goneOn_;
};

TEST(FreedElsewhere, GoesOnAWorkerWhenTheLastHolderLetsGo)
{
    QThread* goneOn = nullptr;
    auto held = freedElsewhere(std::make_shared<const Witness>(goneOn));
    auto also = held;
    held.reset();
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_EQ(goneOn, nullptr) << "somebody still holds it";
    also.reset();
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_NE(goneOn, nullptr);
    EXPECT_NE(goneOn, QThread::currentThread());
}

TEST(FreedElsewhere, NothingStaysNothing)
{
    EXPECT_EQ(freedElsewhere(std::shared_ptr<const Witness>()), nullptr);
}

TEST(FreedElsewhere, WhatWasReadStaysTheSame)
{
    LoadedInputs inputs;
    inputs.wholeCase.emplace();
    const auto run = std::make_shared<const core::Angiogram>();
    inputs.wholeCase->angiogram = inputs.wholeCase->storedRun = run;
    core::RegistrationCase view;
    view.angiogram = std::make_shared<const core::Angiogram>();
    const core::Angiogram* ofView = view.angiogram.get();
    inputs.wholeCase->otherViews = {{{}, std::make_shared<const core::RegistrationCase>(view)}, {}};
    const LoadedInputs freed = freedElsewhere(std::move(inputs));
    EXPECT_EQ(freed.wholeCase->angiogram, run);
    EXPECT_EQ(freed.wholeCase->storedRun, freed.wholeCase->angiogram);
    EXPECT_EQ(freed.wholeCase->otherViews[0].view->angiogram.get(), ofView);
    EXPECT_EQ(freed.wholeCase->otherViews[1].view, nullptr);
}

}   // namespace
}   // namespace angiopose::app