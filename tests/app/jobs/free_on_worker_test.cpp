#include "app/jobs/free_on_worker.h"

#include <gtest/gtest.h>
#include <QThread>
#include <QThreadPool>

#include <atomic>

namespace angiopose::app {
namespace {

struct Witness {
    explicit Witness(std::atomic<QThread*>& goneOn) : goneOn_(goneOn) {}
    ~Witness() { goneOn_ = QThread::currentThread(); }
    Witness(const Witness&) = delete;
    Witness& operator=(const Witness&) = delete;

private:
    std::atomic<QThread*>& goneOn_;
};

TEST(FreedElsewhere, GoesOnAWorkerWhenTheLastHolderLetsGo)
{
    std::atomic<QThread*> goneOn = nullptr;
    auto held = freeOnWorker(std::make_shared<const Witness>(goneOn));
    auto also = held;
    held.reset();
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_EQ(goneOn.load(), nullptr) << "somebody still holds it";
    also.reset();
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_NE(goneOn.load(), nullptr);
    EXPECT_NE(goneOn.load(), QThread::currentThread());
}

TEST(FreedElsewhere, NothingStaysNothing)
{
    EXPECT_EQ(freeOnWorker(std::shared_ptr<const Witness>()), nullptr);
}

TEST(FreedElsewhere, WhatWasReadStaysTheSame)
{
    io::LoadedInputs inputs;
    inputs.loadedCase.emplace();
    core::Case& loadedCase = *inputs.loadedCase;
    const auto run = std::make_shared<const core::Angiogram>();
    loadedCase.shown().angiogram = loadedCase.shown().storedRun = run;
    core::View& other = loadedCase.views.emplace_back();
    other.angiogram = std::make_shared<const core::Angiogram>();
    const core::Angiogram* ofOther = other.angiogram.get();
    loadedCase.views.emplace_back();
    const io::LoadedInputs freed = freeOnWorker(std::move(inputs));
    const std::vector<core::View>& views = freed.loadedCase->views;
    EXPECT_EQ(views[0].angiogram, run);
    EXPECT_EQ(views[0].storedRun, run);
    EXPECT_EQ(views[1].angiogram.get(), ofOther);
    EXPECT_EQ(views[2].angiogram, nullptr);
}

}   // namespace
}   // namespace angiopose::app
