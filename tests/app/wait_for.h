#pragma once

#include "tests/support/patience.h"

#include <QTest>

namespace angiopose::test {

/// Keeps the event loop running until the condition holds; false if it does not hold in time.
template <class Condition>
[[nodiscard]] bool waitFor(const Condition& holds)
{
    return QTest::qWaitFor(holds, patienceMs);
}

}   // namespace angiopose::test
